// Templates of read-outs.
import { html, nothing } from "assur/core/html.js";

/**
 * @typedef {import("assur/controls/shown.js").Cell} Cell
 * @typedef {Cell & Readonly<{ at?: readonly [number, number], why?: boolean }>} TableCell
 * `at`: coordinates in the text. `why`: whether the text is the reason for a missing value
 */

/** Number of columns of a cell that spans them all. */
const WIDE = 3;

/**
 * @param {Pick<Cell, "text" | "asked">} cell
 * @returns the text, followed by a text for screen readers if a lesson withholds the read-out
 */
export function readoutText({ text, asked }) {
  return asked === undefined ? text : html`${text}<span class="unseen"> ${asked}</span>`;
}

/**
 * @param {TableCell} cell
 * @returns template of a cell of a table
 */
export function readoutCell(cell) {
  const { id, wide, value, asked, at, why } = cell;
  return html`<td id=${id || nothing} class=${why ? "why" : nothing} colspan=${wide ? WIDE : nothing} data-value=${value ?? nothing} data-asked=${asked ?? nothing} data-x=${at?.[0] ?? nothing} data-y=${at?.[1] ?? nothing}>${readoutText(cell)}</td>`;
}
