// The line along a polygon as a band to fill. Without a graphics processor, filling is much faster than stroking.

/** Lower limit of 1 + cos δ, where δ is the turn of the line at a corner. The limit shortens sharp tips. */
const SHARPEST = 0.3;

/**
 * The band along each polygon, between copies of the polygon offset outwards and inwards by half the width.
 * @param {readonly import("assur/canvas/display-list.js").List[]} loops x and y of the corners of closed polygons
 * @param {number} width in the unit of the corners
 * @returns {Path2D} to be filled with the non-zero rule
 */
export function outlined(loops, width) {
  const band = new Path2D();
  for (const loop of loops) {
    const corners = distinct(loop);
    add(band, moved(corners, width / 2));
    // In reverse order, the corners give the inner edge of the band.
    add(band, moved(corners.reverse(), width / 2));
  }
  return band;
}

/**
 * @param {import("assur/canvas/display-list.js").List} loop
 * @returns {[number, number][]} corners of the loop without consecutive duplicates
 */
function distinct(loop) {
  /** @type {[number, number][]} */
  const corners = [];
  for (let i = 0; i < loop.length; i += 2) {
    const [x, y] = corners.at(-1) ?? [loop.at(-2), loop.at(-1)];
    if (loop[i] !== x || loop[i + 1] !== y) corners.push([loop[i], loop[i + 1]]);
  }
  return corners;
}

/**
 * @param {readonly (readonly [number, number])[]} corners
 * @param {number} distance
 * @returns {[number, number][]} corners of the polygon after each side is offset to its right
 */
function moved(corners, distance) {
  const sides = corners.map(([x, y], i) => {
    const [toX, toY] = corners[(i + 1) % corners.length];
    const length = Math.hypot(toX - x, toY - y);
    return [(toY - y) / length, (x - toX) / length];
  });
  return corners.map(([x, y], i) => {
    const [ax, ay] = sides.at(i - 1) ?? sides[i];
    const [bx, by] = sides[i];
    const reach = distance / Math.max(1 + ax * bx + ay * by, SHARPEST);
    return [x + reach * (ax + bx), y + reach * (ay + by)];
  });
}

/**
 * @param {Path2D} path
 * @param {readonly (readonly [number, number])[]} corners
 */
function add(path, corners) {
  corners.forEach(([x, y], i) => (i === 0 ? path.moveTo(x, y) : path.lineTo(x, y)));
  path.closePath();
}
