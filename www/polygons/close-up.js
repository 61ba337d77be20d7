// The view of a polygon at rest: as large as its box allows, with a scale bar to match. In motion all polygons have one scale.
import { circleBounds, readDisplayList } from "assur/canvas/display-list.js";
import { Transform } from "assur/canvas/transform.js";

/**
 * @typedef {import("assur/types/web.js").PolygonPictureHere} Picture
 * @typedef {import("assur/canvas/display-list.js").Layer} Layer
 * @typedef {import("assur/canvas/boxes.js").Box} Box
 */

/** Greatest magnification of the usual scale: arrows and dots grow with it. */
const MOST = 3;
/** Greatest length of the scale bar, as a share of the box. */
const BAR = 0.4;
/** Round lengths, to be multiplied by a power of ten. */
const ROUND = Object.freeze([5, 2, 1]);
/** Count of the numbers at the end of the list that draw the engine's scale bar: three lines of two points. */
const BAR_NUMBERS = 24;
/** Height of the strip for the scale bar, in pixels. */
const STRIP = 14;
/** Distance between the points of a line that labels keep off, in pixels. */
const APART = 3;

/**
 * @param {Picture} picture
 * @param {Picture} whole picture of the whole polygon, of which `picture` shows the first steps
 * @param {{ width: number, height: number }} size of the box, in pixels
 * @param {number} margin free room for the names, in pixels
 * @returns `view`; `list`: the display list without the engine's scale bar; `bar`: value for which the scale bar stands
 */
export function closeUp(picture, whole, { width, height }, margin) {
  const dots = circles(whole.list);
  const [left, bottom, right, top] = [0, 1, 2, 3].map((side) => (side < 2 ? Math.min : Math.max)(...dots.map((dot) => dot[side])));
  const usual = Transform.fit(picture.bounds, width, height, margin).scale;
  const close = Transform.fit([left, bottom, right, top], width, height - STRIP, margin);
  const factor = Math.min(1, (MOST * usual) / close.scale);
  const view = close.scaled(factor, width / 2, (height - STRIP) / 2);
  const most = (BAR * width) / view.scale;
  return { view, list: picture.list.slice(0, -BAR_NUMBERS), bar: roundBelow(most) };
}

/**
 * @param {number} most positive
 * @returns {number} greatest round number that is not larger
 */
export function roundBelow(most) {
  const power = 10 ** Math.floor(Math.log10(most));
  return (ROUND.find((digit) => digit * power <= most) ?? 1) * power;
}

/**
 * @param {readonly number[]} list
 * @returns {number[][]} bounds of the dots of a polygon: the pole and the points
 */
function circles(list) {
  const blank = () => /** @type {Path2D} */ (/** @type {object} */ ({ moveTo() {}, lineTo() {}, arc() {}, closePath() {} }));
  return readDisplayList(Float32Array.from(list), 0, [], [], blank).flatMap(({ shapes }) => shapes).flatMap(({ record }) => circleBounds(record));
}

/**
 * @param {readonly Layer[]} layers in the coordinates of the frame
 * @param {Transform} view
 * @returns {Box[]} small boxes along all lines, in pixels
 */
export function alongLines(layers, view) {
  /** @type {Box[]} */
  const boxes = [];
  const along = (/** @type {ArrayLike<number>} */ points) => {
    for (let i = 2; i + 1 < points.length; i += 2) {
      const [from, to] = [view.toScreen(points[i - 2], points[i - 1]), view.toScreen(points[i], points[i + 1])];
      const steps = Math.ceil(Math.hypot(to[0] - from[0], to[1] - from[1]) / APART);
      for (let k = 0; k <= steps; k++) {
        const [x, y] = [0, 1].map((way) => from[way] + ((to[way] - from[way]) * k) / Math.max(steps, 1));
        boxes.push({ left: x - 1, top: y - 1, right: x + 1, bottom: y + 1 });
      }
    }
  };
  for (const { record, loops } of layers.flatMap(({ shapes }) => shapes)) {
    if (loops) loops.forEach(along);
    else if (circleBounds(record).length === 0) along(record.subarray(4));
  }
  return boxes;
}
