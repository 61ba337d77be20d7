// Places of the labels of a drawing. A label whose wanted place is taken, or nearer to the point of another label, stands on
// another side of its point.
import { isFree } from "assur/canvas/boxes.js";

/**
 * @typedef {import("assur/canvas/boxes.js").Box} Box
 * @typedef {Readonly<{ width: number, height: number }>} Size of the drawing, in CSS pixels
 * @typedef {Readonly<{ x: number, y: number }>} Point
 */

/**
 * Possible places of a label. The numbers multiply the label's wanted offset from its point, along x and along y. The
 * wanted place comes first, then the other sides, then the same sides twice as far away.
 */
const SIDES = Object.freeze([1, 2].flatMap((far) => [
  [far, far],
  [-far, -far],
  [far, -far],
  [-far, far],
]));

/** Extra room, in heights of the label, that a moved label needs to return to its wanted place. Prevents flicker. */
const ROOM = 1.5;

/** Distance below which two points count as one, in pixels. */
const SAME = 2;

export class Places {
  /** @type {Box[]} boxes of the labels placed since `begin` */
  #taken = [];
  /** @type {Map<string, number>} index in `SIDES` for each label that is not in its wanted place */
  #moved = new Map();
  /** @type {Size} */
  #sheet = { width: 0, height: 0 };
  /** @type {readonly Box[]} */
  #lines = [];
  /** @type {readonly Point[]} points of all labels */
  #points = [];

  /**
   * Begins a new placement of all labels.
   * @param {Size} sheet size of the drawing; a label does not leave it if the label's point is inside
   * @param {readonly Point[]} [points] points of the labels
   * @param {readonly Box[]} [lines] boxes along lines; a label stands on them only if no other place is free
   */
  begin(sheet, points = [], lines = []) {
    this.#taken = [];
    this.#lines = lines;
    this.#points = points;
    this.#sheet = sheet;
  }

  /**
   * Takes a place for a label. A moved label keeps its place until its wanted place is well clear or its own is taken.
   * @param {string} label
   * @param {{ x: number, y: number, dx: number, dy: number }} wanted the label's point, and the offset of the label's middle
   * @param {number} width
   * @param {number} height
   * @returns {{ x: number, y: number, free: boolean }} middle of the label, at the wanted place if none is free
   */
  take(label, { x, y, dx, dy }, width, height) {
    const sheet = this.#sheet;
    const on = (/** @type {number} */ side) => ({
      x: within(x, x + SIDES[side][0] * dx, width / 2, sheet.width),
      y: within(y, y + SIDES[side][1] * dy, height / 2, sheet.height),
    });
    const free = (/** @type {number} */ side, room = 0) => isFree(boxOf(on(side), width + room, height + room), this.#taken);
    const last = this.#moved.get(label) ?? 0;
    const back = last === 0 ? 0 : ROOM * height;
    const sides = [0, last, ...SIDES.keys()];
    const good = (/** @type {number} */ one) => this.#isOwn(on(one), { x, y }) && isFree(boxOf(on(one), width, height), this.#lines);
    const side = sides.find((one, i) => free(one, i === 0 ? back : 0) && good(one)) ?? sides.find((one, i) => free(one, i === 0 ? back : 0));
    if (side) this.#moved.set(label, side);
    else this.#moved.delete(label);
    const at = on(side ?? 0);
    if (side !== undefined) this.#taken.push(boxOf(at, width, height));
    return { ...at, free: side !== undefined };
  }

  /**
   * @param {Point} middle of a label
   * @param {Point} own point of the label
   * @returns {boolean} whether no other point is nearer to the label; points in one place count as one
   */
  #isOwn(middle, own) {
    const off = distance(middle, own);
    return this.#points.every((point) => distance(middle, point) >= off || distance(point, own) < SAME);
  }
}

/**
 * @param {Point} a
 * @param {Point} b
 */
function distance(a, b) {
  return Math.hypot(a.x - b.x, a.y - b.y);
}

/**
 * @param {number} point
 * @param {number} wanted
 * @param {number} half half of the label's size
 * @param {number} length of the sheet
 * @returns {number} the wanted place, moved so that the label is inside the sheet; unmoved if the label's point is outside
 */
function within(point, wanted, half, length) {
  return point < -half || point > length + half || length < 2 * half ? wanted : Math.min(Math.max(wanted, half), length - half);
}

/**
 * @param {{ x: number, y: number }} middle
 * @param {number} width
 * @param {number} height
 * @returns {Box}
 */
function boxOf({ x, y }, width, height) {
  return { left: x - width / 2, right: x + width / 2, top: y - height / 2, bottom: y + height / 2 };
}
