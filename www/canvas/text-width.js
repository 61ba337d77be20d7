// How wide a text is on a canvas. Measuring takes a browser as long as drawing; most texts are numbers of a few forms.

/** So many are remembered; then all are measured anew. */
const MOST = 400;

/** @type {Map<string, number>} by font and form */
const known = new Map();

/**
 * Digits count as alike in width, as they are in all fonts that are made for tables and screens.
 * @param {import("assur/canvas/painter.js").Context} context with the font
 * @param {string} font the same: a context takes long to tell it
 * @param {string} text
 * @returns {number} in the unit of the font's size
 */
export function textWidth(context, font, text) {
  const key = `${font} ${text.replace(/\d/g, "0")}`;
  const width = known.get(key) ?? context.measureText(text).width;
  if (known.size >= MOST) known.clear();
  known.set(key, width);
  return width;
}
