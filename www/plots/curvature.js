// Read-outs of curvature: radius and centre for paths of traced points, and the diameter of a link's inflection circle.
import { sentence } from "assur/controls/problems.js";
import { writeReadout } from "assur/controls/readout.js";
import { byId, make } from "assur/core/dom.js";
import { called } from "assur/core/names.js";
import { attempt } from "assur/core/problem.js";
import { Seen } from "assur/core/seen.js";
import { readoutOf, subscript } from "assur/core/symbols.js";
import { row } from "assur/plots/readouts.js";
import { quantityText } from "assur/plots/values.js";

/**
 * @typedef {import("assur/core/words.js").Words} Words
 * @typedef {import("assur/types/web.js").CurvatureHere} Here
 */

/** Orders of the derivatives, one for each column of values. */
const ORDERS = Object.freeze([0, 1, 2]);
const NONE = "—";

/** Letter of the end of the diameter in the drawing. */
const INFLECTION_POLE = "J";

/** @type {Here} */
const NOTHING = Object.freeze({ circles: [], inflection: null });

export class Curvature {
  #engine;
  #body = make("tbody", { id: "curvature-readouts" });
  #shown = new Seen();

  /** @param {import("assur/app/page.js").Page} page */
  constructor({ engine }) {
    this.#engine = engine;
    byId("readouts", HTMLTableElement).append(this.#body);
  }

  /** @param {import("assur/state/model.js").Snapshot} snapshot */
  render({ state, summary, frameInput, readouts, words, stale, numbersDue }) {
    if (stale || !numbersDue) return;
    const on = state.view.curvature && "points" in summary;
    if (this.#shown.same(on, readouts, words)) return;
    if (!on) {
      this.#body.replaceChildren();
      return;
    }
    const { value } = attempt(() => this.#engine.simulator.curvature(frameInput));
    this.#body.replaceChildren(...rows(value ?? NOTHING, words));
  }
}

/**
 * @param {Here} here
 * @param {Words} words
 * @returns {readonly HTMLElement[]} rows of the table, each in the colour of its circle in the drawing
 */
function rows({ circles, inflection }, words) {
  // The subscript distinguishes the centres of several paths, and the letters from those of hinges.
  const title = (/** @type {string} */ letter, /** @type {string} */ low, /** @type {string} */ text) =>
    [make("b", {}, [letter, make("sub", {}, [low])]), " ", make("span", {}, [text])];
  const said = circles.flatMap(({ point, radius, centre, reason }) => {
    const of = subscript(point);
    const own = title("R", of, words.text("curvature.radius"));
    if (!radius || !centre) return [row("accent1", false, own, [why(`out-${point}.radius`, reason, words)])];
    const values = ORDERS.map((order) => cell(`out-${readoutOf(`${point}.radius`, order)}`, radius[order], order, words));
    const centreCell = make("td", { id: `out-${point}.centre`, colspan: "3", "data-x": String(centre[0]), "data-y": String(centre[1]) });
    centreCell.append(`(${centre.map((way) => quantityText(way, "x", 0, words).text).join("; ")})`);
    return [row("accent1", false, own, values), row("accent1", false, title("K", of, words.text("curvature.centre")), [centreCell])];
  });
  if (!inflection) return said;
  const { link, diameter, reason } = inflection;
  const id = `out-${link}.inflection`;
  const cells = diameter === null ? [why(id, reason, words)] : [cell(id, diameter, 0, words), make("td"), make("td")];
  return [...said, row("accent2", false, title("D", INFLECTION_POLE, words.text("curvature.inflection", { of: called(link, words) })), cells)];
}

/**
 * @param {string} id
 * @param {number} value a length, or its derivative
 * @param {number} order
 * @param {Words} words
 */
function cell(id, value, order, words) {
  const made = make("td", { id });
  writeReadout(made, quantityText(value, "x", order, words).text, value);
  return made;
}

/**
 * @param {string} id
 * @param {import("assur/core/problem.js").Problem | null} reason reason for a missing value
 * @param {Words} words
 */
function why(id, reason, words) {
  return make("td", { id, class: "why", colspan: "3" }, [reason ? sentence(reason, words) : NONE]);
}
