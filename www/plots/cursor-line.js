// The line of a cursor in one plot, with a dot on each curve.
import { down, shows } from "assur/plots/panel.js";

/**
 * @typedef {import("assur/canvas/theme.js").Theme} Theme
 * @typedef {import("assur/types/web.js").PanelLayout} Panel
 * @typedef {Readonly<{ index: number, value: number, y: number, role: string }>} Point value of a curve. `index`: of the curve in the panel; `y`: in pixels
 */

/** Radius of a dot, in pixels at the usual text size. */
const DOT = 4.5;

/** @type {number[]} dashes of an unbroken line */
const SOLID = [];

/** @param {Theme} theme */
export function dotRadius({ scale }) {
  return DOT * scale;
}

/**
 * @param {Panel} panel
 * @param {Float64Array | null} values of the plotted quantities, each with its derivatives
 * @returns {Point[]} the values that the panel shows
 */
export function pointsOf(panel, values) {
  if (!values) return [];
  const points = panel.series.map(({ role }, index) => {
    const value = values[3 * index + panel.order];
    return { index, value, y: down(panel, value), role };
  });
  return points.filter(({ value }) => shows(panel, value));
}

/**
 * @param {import("assur/canvas/painter.js").Context} context
 * @param {Panel} panel
 * @param {number} x of the line, in pixels
 * @param {readonly Point[]} points
 * @param {Theme} theme
 * @param {number[]} [dashes]
 * @returns {boolean} whether the line is within the panel; otherwise nothing is painted
 */
export function paintCursorLine(context, panel, x, points, theme, dashes = SOLID) {
  if (!(x >= panel.left - 1 && x <= panel.left + panel.width + 1)) return false;
  const { colours, weight } = theme;
  context.strokeStyle = colours.ink;
  context.lineWidth = weight;
  context.beginPath();
  context.moveTo(x, panel.top);
  context.lineTo(x, panel.top + panel.height);
  context.setLineDash(dashes);
  context.stroke();
  context.setLineDash(SOLID);
  context.lineWidth = 2 * weight;
  for (const { y, role } of points) {
    context.beginPath();
    context.arc(x, y, dotRadius(theme), 0, 2 * Math.PI);
    context.fillStyle = colours.paper;
    context.fill();
    context.strokeStyle = colours[role];
    context.stroke();
  }
  return true;
}
