// Table of the six linear equations for the velocity and acceleration analogues of E, G and C (first and second
// derivatives of their coordinates with respect to the input): numerical coefficients and solution.
import { make, write } from "assur/core/dom.js";
import { attempt } from "assur/core/problem.js";
import { STROKES } from "assur/core/quantity.js";
import { withSubscripts } from "assur/core/subscripts.js";

/**
 * @typedef {import("assur/lesson/panel.js").Figure} Figure
 * @typedef {import("assur/state/model.js").AnySnapshot} Snapshot
 */

/** `LINKS`: links that give the equations. `UNKNOWNS`: unknowns of the equations. `ORDERS`: marks of derivatives. */
const LINKS = Object.freeze(["EB", "EG", "GH", "FK", "LC", "CD"]);
const UNKNOWNS = Object.freeze(["x_E", "y_E", "x_G", "y_G", "x_C", "y_C"]);
const ORDERS = STROKES.slice(1);
/** Items of the paper that contain the solution, by order of the derivative and by point: E, G, C. */
const SOLVED = Object.freeze([["003.vE", "003.cramer1", "003.vC"], ["003.aE", "003.cramer2", "003.aC"]]);
const DECIMALS = 3;

/** @implements {Figure} */
export class System {
  #engine;
  #caption = make("caption");
  element = make("table", { class: "course lesson-matrix" }, [this.#caption]);

  /** @param {Pick<import("assur/engine.js").Engine, "simulator">} engine */
  constructor(engine) {
    this.#engine = engine;
  }

  /**
   * @param {Snapshot} snapshot
   * @param {import("assur/core/words.js").Words} words
   */
  render({ input, stale }, words) {
    write(this.#caption, words.text("derivatives.figure.system"));
    if (stale) return;
    const relations = attempt(() => this.#engine.simulator.relations(input)).value ?? [];
    const values = new Map(relations.map(({ item, name, value }) => [`${item} ${name}`, value]));
    const number = (/** @type {string} */ key) => {
      const value = values.get(key);
      return value === undefined ? "—" : value === 0 ? "0" : words.numbers.fixed(value, DECIMALS);
    };
    const matrix = LINKS.map((link) => row(link, UNKNOWNS.map((name) => number(`003.${link} ${name}`))));
    const right = ORDERS.map((order) => row(`r${order}`, LINKS.map((link) => number(`003.${link} ${order}`))));
    const solved = ORDERS.map((order, k) => row(`q${order}`, UNKNOWNS.map((name, i) => number(`${SOLVED[k][i >> 1]} ${name.replace("_", `${order}_`)}`))));
    this.element.replaceChildren(this.#caption, part("J", UNKNOWNS, matrix), part("r", LINKS, right), part("q", UNKNOWNS, solved));
  }
}

/**
 * @param {string} name
 * @param {readonly string[]} columns
 * @param {readonly HTMLElement[]} rows
 */
function part(name, columns, rows) {
  const heads = [name, ...columns].map((one) => make("th", { scope: "col" }, withSubscripts(one)));
  return make("tbody", {}, [make("tr", {}, heads), ...rows]);
}

/**
 * @param {string} head
 * @param {readonly string[]} cells
 */
function row(head, cells) {
  return make("tr", {}, [make("th", { scope: "row" }, [head]), ...cells.map((cell) => make("td", {}, [cell]))]);
}
