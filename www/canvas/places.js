// Places of the labels of a drawing: each where the drawing wants it or, if another label is there, on another side of its point.

/**
 * @typedef {import("assur/canvas/painter.js").Box} Box
 * @typedef {Readonly<{ width: number, height: number }>} Sheet in CSS pixels
 */

/**
 * Possible places of a label, as factors of its distance from its point along x and y: the wanted place comes first, then the
 * other sides, then places farther away.
 */
const SIDES = Object.freeze([1, 2].flatMap((far) => [
  [far, far],
  [-far, -far],
  [far, -far],
  [-far, far],
]));

/** Extra room, in heights, that a label needs to return to its wanted place: it would flicker in motion without it. */
const ROOM = 1.5;

export class Places {
  /** @type {Box[]} boxes of the labels placed since `begin` */
  #taken = [];
  /** @type {Map<string, number>} sides of the labels that are not in their wanted places */
  #moved = new Map();
  /** @type {Sheet} */
  #sheet = { width: 0, height: 0 };

  /**
   * Begins a new placement of all labels.
   * @param {Sheet} sheet on which labels stay if their points are on it
   */
  begin(sheet) {
    this.#taken = [];
    this.#sheet = sheet;
  }

  /**
   * Takes a place for a label. In motion it stays on its side as long as it can.
   * @param {string} label
   * @param {{ x: number, y: number, dx: number, dy: number }} wanted its point, and the wanted distance of its middle from the point
   * @param {number} width
   * @param {number} height
   * @returns {{ x: number, y: number, free: boolean }} its middle; the wanted one if no side is free
   */
  take(label, { x, y, dx, dy }, width, height) {
    const sheet = this.#sheet;
    const on = (/** @type {number} */ side) => ({
      x: within(x, x + SIDES[side][0] * dx, width / 2, sheet.width),
      y: within(y, y + SIDES[side][1] * dy, height / 2, sheet.height),
    });
    const free = (/** @type {number} */ side, room = 0) => this.#isFree(boxOf(on(side), width + room, height + room));
    const last = this.#moved.get(label) ?? 0;
    const back = last === 0 ? 0 : ROOM * height;
    const side = [0, last, ...SIDES.keys()].find((one, i) => free(one, i === 0 ? back : 0));
    if (side) this.#moved.set(label, side);
    else this.#moved.delete(label);
    const at = on(side ?? 0);
    const isFree = side !== undefined;
    if (isFree) this.#taken.push(boxOf(at, width, height));
    return { ...at, free: isFree };
  }

  /** @param {Box} box */
  #isFree(box) {
    return this.#taken.every((it) => box.right <= it.left || it.right <= box.left || box.bottom <= it.top || it.bottom <= box.top);
  }
}

/**
 * @param {number} point
 * @param {number} wanted
 * @param {number} half half of the label's size
 * @param {number} length of the sheet
 * @returns {number} the place on the sheet nearest to the wanted one, or the wanted one for a point off the sheet
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
