// The constraint equations of a linkage at the current input: both sides of each equation, and their difference.
import { degrees } from "assur/core/angles.js";
import { byId, make, setData } from "assur/core/dom.js";
import { html, nothing, render } from "assur/core/html.js";
import { called } from "assur/core/names.js";
import { attempt } from "assur/core/problem.js";
import { STROKES } from "assur/core/quantity.js";
import { Seen } from "assur/core/seen.js";

/**
 * @typedef {import("assur/kinds/linkage/rail.js").Snapshot} Snapshot
 * @typedef {import("assur/core/words.js").Words} Words
 * @typedef {import("assur/types/web.js").EquationSummary} Equation
 * a constraint, by `kind`. `distance`: a link and its points P, Q. `offset`: a sliding link, its point and the line PQ.
 * `direction`: two links at a constant angle. `mesh`: two wheels, their carrier and numbers of teeth; the second number
 * is negative if both wheels rotate in the same sense
 */

/** Keys of the names of the equations and of their first and second derivatives. */
const ORDERS = Object.freeze(["equations.places", "equations.first", "equations.second"]);
const SIDES = Object.freeze(/** @type {const} */ (["left", "right", "residual"]));
const NONE = "—";
/** `DECIMALS`: decimals of a side. `LARGE`: absolute value from which a side has six significant digits instead. */
const DECIMALS = 4;
const LARGE = 1e4;
const SUPERSCRIPTS = Object.freeze([..."⁰¹²³⁴⁵⁶⁷⁸⁹"]);

export class EquationsView {
  #engine;
  #order = make("select", { id: "equations-order", class: "control", "data-t-label": "equations.order" });
  #note = make("p", { class: "note" }, ["x", make("sub", {}, ["PQ"]), " = x", make("sub", {}, ["P"]), " − x", make("sub", {}, ["Q"])]);
  #body = make("tbody");
  #table = make("table", { class: "course" }, [this.#body]);
  #details;
  /** @type {Snapshot | null} */
  #snapshot = null;
  #written = new Seen();

  /** @param {import("assur/app/page.js").Page} page */
  constructor({ engine }) {
    this.#engine = engine;
    this.#order.append(...ORDERS.map((key, order) => make("option", { value: String(order), "data-t": key })));
    const head = ["equation", ...SIDES].map((name) => make("th", { scope: "col", "data-t": `equations.${name}` }));
    this.#table.prepend(make("thead", {}, [make("tr", {}, head)]));
    // An area that scrolls must also be reachable with the keyboard.
    const window = make("div", { class: "equations", tabindex: "0", role: "region", "data-t-label": "equations.heading" }, [this.#table]);
    this.#details = make("details", { id: "equations", "data-of": "linkage" }, [
      make("summary", { "data-t": "equations.heading" }),
      this.#order,
      this.#note,
      window,
    ]);
    for (const event of ["toggle", "change"]) this.#details.addEventListener(event, () => this.#show());
    byId("readouts", HTMLElement).after(this.#details);
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    const before = this.#snapshot;
    this.#snapshot = snapshot;
    // Numbers that change too fast to be read are not written. Another mechanism is shown at once.
    if (snapshot.numbersDue || before?.summary !== snapshot.summary || before?.words !== snapshot.words) this.#show();
  }

  /**
   * @param {string} symbol of the input
   * @param {Words} words
   */
  #name(symbol, words) {
    this.#order.dataset.n = symbol;
    for (const option of this.#order.options) option.dataset.n = symbol;
    words.fill(this.#details);
  }

  #show() {
    if (!this.#details.open || !this.#snapshot) return;
    const { summary, words, coordinate, input, stale, problems } = this.#snapshot;
    if (this.#order.dataset.n !== coordinate.symbol) this.#name(coordinate.symbol, words);
    setData(this.#table, "faded", String(stale));
    const order = Number(this.#order.value);
    this.#note.hidden = order === 0;
    if (stale || this.#written.same(summary, order, input, words, problems.length)) return;
    const { value: sides } = attempt(() => this.#engine.simulator.equations(input, order));
    render(summary.equations.map((equation, row) => html`<tr>
      <th id="equation-${row}" scope="row">${spelled(equation, order, words)}</th>
      ${SIDES.map((side, column) => {
        const value = sides?.[SIDES.length * row + column];
        return html`<td id="equation-${row}-${side}" data-value=${value ?? nothing}>${value === undefined ? NONE : valued(value, side, equation, order, words)}</td>`;
      })}</tr>`), this.#body);
  }
}

/**
 * @param {number} value
 * @param {typeof SIDES[number]} side
 * @param {Equation} equation
 * @param {number} order
 * @param {Words} words
 */
function valued(value, side, { kind }, order, words) {
  const angle = order === 0 && (kind === "direction" || kind === "mesh");
  const shown = angle ? degrees(value) : value;
  return (side === "residual" ? scientific(shown, words) : decimal(shown, words)) + (angle ? "°" : "");
}

/**
 * Makes a formula from a template string. The values of its placeholders become subscripts.
 * @param {TemplateStringsArray} texts
 * @param {readonly string[]} subscripts
 */
function formula(texts, ...subscripts) {
  return texts.map((text, i) => html`${text}${i < subscripts.length ? html`<sub>${subscripts[i]}</sub>` : nothing}`);
}

/**
 * @param {readonly string[]} names
 * @returns {string} the names: single letters side by side, as in EG, longer names separated by commas
 */
function together(...names) {
  return names.join(names.every((name) => name.length === 1) ? "" : ",");
}

/**
 * Writes out an equation or, for orders 1 and 2, its derivative.
 * @param {Equation} equation
 * @param {number} order
 * @param {Words} words
 * @returns {unknown[]}
 */
function spelled(equation, order, words) {
  const stroke = STROKES[order];
  if (equation.kind === "distance") {
    const [p, q] = equation.points;
    const pq = together(p, q);
    if (order === 0) return formula`(x${p} − x${q})² + (y${p} − y${q})² = l²${pq}`;
    const terms = [...formula`x${pq} `, `x${stroke}`, ...formula`${pq} + y${pq} `, `y${stroke}`, ...formula`${pq} = `];
    return order === 1 ? [...terms, "0"] : [...terms, ...formula`−x′²${pq} − y′²${pq}`];
  }
  if (equation.kind === "offset") {
    const [s, p, q] = equation.points;
    const [along, to] = [together(q, p), together(s, p)];
    const area = formula`x${along} y${to} − y${along} x${to}`;
    return order === 0 ? [...area, ...formula` = h·l${along}`] : ["(", ...area, `)${stroke} = 0`];
  }
  const angle = (/** @type {string} */ name) => [`θ${stroke}`, ...formula`${called(name, words)}`];
  const right = order === 0 ? " = α" : " = 0";
  if (equation.kind === "direction") return [...angle(equation.link), " − ", ...angle(equation.on), right];
  const { links, carrier, teeth } = equation;
  const turned = (/** @type {string} */ name) => ["(", ...angle(name), " − ", ...angle(carrier), ")"];
  const sign = teeth[1] < 0 ? " − " : " + ";
  return [`${teeth[0]}`, ...turned(links[0]), `${sign}${Math.abs(teeth[1])}`, ...turned(links[1]), right];
}

/**
 * @param {number} value
 * @param {Words} words
 */
function decimal(value, { numbers }) {
  return Math.abs(value) < LARGE ? numbers.fixed(value, DECIMALS) : numbers.brief(value);
}

/**
 * @param {number} value
 * @param {Words} words
 * @returns {string} such as 1.78·10⁻¹⁵
 */
function scientific(value, { numbers }) {
  if (value === 0) return "0";
  const power = Math.floor(Math.log10(Math.abs(value)));
  const digits = [...String(Math.abs(power))].map((digit) => SUPERSCRIPTS[Number(digit)]).join("");
  return `${numbers.upTo(value / 10 ** power, 2)}·10${power < 0 ? "⁻" : ""}${digits}`;
}
