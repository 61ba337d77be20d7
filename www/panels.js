// Where things are in a panel of the chart, from the layout the engine returns.

import { degrees } from "assur/angles.js";

/** @typedef {import("assur/engine.js").Panel} Panel */

/**
 * @param {Panel} panel
 * @param {number} phi radians
 * @returns {number} CSS pixels from the left
 */
export function across(panel, phi) {
  return panel.left + (panel.width * (phi - panel.x0)) / (panel.x1 - panel.x0);
}

/**
 * @param {Panel} panel
 * @param {number} left CSS pixels from the left
 * @returns {number} the crank angle there, radians; at the ends of the axis for what lies beyond
 */
export function angleAt(panel, left) {
  const share = Math.min(Math.max((left - panel.left) / panel.width, 0), 1);
  return panel.x0 + share * (panel.x1 - panel.x0);
}

/**
 * @param {Panel} panel
 * @param {number} value
 * @returns {number} CSS pixels from the top
 */
export function down(panel, value) {
  return panel.top + (panel.height * (panel.y1 - value)) / (panel.y1 - panel.y0);
}

/**
 * @param {Panel} panel
 * @param {number} value
 */
export function shows(panel, value) {
  return value >= panel.y0 && value <= panel.y1;
}

const STROKES = Object.freeze(["", "′", "″"]);
const LETTERS = Object.freeze({
  angle: Object.freeze(["φ", "ω", "ε"]),
  x: Object.freeze(["x", "ẋ", "ẍ"]),
  y: Object.freeze(["y", "ẏ", "ÿ"]),
});

/** The numbers of the links that are not called by them. */
const LINKS = Object.freeze(/** @type {Record<string, string>} */ ({ coupler: "2", rocker: "3" }));

/**
 * The symbol of a quantity or of its derivative, as φ₃′, ω₅, ẋ.
 * @param {string} name as `rocker.angle`, `C2.x`
 * @param {number} order
 * @param {boolean} physical whether derivatives are by time
 */
export function symbol(name, order, physical) {
  const [of, what] = name.split(".");
  const letters = LETTERS[/** @type {keyof typeof LETTERS} */ (what)];
  const numbered = of in LINKS || /^wheel\d+$/.test(of);
  const index = what === "angle" && numbered ? subscript(LINKS[of] ?? of.replace(/\D/g, "")) : "";
  const named = what === "angle" && !numbered ? ` ${of}` : "";
  return (physical ? letters[order] + index : letters[0] + index + STROKES[order]) + named;
}

/**
 * @param {string} text
 * @returns {string} the same with its digits written low
 */
export function subscript(text) {
  return text.replace(/\d/g, (digit) => String.fromCharCode(0x2080 + Number(digit)));
}

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
 * @param {import("assur/numbers.js").Numbers} numbers
 */
export function written(panel, value, numbers) {
  if (inDegrees(panel)) return `${numbers.fixed(degrees(value), 1)}°`;
  const unit = 10 ** power(panel);
  const decimals = 4 - Math.ceil(Math.log10((panel.y1 - panel.y0) / unit));
  return numbers.fixed(value / unit, Math.min(Math.max(decimals, 0), 4));
}
