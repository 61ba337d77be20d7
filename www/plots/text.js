// Text of the chart: titles with units, and the numbers along the axes.
import { textWidth } from "assur/canvas/text-width.js";
import { radians } from "assur/core/angles.js";
import { partsOf } from "assur/core/quantity.js";
import { letterOf, subscript, symbol } from "assur/core/symbols.js";
import { across, down } from "assur/plots/panel.js";
import { axisTitle, coordinates, inDegrees, levelText, power, unitOf } from "assur/plots/units.js";

/**
 * @typedef {import("assur/canvas/boxes.js").Box} Box
 * @typedef {import("assur/types/web.js").PanelLayout} Panel
 * @typedef {import("assur/canvas/theme.js").Theme} Theme
 * @typedef {import("assur/core/words.js").Words} Words
 * @typedef {import("assur/state/coordinate.js").Coordinate} Coordinate
 */

const SIZE = 11;

/** Greatest number of curves that a title names, each in its colour; for more, the title is their quantity's symbol. */
const MAX_NAMED = 3;

/**
 * @param {import("assur/canvas/painter.js").Context} context
 * @param {readonly Panel[]} panels
 * @param {import("assur/state/model.js").Snapshot} snapshot
 * @param {Theme} theme
 * @returns {Box[]} boxes of the titles
 */
export function drawChartText(context, panels, { coordinate, words }, theme) {
  const titles = panels.map((panel) => drawTitle(context, panel, coordinate, words, theme));
  for (const panel of panels) drawValues(context, panel, words, theme);
  const last = panels[panels.length - 1];
  if (last) drawInputs(context, last, coordinate, words, theme);
  return titles;
}

/**
 * @param {import("assur/canvas/painter.js").Context} context
 * @param {Theme} theme
 * @param {number} [size]
 * @returns {string} the font that was set
 */
export function setChartFont(context, theme, size = SIZE) {
  const font = `${size * theme.scale}px ${theme.font}`;
  context.font = font;
  return font;
}

/**
 * @param {import("assur/canvas/painter.js").Context} context
 * @param {Panel} panel
 * @param {Coordinate} coordinate
 * @param {Words} words
 * @param {Theme} theme
 * @returns {Box}
 */
function drawTitle(context, panel, coordinate, words, theme) {
  const { left, top } = panel;
  context.textAlign = "left";
  context.textBaseline = "alphabetic";
  let right = left;
  const write = (/** @type {string} */ text, /** @type {string} */ colour) => {
    context.fillStyle = colour;
    context.fillText(text, right, top - 9 * theme.scale);
    right += textWidth(context, font, text);
  };
  let font = `600 ${14 * theme.scale}px ${theme.font}`;
  context.font = font;
  const named = NAMINGS.map((naming) => names(panel, words, naming));
  const fit = named.find((parts) => parts.reduce((width, [text]) => width + textWidth(context, font, text), 0) <= panel.width);
  for (const [text, role] of fit ?? named[NAMINGS.length - 1]) write(text, role ? theme.inks[role] : theme.colours.ink);
  font = setChartFont(context, theme, 12);
  const title = axisTitle(panel, coordinate, words);
  const proof = panel.differenced ? `  • ${words.text("plots.differenced", { of: firsts(panel, words) })}` : "";
  // If there is no room for the whole title, the unit replaces the name of the quantity.
  const fits = right + textWidth(context, font, `  ${title}${proof}`) <= left + panel.width;
  write(`  ${fits ? title : unitOf(panel, coordinate, words)}`, theme.colours.secondary);
  write(proof, theme.colours.ink);
  return { left, top: top - 22 * theme.scale, right: right + 4, bottom: top - 5 * theme.scale };
}

/** Size of the sign after a title, in pixels. The sign shows that a press on the title makes the plot large, or shows all plots again. */
const SIGN = 9;

/**
 * Draws two corners that point outwards, or inwards for a plot that is alone.
 * @param {import("assur/canvas/painter.js").Context} context
 * @param {Box} title
 * @param {Theme} theme
 * @param {{ alone: boolean, end: number }} where `end`: right edge of the canvas
 * @returns {Box} box of the title with its sign, if there is room for it
 */
export function drawTitleSign(context, title, theme, { alone, end }) {
  const size = SIGN * theme.scale;
  const left = title.right + 5 * theme.scale;
  if (left + size > end) return title;
  const middle = (title.top + title.bottom) / 2 + theme.scale;
  context.strokeStyle = theme.colours.secondary;
  context.lineWidth = 1.5 * theme.scale;
  for (const way of [-1, 1]) {
    const at = (/** @type {number} */ share) => /** @type {const} */ ([left + size / 2 + (way * share * size) / 2, middle - (way * share * size) / 2]);
    const [tip, corner] = alone ? [at(1), at(0.25)] : [at(0.25), at(1)];
    const [x, y] = corner;
    const leg = (alone ? way : -way) * 0.4 * size;
    context.beginPath();
    context.moveTo(...tip);
    context.lineTo(x, y);
    context.moveTo(x + leg, y);
    context.lineTo(x, y);
    context.lineTo(x, y - leg);
    context.stroke();
  }
  return { ...title, right: left + size + 4 };
}

/** Ways to name curves, longest first: symbol and constant value in words, symbol = value, symbol, letter for all. */
const NAMINGS = Object.freeze(/** @type {const} */ (["throughout", "value", "symbol", "letter"]));

/**
 * Lists the symbols of a panel's title, each with the role of its curve and, for a constant curve, with its value.
 * @param {Panel} panel
 * @param {Words} words
 * @param {typeof NAMINGS[number]} naming
 */
function names(panel, words, naming) {
  const { order, physical, series } = panel;
  const [{ name }] = series;
  // With several points each curve is named with its point.
  const points = coordinates(panel) ? series.map((one) => subscript(partsOf(one.name).of)) : [];
  const several = new Set(points).size > 1;
  if (series.length > MAX_NAMED || naming === "letter") return [[letterOf({ name }, order, physical)]];
  const symbols = series.map((one, i) => {
    const value = one.level === null || naming === "symbol" ? "" : levelText(panel, one.level, words.numbers);
    const said = value === "" ? "" : naming === "value" ? ` = ${value}` : ` ${words.text("plots.throughout", { value })}`;
    return /** @type {[string, string]} */ ([symbol(one, order, physical, words) + (several ? ` ${points[i]}` : "") + said, one.role]);
  });
  /** @type {[string, string?][]} */
  const listed = symbols.flatMap((one, i) => (i > 0 ? [[", "], one] : [one]));
  return points.length > 0 && !several ? [[`${points[0]}: `], ...listed] : listed;
}

/**
 * @param {Panel} panel
 * @param {Words} words
 * @returns {string} the symbols of the first derivatives, without subscripts, each once
 */
function firsts({ physical, series }, words) {
  const symbols = series.map((one) => symbol(one, 1, physical, words).replace(/[₀-₉]/g, ""));
  return [...new Set(symbols)].join(", ");
}

/**
 * @param {import("assur/canvas/painter.js").Context} context
 * @param {Panel} panel
 * @param {Words} words
 * @param {Theme} theme
 */
function drawValues(context, panel, words, theme) {
  setChartFont(context, theme);
  context.textAlign = "right";
  context.textBaseline = "middle";
  context.fillStyle = theme.colours.secondary;
  const angle = inDegrees(panel);
  const unit = 10 ** power(panel);
  for (const { value } of panel.yticks) {
    const at = down(panel, angle ? radians(value) : value);
    const text = words.numbers.upTo(value / unit, 6) + (angle ? "°" : "");
    context.fillText(text, panel.left - 5, at, panel.left - 5);
  }
}

/**
 * @param {import("assur/canvas/painter.js").Context} context
 * @param {Panel} panel
 * @param {Coordinate} coordinate
 * @param {Words} words
 * @param {Theme} theme
 */
function drawInputs(context, panel, coordinate, words, theme) {
  const font = setChartFont(context, theme);
  context.textBaseline = "top";
  context.fillStyle = theme.colours.secondary;
  const right = panel.left + panel.width;
  const top = panel.top + panel.height + 7 * theme.scale;
  const turns = coordinate.moves === "angle";
  let free = -Infinity;
  const last = panel.xticks.length - 1;
  for (const [i, { value }] of panel.xticks.entries()) {
    // The last number on an axis of time has the unit.
    const unit = turns ? "°" : coordinate.moves === "time" && i === last ? `\u00a0${words.text("unit.s")}` : "";
    const text = words.numbers.upTo(value, turns ? 2 : 6) + unit;
    const half = textWidth(context, font, text) / 2;
    // The last number stays on the canvas. A number that would overlap the one before it is omitted.
    const middle = Math.min(across(panel, coordinate.input(value)), right + 8 - half);
    if (middle - half < free) continue;
    context.textAlign = "center";
    context.fillText(text, middle, top);
    free = middle + half + 4;
  }
}
