// Text of values outside the plots.
import { degrees } from "assur/core/angles.js";
import { isLength } from "assur/core/symbols.js";

/**
 * Limits of absolute values. Below `LARGE`, and for angles below `HUGE`, numbers have three decimals. From `LARGE` up
 * they have one, from `HUGE` up at most six digits.
 */
const LARGE = 1e3;
const HUGE = 1e6;

/**
 * @param {number} value from the engine
 * @param {import("assur/types/web.js").ListedSummary["what"]} what quantity
 * @param {number} order of the derivative
 * @param {import("assur/core/words.js").Words} words
 * @returns {{ value: number, text: string }} the value, with angles in degrees, and its text
 */
export function quantityText(value, what, order, { numbers }) {
  const angle = order === 0 && !isLength(what);
  const shown = angle ? degrees(value) : value;
  const size = Math.abs(shown);
  const text = size < HUGE ? numbers.fixed(shown, angle || size < LARGE ? 3 : 1) : numbers.brief(shown);
  return { value: shown, text: text + (angle ? "°" : "") };
}
