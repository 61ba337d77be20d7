// Width of a text on a canvas. A browser takes as long to measure as to draw; most texts are numbers of a few forms.

/** Limit of the number of remembered widths, at which all are forgotten. */
const MOST = 400;

/** @type {Map<string, number>} widths by font and form of the text */
const known = new Map();

/**
 * Width of a text. All digits count as equally wide, as they are in fonts for tables and screens.
 * @param {import("assur/canvas/painter.js").Context} context with the font set
 * @param {string} font the same font: reading it from a context is slow
 * @param {string} text
 * @returns {number} width in the unit of the font's size
 */
export function textWidth(context, font, text) {
  const key = `${font} ${text.replace(/\d/g, "0")}`;
  const width = known.get(key) ?? context.measureText(text).width;
  if (known.size >= MOST) known.clear();
  known.set(key, width);
  return width;
}
