// Where the labels of a drawing stand: each where the drawing wants it, or, where another label is, on another side of its point.

/**
 * @typedef {import("assur/canvas/painter.js").Box} Box
 * @typedef {Readonly<{ width: number, height: number }>} Sheet in CSS pixels
 */

/**
 * Where about its point a label may stand, by factors of how far it is off it along x and y: where it is wanted comes first,
 * then the other sides, then farther off.
 */
const SIDES = Object.freeze([1, 2].flatMap((far) => [
  [far, far],
  [-far, -far],
  [far, -far],
  [-far, far],
]));

/** So much more room than it takes, in heights, there must be for a label to go back: else it would jump to and fro in motion. */
const ROOM = 1.5;

export class Places {
  /** @type {Box[]} those of the labels that were placed since the beginning */
  #taken = [];
  /** @type {Map<string, number>} the sides of the labels that are not where they are wanted */
  #moved = new Map();
  /** @type {Sheet} */
  #sheet = { width: 0, height: 0 };

  /**
   * All labels are going to be placed.
   * @param {Sheet} sheet that they stay on, if their points are
   */
  begin(sheet) {
    this.#taken = [];
    this.#sheet = sheet;
  }

  /**
   * Takes a place for a label. In motion it stays on its side for as long as it can.
   * @param {string} label
   * @param {{ x: number, y: number, dx: number, dy: number }} wanted a point, and how far from it its middle shall be
   * @param {number} width
   * @param {number} height
   * @returns {{ x: number, y: number, free: boolean }} its middle; where no side is free, that which is wanted
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
 * @param {number} half of what shall be there
 * @param {number} length of the sheet
 * @returns {number} the place nearest to the wanted one on the sheet; of a point farther off the sheet, that which is wanted
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
