// Boxes of labels: whether a box is free, and which of several covers the least.

/** @typedef {Readonly<{ left: number, right: number, top: number, bottom: number }>} Box */

/**
 * @param {Box} box
 * @param {readonly Box[]} taken
 * @returns {boolean} whether the box overlaps none of the others
 */
export function isFree({ left, right, top, bottom }, taken) {
  return taken.every((it) => right <= it.left || it.right <= left || bottom <= it.top || it.bottom <= top);
}

/**
 * @param {readonly number[]} points of a curve
 * @param {number} step number of values per point, of which x and y come first
 * @param {Box} box
 * @returns {number} number of points in the box or within a pixel of its edge
 */
export function covered(points, step, { left, right, top, bottom }) {
  let inside = 0;
  for (let i = 0; i < points.length; i += step) {
    const x = points[i];
    const y = points[i + 1];
    if (x > left - 1 && x < right + 1 && y > top - 1 && y < bottom + 1) inside += 1;
  }
  return inside;
}

/**
 * @template T
 * @param {readonly T[]} choices at least one, in the order of preference
 * @param {(choice: T) => number} cost
 * @returns {T} the first choice with the least cost
 */
export function cheapest(choices, cost) {
  const costs = choices.map(cost);
  return choices[costs.indexOf(Math.min(...costs))];
}
