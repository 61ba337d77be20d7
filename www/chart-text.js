// The text of the chart: titles with units and the numbers along the axes.
import { radians } from "assur/angles.js";
import { across, down } from "assur/panels.js";

/**
 * @typedef {import("assur/chart-marks.js").Box} Box
 * @typedef {import("assur/engine.js").Panel} Panel
 * @typedef {import("assur/theme.js").Theme} Theme
 * @typedef {import("assur/words.js").Words} Words
 */

const SYMBOLS = Object.freeze(["φ", "φ′", "φ″"]);
const SIZE = 11;

/** The room the engine leaves for text does not grow with it. */
const LARGEST_SCALE = 1.09;

/**
 * @param {CanvasRenderingContext2D} context
 * @param {readonly Panel[]} panels
 * @param {Words} words
 * @param {Theme} theme
 * @returns {Box[]} where the titles are
 */
export function drawChartText(context, panels, words, theme) {
  const titles = panels.map((panel) => drawTitle(context, panel, words, theme));
  for (const panel of panels) drawValues(context, panel, words, theme);
  const last = panels[panels.length - 1];
  if (last) drawAngles(context, last, words, theme);
  return titles;
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Theme} theme
 * @param {number} [size]
 */
export function setChartFont(context, theme, size = SIZE) {
  context.font = `${size * Math.min(theme.scale, LARGEST_SCALE)}px ${theme.font}`;
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Panel} panel
 * @param {Words} words
 * @param {Theme} theme
 * @returns {Box}
 */
function drawTitle(context, { order, left, top }, words, theme) {
  const symbol = SYMBOLS[order];
  context.textAlign = "left";
  context.textBaseline = "alphabetic";
  context.font = `600 ${14 * Math.min(theme.scale, LARGEST_SCALE)}px ${theme.font}`;
  context.fillStyle = theme.colours.ink;
  context.fillText(symbol, left, top - 9);
  const width = context.measureText(`${symbol} `).width;
  setChartFont(context, theme, 12);
  context.fillStyle = theme.colours.secondary;
  const unit = words.text(`plots.unit.${order}`);
  context.fillText(unit, left + width, top - 9);
  return { left, top: top - 22, right: left + width + context.measureText(unit).width + 4, bottom: top - 5 };
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Panel} panel
 * @param {Words} words
 * @param {Theme} theme
 */
function drawValues(context, panel, words, theme) {
  setChartFont(context, theme);
  context.textAlign = "right";
  context.textBaseline = "middle";
  context.fillStyle = theme.colours.secondary;
  const unit = panel.order === 0 ? "°" : "";
  for (const { value } of panel.yticks) {
    const at = down(panel, panel.order === 0 ? radians(value) : value);
    context.fillText(words.numbers.upTo(value, 6) + unit, panel.left - 5, at, panel.left - 5);
  }
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Panel} panel
 * @param {Words} words
 * @param {Theme} theme
 */
function drawAngles(context, panel, words, theme) {
  setChartFont(context, theme);
  context.textBaseline = "top";
  context.fillStyle = theme.colours.secondary;
  const right = panel.left + panel.width;
  const top = panel.top + panel.height + 7;
  let free = -Infinity;
  for (const { value } of panel.xticks) {
    const text = `${words.numbers.upTo(value, 2)}°`;
    const half = context.measureText(text).width / 2;
    // Numbers at the very ends stay on the canvas; numbers without room are left out.
    const middle = Math.min(across(panel, radians(value)), right + 8 - half);
    if (middle - half < free) continue;
    context.textAlign = "center";
    context.fillText(text, middle, top);
    free = middle + half + 4;
  }
}
