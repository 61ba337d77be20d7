// Names of read-outs. A quantity has a name such as `rocker.angle` or `C.x`; strokes mark its derivatives, as in `rocker.angle″`.

/** Marks of derivatives, by order. */
export const STROKES = Object.freeze(["", "′", "″"]);

/**
 * @param {string} quantity
 * @param {number} order of its derivative
 * @returns {string} name of the read-out
 */
export function idOf(quantity, order) {
  return quantity + STROKES[order];
}

/**
 * @param {string} name of a read-out
 * @returns {import("assur/types/web.js").ReadoutId} its quantity and the order of the derivative
 */
export function readingOf(name) {
  const order = Math.max(0, STROKES.indexOf(name.slice(-1)));
  return { quantity: order > 0 ? name.slice(0, -1) : name, order };
}

/**
 * @param {string} quantity
 * @returns {{ of: string, what: string }} `of`: the part before the last dot: a link, a point, or several of them with hyphens between;
 * empty if there is none. `what`: the part after the last dot
 */
export function partsOf(quantity) {
  const dot = quantity.lastIndexOf(".");
  return { of: quantity.slice(0, Math.max(dot, 0)), what: quantity.slice(dot + 1) };
}
