// Plot of one quantity against another: its text, its cursor, and the input of the point on the curve under a pointer.
import { cheapest, covered } from "assur/canvas/boxes.js";
import { textWidth } from "assur/canvas/text-width.js";
import { idOf } from "assur/core/quantity.js";
import { subscript, symbol } from "assur/core/symbols.js";
import { paintTag } from "assur/plots/tags.js";
import { setChartFont } from "assur/plots/text.js";
import { axisValueText, inDegrees, power, unitOf } from "assur/plots/units.js";

/**
 * @typedef {import("assur/types/web.js").AgainstLayout} XyPlot
 * @typedef {import("assur/types/web.js").AxisLayout} Axis
 * @typedef {import("assur/canvas/theme.js").Theme} Theme
 * @typedef {import("assur/state/model.js").Snapshot} Snapshot
 * @typedef {{ x: number, y: number, input: number, off: number }} Near point of the curve; `off`: its distance from the pointer in pixels
 */

/** In pixels at the usual text size. `DOT`: radius of the dot. `TAG`: height of the label beside it. */
const DOT = 4.5;
const TAG = 17;

/** Dashes of the lines from the dot to the axes. */
const DASHES = [4, 4];

/**
 * Tolerance, in pixels, within which several passes of the curve by the pointer count as equally near. Of these passes,
 * the one with the input nearest to the current input is taken.
 */
const ALIKE = 4;

/**
 * Converts an axis to the scale that the functions of `plots/units.js` take.
 * @param {Axis} axis
 * @param {XyPlot} plot
 */
function scale({ kind, order, from, to }, { physical }) {
  return { kind, order, physical, y0: from, y1: to };
}

/**
 * @param {Axis} axis
 * @param {XyPlot} plot
 * @param {Pick<Snapshot, "coordinate" | "words">} snapshot
 * @returns {string} the symbol of an axis
 */
export function axisName({ name, number, order }, { physical }, { coordinate, words }) {
  if (name === null) return coordinate.symbol;
  const spelled = symbol({ name, number }, order, physical, words);
  return /\.[xy]$/.test(name) ? `${spelled} ${subscript(name.slice(0, -2))}` : spelled;
}

/**
 * @param {Axis} axis
 * @param {XyPlot} plot
 * @param {Pick<Snapshot, "coordinate" | "words">} snapshot
 * @returns {string} the symbol of the axis with its unit
 */
function xyAxisTitle(axis, plot, { coordinate, words }) {
  const time = axis.name === null && coordinate.moves === "time";
  const unit = time ? words.text("unit.s") : unitOf(scale(axis, plot), coordinate, words);
  return [axisName(axis, plot, { coordinate, words }), ...(unit === "" ? [] : [unit])].join(", ");
}

/**
 * Writes a value of an axis as text.
 * @param {Axis} axis
 * @param {XyPlot} plot
 * @param {number} value
 * @param {import("assur/core/words.js").Words} words
 * @param {boolean} [moving]
 */
export function xyValueText(axis, plot, value, { numbers }, moving = false) {
  return axisValueText(scale(axis, plot), value, numbers, moving);
}

/**
 * Paints the titles of the axes and the numbers along them.
 * @param {import("assur/canvas/painter.js").Context} context
 * @param {XyPlot} plot
 * @param {Snapshot} snapshot
 * @param {Theme} theme
 */
export function drawAgainstText(context, plot, snapshot, theme) {
  const { left, top, width, height, x, y, role } = plot;
  const { numbers } = snapshot.words;
  const title = `600 ${13 * theme.scale}px ${theme.font}`;
  const [right, bottom] = [left + width, top + height];
  context.font = title;
  context.textBaseline = "alphabetic";
  context.textAlign = "left";
  context.fillStyle = theme.inks[role];
  context.fillText(`↑ ${xyAxisTitle(y, plot, snapshot)}`, left, top - 9 * theme.scale, width);
  context.textAlign = "right";
  context.fillStyle = theme.colours.ink;
  context.fillText(`${xyAxisTitle(x, plot, snapshot)} →`, right, bottom + 34 * theme.scale, width);
  const font = setChartFont(context, theme);
  context.fillStyle = theme.colours.secondary;
  const texts = (/** @type {Axis} */ axis) => {
    const units = scale(axis, plot);
    return axis.ticks.map(({ value, at }) => ({ at, text: numbers.upTo(value / 10 ** power(units), 6) + (inDegrees(units) ? "°" : "") }));
  };
  context.textBaseline = "middle";
  for (const { at, text } of texts(y)) context.fillText(text, left - 5, top + at, left - 5);
  context.textBaseline = "top";
  context.textAlign = "center";
  let free = -Infinity;
  for (const { at, text } of texts(x)) {
    const half = textWidth(context, font, text) / 2;
    // The last number stays on the canvas. A number that would overlap the one before it is omitted.
    const middle = Math.min(left + at, right + 8 - half);
    if (middle - half < free) continue;
    context.fillText(text, middle, bottom + 7 * theme.scale);
    free = middle + half + 4;
  }
}

/**
 * Paints a dot on the curve, with dashed lines to the axes.
 * @param {CanvasRenderingContext2D} context
 * @param {XyPlot} plot
 * @param {Float64Array | null} values abscissa and ordinate
 * @param {Snapshot} snapshot
 * @param {Theme} theme
 * @param {{ tagged: boolean, input?: number }} how `tagged`: whether the values are written; `input`: input to write before them
 */
export function drawAgainstCursor(context, plot, values, { coordinate, state, words, withheld }, theme, { tagged, input }) {
  if (!values) return;
  const { left, top, width, height, x, y, role } = plot;
  const [right, bottom] = [left + width, top + height];
  const at = left + (width * (values[0] - x.from)) / (x.to - x.from);
  const down = top + (height * (y.to - values[1])) / (y.to - y.from);
  if (!(at >= left - 1 && at <= right + 1 && down >= top - 1 && down <= bottom + 1)) return;
  const { colours, weight } = theme;
  context.strokeStyle = colours.ink;
  context.lineWidth = weight;
  context.setLineDash(DASHES);
  context.beginPath();
  context.moveTo(left, down);
  context.lineTo(at, down);
  context.lineTo(at, bottom);
  context.stroke();
  context.setLineDash([]);
  context.lineWidth = 2 * weight;
  context.beginPath();
  context.arc(at, down, DOT * theme.scale, 0, 2 * Math.PI);
  context.fillStyle = colours.paper;
  context.fill();
  context.strokeStyle = colours[role];
  context.stroke();
  if (!tagged) return;
  const { playing } = state.view;
  const numbers = [x, y].map((axis, i) => {
    const hidden = axis.name !== null && withheld.has(idOf(axis.name, axis.order));
    return hidden ? "?" : xyValueText(axis, plot, values[i], words, playing);
  }).join("; ");
  const text = input === undefined ? numbers : `${coordinate.text(input, words, 1)}: ${numbers}`;
  const font = setChartFont(context, theme);
  const [wide, tall] = [textWidth(context, font, text) + 10, TAG * theme.scale];
  const corner = freeCorner(plot, at, down, [wide, tall], (DOT + 5) * theme.scale);
  paintTag(context, { ...corner, width: wide, tall }, { text, colour: colours[role], ink: theme.inks[role] }, theme);
}

/**
 * @param {XyPlot} plot
 * @param {number} at x of a dot
 * @param {number} down y of the dot
 * @param {[number, number]} size width and height of its numbers
 * @param {number} off distance of the numbers from the dot
 * @returns the corner beside the dot at which its numbers cover the fewest points of the curve
 */
function freeCorner({ left, top, width, height, curve }, at, down, [wide, tall], off) {
  const lefts = [at + off, at - off - wide].map((x) => Math.min(Math.max(x, left), left + width + 7 - wide));
  const tops = [down - tall - off / 2, down + off / 2].map((y) => Math.min(Math.max(y, top), top + height - tall));
  const corners = tops.flatMap((y) => lefts.map((x) => ({ left: x, top: y, right: x + wide, bottom: y + tall })));
  return cheapest(corners, (corner) => curve.reduce((points, run) => points + covered(run, 3, corner), 0));
}

/**
 * @param {XyPlot} plot
 * @param {number} x
 * @param {number} y of a pointer
 * @param {number} beyond greatest distance outside the plot, in pixels
 * @param {number} input current input
 * @returns {number | null} input at the point of the curve nearest to the pointer; null if the pointer is too far from the plot or there is no curve
 */
export function inputAt({ left, top, width, height, curve }, x, y, beyond, input) {
  if (x < left - beyond || x > left + width + beyond || y < top - beyond || y > top + height + beyond) return null;
  const passes = curve.flatMap((run) => nearest(run, x, y));
  const least = Math.min(...passes.map(({ off }) => off));
  const alike = passes.filter(({ off }) => off <= least + ALIKE);
  if (alike.length === 0) return null;
  const aside = (/** @type {Near} */ pass) => Math.abs(pass.input - input);
  return alike.reduce((best, pass) => (aside(pass) < aside(best) ? pass : best)).input;
}

/**
 * @param {readonly number[]} run x, y and input of each point of a run of the curve
 * @param {number} x
 * @param {number} y
 * @returns {Near[]} the points of the run at which the distance from (x, y) has a minimum, one for each pass
 */
function nearest(run, x, y) {
  /** @type {Near[]} */
  const all = [];
  for (let i = 3; i < run.length; i += 3) {
    const [x0, y0, from, x1, y1, to] = run.slice(i - 3, i + 3);
    const [dx, dy] = [x1 - x0, y1 - y0];
    const way = dx * dx + dy * dy;
    const share = way > 0 ? Math.min(Math.max(((x - x0) * dx + (y - y0) * dy) / way, 0), 1) : 0;
    const at = { x: x0 + share * dx, y: y0 + share * dy, input: from + share * (to - from) };
    all.push({ ...at, off: Math.hypot(at.x - x, at.y - y) });
  }
  const off = (/** @type {number} */ i) => all[i]?.off ?? Infinity;
  return all.filter((_, i) => off(i) <= off(i - 1) && off(i) <= off(i + 1));
}

/**
 * @param {XyPlot} plot
 * @param {Snapshot} snapshot
 * @returns {string} description of the plot for screen readers
 */
export function described(plot, { coordinate, words }) {
  const { left, top, width, height, curve, x, y } = plot;
  const points = curve.flatMap((run) => run.flatMap((_, i) => (i % 3 === 0 ? [[run[i], run[i + 1]]] : [])));
  const said = (/** @type {Axis} */ axis, /** @type {number[]} */ values) => {
    const input = axis.name === null;
    const [from, to] = [Math.min(...values), Math.max(...values)].map((value) => (input ? coordinate.text(value, words, 1) : xyValueText(axis, plot, value, words)));
    return words.text("told.spans", { name: axisName(axis, plot, { coordinate, words }), from, to });
  };
  const across = points.map(([at]) => x.from + ((x.to - x.from) * (at - left)) / width);
  const up = points.map(([, at]) => y.to - ((y.to - y.from) * (at - top)) / height);
  const names = { y: axisName(y, plot, { coordinate, words }), x: axisName(x, plot, { coordinate, words }) };
  const spans = points.length > 0 ? [said(x, across), said(y, up)] : [];
  return [words.text("told.against", names), ...spans].join(" ");
}
