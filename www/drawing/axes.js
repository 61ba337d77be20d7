// Axes of the paper with numbers, painted under the drawing while the reader draws.
import { side } from "assur/stage/paper.js";

/**
 * @typedef {import("assur/canvas/transform.js").Transform} Transform
 * @typedef {import("assur/canvas/theme.js").Theme} Theme
 * @typedef {Readonly<{ left: number, top: number, right: number, bottom: number }>} Area of the canvas without tools, in pixels
 */

/** `SIZE`: height of the numbers. `GAP`: between number and axis. `ROOM`: least room between two numbers. In pixels. */
const SIZE = 11;
const GAP = 5;
const ROOM = 12;

/** Numbers of squares from one number to the next; the first with enough room is taken. */
const STRIDES = Object.freeze([1, 2, 5, 10]);

/**
 * Finds the places of the numbers on an axis.
 * @param {number} scale pixels per unit of length
 * @param {number} origin pixel of the zero
 * @param {number} from first visible pixel
 * @param {number} to last pixel
 * @param {number} widest width of the widest number, in pixels
 * @returns {{ value: number, at: number }[]} `at`: pixel; both ascend
 */
export function numbered(scale, origin, from, to, widest) {
  const square = side(scale);
  const stride = STRIDES.find((count) => count * square * scale >= widest + ROOM) ?? STRIDES[STRIDES.length - 1];
  const step = stride * square;
  const places = [];
  for (let k = Math.ceil((from - origin) / (step * scale)); origin + k * step * scale <= to; k++) {
    places.push({ value: Number((k * step).toPrecision(12)), at: origin + k * step * scale });
  }
  return places;
}

/**
 * Paints both axes. The numbers of an axis out of sight stand at the nearest edge of the area.
 * @param {CanvasRenderingContext2D} context
 * @param {Transform} view
 * @param {Theme} theme
 * @param {Area} area
 * @param {import("assur/core/words.js").Words} words
 */
export function paintAxes(context, view, theme, area, words) {
  const size = SIZE * theme.scale;
  const text = (/** @type {number} */ value) => words.numbers.short(value);
  context.save();
  context.font = `${size}px ${theme.font}`;
  context.lineWidth = theme.weight;
  context.strokeStyle = theme.colours.secondary;
  context.globalAlpha = 0.6;
  context.beginPath();
  const [left, top] = [Math.round(view.left) + 0.5, Math.round(view.top) + 0.5];
  context.moveTo(0, top);
  context.lineTo(area.right, top);
  context.moveTo(left, 0);
  context.lineTo(left, area.bottom);
  context.stroke();
  context.globalAlpha = 1;
  const ends = [view.toModel(area.left, area.bottom), view.toModel(area.right, area.top)].flat();
  const widest = Math.max(...ends.map((value) => context.measureText(text(side(view.scale) * Math.round(value / side(view.scale)))).width));
  const write = (/** @type {string} */ label, /** @type {number} */ x, /** @type {number} */ y) => {
    context.lineWidth = 3;
    context.lineJoin = "round";
    context.strokeStyle = theme.ground;
    context.strokeText(label, x, y);
    context.fillStyle = theme.colours.secondary;
    context.fillText(label, x, y);
  };
  const below = Math.min(Math.max(top + GAP, area.top), area.bottom - size);
  const beside = Math.min(Math.max(left - GAP, area.left + widest), area.right);
  context.textBaseline = "top";
  context.textAlign = "center";
  for (const { value, at } of numbered(view.scale, view.left, area.left, area.right, widest)) if (value !== 0) write(text(value), at, below);
  context.textAlign = "right";
  write("0", beside, below);
  context.textBaseline = "middle";
  // Pixels grow downwards, values upwards.
  for (const { value, at } of numbered(view.scale, -view.top, -area.bottom + size, -area.top, size)) if (value !== 0) write(text(value), beside, -at);
  write("y", beside, area.top);
  context.textBaseline = "bottom";
  write("x", area.right, top - 2);
  context.restore();
}
