// Conversion between pixels and values in a panel of the chart, by the layout that the engine returns.

/** @typedef {import("assur/types/web.js").PanelLayout} Panel */

/**
 * @param {Panel} panel
 * @param {number} input
 * @returns {number} CSS pixels from the left
 */
export function across(panel, input) {
  return panel.left + (panel.width * (input - panel.x0)) / (panel.x1 - panel.x0);
}

/**
 * @param {Panel} panel
 * @param {number} left CSS pixels from the left
 * @returns {number} the input there, limited to the ends of the axis
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
