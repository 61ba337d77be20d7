// In which unit the numbers of a panel are written, and with how many digits.
import { degrees } from "assur/core/angles.js";

/** @typedef {import("assur/engine.js").Panel} Panel */

/** Numbers beyond these would not fit beside an axis: it is labelled in thousands, millions, thousandths … */
const LARGE = 1e5;
const SMALL = 1e-2;

/**
 * The power of ten that the numbers of a panel are written in.
 * @param {Panel} panel
 */
export function power(panel) {
  const most = Math.max(Math.abs(panel.y0), Math.abs(panel.y1));
  return inDegrees(panel) || (most < LARGE && most >= SMALL) ? 0 : 3 * Math.floor(Math.log10(most) / 3);
}

/** @param {Panel} panel */
export function inDegrees({ kind, order }) {
  return kind === "angle" && order === 0;
}

/**
 * A value of a panel as its labels say it: with four digits of what the axis spans.
 * @param {Panel} panel
 * @param {number} value
 * @param {import("assur/core/numbers.js").Numbers} numbers
 */
export function written(panel, value, numbers) {
  if (inDegrees(panel)) return `${numbers.fixed(degrees(value), 1)}°`;
  const unit = 10 ** power(panel);
  const decimals = 4 - Math.ceil(Math.log10((panel.y1 - panel.y0) / unit));
  return numbers.fixed(value / unit, Math.min(Math.max(decimals, 0), 4));
}

/**
 * @param {Panel} panel
 * @param {import("assur/state/coordinate.js").Coordinate} coordinate by which derivatives are, if not by time
 * @returns {string} the key of the words that say what a panel shows, and in which unit
 */
export function unitOf({ kind, order, physical }, coordinate) {
  const by = coordinate.moves === "angle" ? "unit" : "by_length";
  return `plots.${kind}.${order === 0 ? "unit" : physical ? "by_time" : by}.${order}`;
}

/**
 * @param {Panel} panel
 * @returns {string} before the unit, where numbers are written in a power of ten
 */
export function powerOf(panel) {
  const exponent = power(panel);
  if (exponent === 0) return "";
  const digits = String(Math.abs(exponent)).replace(/\d/g, (digit) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[Number(digit)]);
  return `10${exponent < 0 ? "⁻" : ""}${digits} `;
}
