// Units and digits of the numbers in a panel of the plots.
import { degrees } from "assur/core/angles.js";
import { powerOfTen } from "assur/core/numbers.js";
import { unitOfRate } from "assur/core/units.js";

/** @typedef {import("assur/types/web.js").PanelLayout} Panel */
/** @typedef {Pick<Panel, "kind" | "order" | "physical" | "y0" | "y1">} Scale scale of a panel, or of any axis */

/** Limits of an axis's largest value. Beyond them, its numbers are written with a power of ten such as 10³ or 10⁻³. */
const LARGE = 1e5;
const SMALL = 1e-2;

/**
 * Returns the exponent of the power of ten in which the numbers of a panel are written.
 * @param {Scale} panel
 */
export function power(panel) {
  const most = Math.max(Math.abs(panel.y0), Math.abs(panel.y1));
  return inDegrees(panel) || (most < LARGE && most >= SMALL) ? 0 : 3 * Math.floor(Math.log10(most) / 3);
}

/**
 * @param {Panel} panel
 * @returns {boolean} whether the panel's curves are coordinates of points
 */
export function coordinates({ series }) {
  return series.some(({ name }) => /\.[xy]$/.test(name));
}

/** @param {Pick<Panel, "kind">} panel */
function isForce({ kind }) {
  return kind === "force" || kind === "torque";
}

/** @param {Scale} panel */
export function inDegrees({ kind, order }) {
  return kind === "angle" && order === 0;
}

/**
 * Writes a value for the labels of a panel. The number of decimals gives the span of the axis four digits.
 * @param {Scale} panel
 * @param {number} value
 * @param {import("assur/core/numbers.js").Numbers} numbers
 * @param {boolean} [moving] whether the value changes with every frame, and is therefore written with fewer digits
 */
export function axisValueText(panel, value, numbers, moving = false) {
  if (inDegrees(panel)) return `${numbers.fixed(degrees(value), moving ? 0 : 1)}°`;
  const unit = 10 ** power(panel);
  const decimals = (moving ? 2 : 4) - Math.ceil(Math.log10((panel.y1 - panel.y0) / unit));
  return numbers.fixed(value / unit, Math.min(Math.max(decimals, 0), 4));
}

/**
 * Writes the constant value of a curve of a panel.
 * @param {Scale} panel
 * @param {number} value
 * @param {import("assur/core/numbers.js").Numbers} numbers
 */
export function levelText(panel, value, numbers) {
  return inDegrees(panel) ? `${numbers.upTo(degrees(value), 1)}°` : numbers.short(value / 10 ** power(panel));
}

/**
 * @param {Scale} panel
 * @param {import("assur/state/coordinate.js").Coordinate} coordinate coordinate of the driver: the variable of differentiation, unless that is time
 * @param {import("assur/core/words.js").Words} words
 * @returns {string} the power of ten and the unit of a panel's numbers, empty if they have neither
 */
export function unitOf(panel, { moves }, words) {
  if (inDegrees(panel)) return "°";
  const unit = isForce(panel) ? (words.unit && words.text(panel.kind === "force" ? "unit.newton" : "unit.newton_metre")) : unitOfRate(panel, moves, words);
  const exponent = power(panel);
  if (exponent === 0) return unit;
  return `${powerOfTen(exponent)}${unit === "1" ? "" : ` ${unit}`}`.trim();
}

/**
 * @param {Panel} panel
 * @param {import("assur/state/coordinate.js").Coordinate} coordinate
 * @param {import("assur/core/words.js").Words} words
 * @returns {string} name of the panel's quantity, with its unit
 */
export function axisTitle(panel, coordinate, words) {
  const { kind, order, physical } = panel;
  if (isForce(panel)) return words.text(`forces.plot.${kind}`, { unit: unitOf(panel, coordinate, words) });
  if (kind === "length" && order === 0 && !coordinates(panel)) return [words.text("readouts.distance"), unitOf(panel, coordinate, words)].filter(Boolean).join(", ");
  const by = order === 0 ? "value" : physical ? "by_time" : "analogue";
  return words.text(`plots.${kind}.${by}.${order}`, { unit: unitOf(panel, coordinate, words) });
}
