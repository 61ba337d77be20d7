// Widths of text on a canvas, cached because browsers take as long to measure a text as to draw it.

/** Number of cached widths at which the cache is cleared. */
const MAX_REMEMBERED = 400;

/** @type {Map<string, number>} widths by font and text; in the text, 0 stands for every digit */
const known = new Map();

/**
 * Width of a text. All digits count as equally wide, like tabular digits.
 * @param {import("assur/canvas/painter.js").Context} context with the font set
 * @param {string} font font of the context, given because reading it from the context is slow
 * @param {string} text
 * @returns {number} width in the unit of the font's size
 */
export function textWidth(context, font, text) {
  const key = `${font} ${text.replace(/\d/g, "0")}`;
  const width = known.get(key) ?? context.measureText(text).width;
  if (known.size >= MAX_REMEMBERED) known.clear();
  known.set(key, width);
  return width;
}
