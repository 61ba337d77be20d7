// Read-outs of curvature: radius and centre for paths of traced points, and the diameter of a link's inflection circle.
import { sentence } from "assur/controls/problems.js";
import { cellOf } from "assur/controls/shown.js";
import { byId, make } from "assur/core/dom.js";
import { render } from "assur/core/html.js";
import { called } from "assur/core/names.js";
import { attempt } from "assur/core/problem.js";
import { idOf } from "assur/core/quantity.js";
import { Seen } from "assur/core/seen.js";
import { subscript } from "assur/core/symbols.js";
import { BLANK, tableRow } from "assur/plots/readouts.js";
import { quantityText } from "assur/plots/values.js";

/**
 * @typedef {import("assur/core/words.js").Words} Words
 * @typedef {import("assur/types/web.js").CurvatureHere} Here
 * @typedef {import("assur/controls/readout.js").TableCell} Cell
 * @typedef {import("assur/plots/readouts.js").TableRow} Row
 */

const NONE = "—";

/** Letter, in the drawing, at the end of the diameter of the inflection circle. */
const INFLECTION_POLE = "J";

/** @type {Here} */
const NOTHING = Object.freeze({ circles: [], inflection: null });

export class Curvature {
  #engine;
  #rows;
  #body = make("tbody", { id: "curvature-readouts" });
  #shown = new Seen();

  /** @param {Pick<import("assur/app/page.js").Page, "engine" | "shown">} page */
  constructor({ engine, shown }) {
    this.#engine = engine;
    this.#rows = shown;
    byId("readouts", HTMLTableElement).append(this.#body);
  }

  /** @param {import("assur/state/model.js").Snapshot} snapshot */
  render({ state, summary, frameInput, readouts, words, stale, numbersDue, withheld }) {
    if (stale || !numbersDue) return;
    const on = state.view.curvature && "points" in summary;
    if (this.#shown.same(on, readouts, words, withheld)) return;
    const here = on ? attempt(() => this.#engine.simulator.curvature(frameInput)).value : null;
    const rows = curvatureRows(here ?? NOTHING, words, withheld);
    render(rows.map(tableRow), this.#body);
    this.#rows.put("curvature", rows);
  }
}

/**
 * @param {Here} here
 * @param {Words} words
 * @param {ReadonlySet<string>} withheld
 * @returns {readonly Row[]} rows of the table, each in the colour of its circle in the drawing
 */
function curvatureRows({ circles, inflection }, words, withheld) {
  // The subscript, the name of the point or J, distinguishes the centres of several paths, and the letters R, K, D from names of hinges.
  /** @type {(role: string, letter: string, low: string, name: string, title: string, cells: readonly Cell[]) => Row} */
  const row = (role, letter, low, name, title, cells) => ({ title: `${letter} ${title}`, letter, low, name, role, cells });
  /** @type {(quantity: string, order: number, letter: string, name: string, said: Pick<Cell, "text" | "value" | "at" | "why" | "wide">) => Cell} */
  const cell = (quantity, order, letter, name, said) =>
    cellOf(idOf(quantity, order), { title: `${idOf(letter, order)} ${name}`, ...said }, { withheld, words });
  const why = (/** @type {import("assur/core/problem.js").Problem | null} */ reason) => ({ text: reason ? sentence(reason, words) : NONE, why: true, wide: true });
  const length = (/** @type {number} */ value, order = 0) => ({ text: quantityText(value, "x", order, words).text, value });
  const rows = circles.flatMap(({ point, radius, centre, reason }) => {
    const of = subscript(point);
    const quantity = `${point}.radius`;
    const [name, centreName] = [words.text("curvature.radius"), words.text("curvature.centre")];
    const [title, centreTitle] = [`${name}, ${of}`, `${centreName}, ${of}`];
    if (!radius || !centre) return [row("accent1", "R", of, name, title, [cell(quantity, 0, "R", title, why(reason))])];
    const said = { text: `(${centre.map((way) => length(way).text).join("; ")})`, at: centre, wide: true };
    return [
      row("accent1", "R", of, name, title, radius.map((value, order) => cell(quantity, order, "R", title, length(value, order)))),
      row("accent1", "K", of, centreName, centreTitle, [cell(`${point}.centre`, 0, "K", centreTitle, said)]),
    ];
  });
  if (!inflection) return rows;
  const { link, diameter, reason } = inflection;
  const name = words.text("curvature.inflection", { of: called(link, words) });
  const own = cell(`${link}.inflection`, 0, "D", name, diameter === null ? why(reason) : length(diameter));
  return [...rows, row("accent2", "D", INFLECTION_POLE, name, name, diameter === null ? [own] : [own, BLANK, BLANK])];
}
