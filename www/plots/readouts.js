// Table of the current input and quantities. The colours of its rows serve as the legend of the drawing and the plots.
import { readoutCell } from "assur/controls/readout.js";
import { cellOf, idOfOutput } from "assur/controls/shown.js";
import { byId, setData } from "assur/core/dom.js";
import { html, nothing, render } from "assur/core/html.js";
import { called } from "assur/core/names.js";
import { STROKES, idOf } from "assur/core/quantity.js";
import { MEASURES, calledWhole, isLength, letterOf, subscript } from "assur/core/symbols.js";
import { quantityText } from "assur/plots/values.js";

/**
 * @typedef {import("assur/state/model.js").Snapshot} Snapshot
 * @typedef {import("assur/types/web.js").ListedSummary} Listed
 * @typedef {import("assur/core/words.js").Words} Words
 * @typedef {import("assur/controls/shown.js").Cell} Cell
 * @typedef {Omit<import("assur/controls/shown.js").Row, "cells"> & Readonly<{ cells: readonly import("assur/controls/readout.js").TableCell[], letter: string, low?: string, name: string, role?: string, curve?: boolean }>} TableRow
 * `letter`, `name`: the two parts of the title. `low`: subscript of the letter. `role`: of the row's colour; a row without one belongs to the row above it.
 * `curve`: whether the quantity is plotted.
 */

const NONE = "—";

/** A cell without a value. */
export const BLANK = Object.freeze({ id: "", title: "", text: "" });

/** Quantities whose derivatives are not in the table. */
const BARE = Object.freeze(["transmission", "pressure"]);

export class ReadoutTable {
  #table = byId("readouts", HTMLTableElement);
  #shown;

  /** @param {Pick<import("assur/app/page.js").Page, "shown">} page */
  constructor({ shown }) {
    this.#shown = shown;
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    const { summary, stale, numbersDue } = snapshot;
    setData(this.#table, "faded", String(stale));
    if (!numbersDue) return;
    const heads = headsOf(snapshot);
    const rows = [inputRow(snapshot), ...summary.listed.flatMap((listed) => quantityRows(listed, snapshot))];
    render(html`<tr><td></td>${heads.cells.map(({ text }) => (text === "" ? html`<td></td>` : html`<th scope="col">${text}</th>`))}</tr>`, this.#table.createTHead());
    render(rows.map(tableRow), this.#table.tBodies[0]);
    this.#shown.put("values", [heads, ...rows]);
  }
}

/**
 * @param {Snapshot} snapshot
 * @returns {boolean} whether derivatives are with respect to time
 */
function isPhysical({ state: { view }, coordinate }) {
  return view.axes === "physical" || coordinate.moves === "time";
}

/**
 * @param {Snapshot} snapshot
 * @returns {import("assur/controls/shown.js").Row} heads of the columns: the symbols of the listed quantities, by order of the derivative
 */
function headsOf(snapshot) {
  const found = (/** @type {string[]} */ ...sorts) => sorts.filter((one) => snapshot.summary.listed.some(({ what }) => what === one));
  const usual = found("angle", "load_angle", "x", "y");
  // Measures have letters of their own, which are in the heads only if no other quantities are listed.
  const sorts = usual.length > 0 ? usual : found(...MEASURES);
  const symbols = (/** @type {number} */ order) => sorts.map((sort) => letterOf({ name: `.${sort}` }, order, isPhysical(snapshot))).join(", ");
  return { title: "", cells: STROKES.map((_, order) => ({ ...BLANK, text: symbols(order) })) };
}

/**
 * @param {Snapshot} snapshot
 * @returns {TableRow} row of the input, which no lesson withholds
 */
function inputRow({ state, coordinate, inputShown, words }) {
  const [letter, name] = [coordinate.symbol, words.text(`readouts.input.${coordinate.moves}`)];
  const title = `${letter} ${name}`;
  const text = coordinate.written(inputShown, words, state.view.playing ? 1 : 3);
  return { title, letter, name, role: "crank", cells: [{ id: idOfOutput("input"), title, text, value: inputShown }, BLANK, BLANK] };
}

/**
 * @param {Listed} listed
 * @param {Snapshot} snapshot
 * @returns {TableRow[]} the row of the quantity and, if mechanism Ⓐ is shown, a row of Ⓐ and one of the difference; Ⓑ is the current mechanism
 */
function quantityRows(listed, snapshot) {
  const { readouts, compared, compares, summary: { curves }, words } = snapshot;
  const { name: quantity, what, role } = listed;
  const name = ofRow(listed, words);
  const letter = letterOf(listed, 0, false);
  /** @type {(value: (order: number) => number | undefined, cell: (reading: string, said: Omit<Cell, "id">) => Cell) => Cell[]} */
  const cells = (value, cell) => STROKES.map((_, order) => {
    if (order > 0 && BARE.includes(what)) return BLANK;
    const known = value(order);
    const said = known === undefined ? { text: NONE } : quantityText(known, what, order, words);
    return cell(idOf(quantity, order), { title: `${letterOf(listed, order, isPhysical(snapshot))} ${name}`, ...said });
  });
  const [a, b] = [compared?.readouts, readouts].map((of) => (/** @type {number} */ order) => of?.value(quantity, order));
  const own = cells(b, (reading, said) => cellOf(reading, said, snapshot));
  const row = { title: `${letter} ${name}`, letter, name, role, curve: curves.includes(quantity), cells: own };
  if (!compares) return [row];
  // The difference from Ⓐ would give a withheld value away.
  const difference = cells((order) => differenceOf(what, order, a(order), b(order)), (reading, said) => cellOf(reading, { id: `difference-${reading}`, ...said }, snapshot));
  return [
    row,
    { title: "Ⓐ", letter: "", name: "Ⓐ", cells: cells(a, (reading, said) => ({ id: `a-${reading}`, ...said })) },
    { title: "Ⓑ − Ⓐ", letter: "", name: "Ⓑ − Ⓐ", cells: difference },
  ];
}

/** @param {TableRow} row */
export function tableRow({ letter, low, name, role, curve, cells }) {
  const swatch = role ? html`<i class=${curve ? "swatch curve" : "swatch"} aria-hidden="true"></i>` : nothing;
  const title = html`${swatch}<b>${letter}${low === undefined ? nothing : html`<sub>${low}</sub>`}</b> <span>${name}</span>`;
  return html`<tr class=${role ? nothing : "beside"}><th scope="row" .style=${role ? `--accent: var(--role-${role})` : ""}>${title}</th>${cells.map(readoutCell)}</tr>`;
}

/**
 * @param {Listed["what"]} what quantity of the two values
 * @param {number} order of the derivative
 * @param {number | undefined} a
 * @param {number | undefined} b
 * @returns {number | undefined} b − a, for angles reduced to −π … π; undefined if a value is missing
 */
export function differenceOf(what, order, a, b) {
  if (a === undefined || b === undefined) return undefined;
  return order === 0 && !isLength(what) ? turned(b - a) : b - a;
}

/**
 * @param {number} angle in radians
 * @returns {number} the angle less whole turns, from −π to π
 */
function turned(angle) {
  return angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));
}

/**
 * @param {Listed} listed
 * @param {Words} words
 * @returns {string} text of a row after its letter; for a load angle Δ, only the name of the link
 */
export function ofRow(listed, words) {
  return listed.what === "load_angle" ? called(listed.of[0], words) : whose(listed, words);
}

/**
 * @param {Pick<Listed, "what" | "of">} listed
 * @param {Words} words
 * @returns {string} name of the quantity's link or point; except for angles of links and for coordinates, also the name of the quantity
 */
export function whose({ what, of }, words) {
  if (what === "angle") return of.map((link) => called(link, words)).join(", ");
  if (what === "load_angle") return words.text("readouts.load_angle", { name: called(of[0], words) });
  if (MEASURES.includes(what)) return `${words.text(`readouts.${what}`)} ${calledWhole(of.join("-"), what, words)}`;
  const point = subscript(of[0]);
  if (what === "transmission") return `${words.text("readouts.transmission")} ${point}`;
  return what === "pressure" ? `${words.text("readouts.pressure")} ${point}` : point;
}
