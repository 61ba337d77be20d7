// Values of quantities as they are written where they stand alone.
import { degrees } from "assur/core/angles.js";
import { isLength } from "assur/core/symbols.js";

/** From these sizes on digits after the point would only take room. */
const LARGE = 1e3;
const HUGE = 1e6;

/**
 * @param {number} value of the engine
 * @param {import("assur/engine.js").Listed["what"]} what it is of
 * @param {number} order of the derivative
 * @param {import("assur/core/words.js").Words} words
 * @returns {{ value: number, text: string }} angles in degrees
 */
export function written(value, what, order, { numbers }) {
  const angle = order === 0 && !isLength(what);
  const shown = angle ? degrees(value) : value;
  const size = Math.abs(shown);
  const text = size < HUGE ? numbers.fixed(shown, angle || size < LARGE ? 3 : 1) : numbers.brief(shown);
  return { value: shown, text: text + (angle ? "°" : "") };
}
