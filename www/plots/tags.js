// Placement of the numbers, or tags, beside the cursor's line: clear of each other and, if possible, of the labels.
import { cheapest, isFree } from "assur/canvas/boxes.js";

/** @typedef {import("assur/canvas/boxes.js").Box} Box */

/** Greatest shift of a tag to avoid labels, in tag heights: farther off, it would seem to be another curve's. */
const FARTHEST = 3;

/** Space between two tags, in pixels. */
const APART = 2;

/**
 * @param {CanvasRenderingContext2D} context with the font of the plots
 * @param {{ left: number, top: number, width: number, tall: number }} box
 * @param {{ text: string, colour: string, ink: string }} tag
 * @param {import("assur/canvas/theme.js").Theme} theme
 */
export function paintTag(context, { left, top, width, tall }, { text, colour, ink }, theme) {
  context.textAlign = "left";
  context.textBaseline = "middle";
  context.beginPath();
  context.roundRect(left, top, width, tall, 5);
  context.fillStyle = theme.colours.paper;
  context.fill();
  context.lineWidth = 1;
  context.strokeStyle = colour;
  context.stroke();
  context.fillStyle = ink;
  context.fillText(text, left + 5, top + tall / 2 + 0.5);
}

/**
 * @typedef {object} Tags
 * @property {readonly number[]} middles y of the tags' middles if nothing is in the way, in ascending order
 * @property {readonly number[]} widths
 * @property {number} tall height of a tag
 * @property {number} x x of the cursor's line
 * @property {number} off distance of the tags from the line
 * @property {Box} room area for the tags
 * @property {readonly Box[]} labels labels to avoid
 */

/**
 * @param {Tags} tags
 * @returns {readonly Box[]} places of the tags: to the right of the line, or to the left if they do not fit on the
 * right or cover fewer labels on the left
 */
export function placedTags(tags) {
  const { widths, x, off, room } = tags;
  const widest = Math.max(...widths);
  const sides = [];
  if (x + off + widest <= room.right) sides.push(aside(tags, widths.map(() => x + off)));
  if (sides.length === 0 || (sides[0].covered > 0 && x - off - widest >= room.left)) {
    sides.push(aside(tags, widths.map((width) => x - off - width)));
  }
  return cheapest(sides, ({ covered }) => covered).boxes;
}

/**
 * @param {Tags} tags
 * @param {readonly number[]} lefts
 * @returns `boxes`: places of the tags on one side; `covered`: number of tags that cover a label
 */
function aside({ middles, widths, tall, room, labels }, lefts) {
  const at = (/** @type {number} */ i, /** @type {number} */ top) => ({ left: lefts[i], top, right: lefts[i] + widths[i], bottom: top + tall });
  const own = middles.map((middle) => middle - tall / 2);
  const free = (/** @type {number} */ i, first = room.top, last = room.bottom) => freeTop(at(i, own[i]), labels, first, last);
  const apart = (/** @type {readonly number[]} */ tops) => spread(tops, room.top, room.bottom, tall);
  const down = own.reduce((/** @type {number[]} */ tops, _, i) => [...tops, free(i, i > 0 ? tops[i - 1] + tall + APART : room.top)], []);
  const up = own.reduceRight((/** @type {number[]} */ tops, _, i) => [free(i, room.top, tops.length > 0 ? tops[0] - APART : room.bottom), ...tops], []);
  const ways = [apart(own), apart(own.map((_, i) => free(i))), apart(down), apart(up)];
  const candidates = ways.map((tops) => {
    const boxes = tops.map((top, i) => at(i, top));
    return { boxes, covered: boxes.filter((tag) => !isFree(tag, labels)).length };
  });
  return cheapest(candidates, ({ covered }) => covered);
}

/**
 * @param {Box} tag
 * @param {readonly Box[]} labels
 * @param {number} first
 * @param {number} last
 * @returns {number} the nearest top between first and last at which the tag covers no label, or its own top if none is near
 */
function freeTop(tag, labels, first, last) {
  const tall = tag.bottom - tag.top;
  const edges = labels.flatMap(({ top, bottom }) => [top - tall - 1, bottom + 1]);
  const near = [tag.top, first, last - tall, ...edges].filter((top) => top >= first && top + tall <= last && Math.abs(top - tag.top) <= FARTHEST * tall);
  const free = near.filter((top) => isFree({ ...tag, top, bottom: top + tall }, labels)).sort((a, b) => Math.abs(a - tag.top) - Math.abs(b - tag.top));
  return free[0] ?? tag.top;
}

/**
 * @param {readonly number[]} tops in ascending order
 * @param {number} first
 * @param {number} last
 * @param {number} tall the height of a tag
 * @returns {number[]} tops as near to the given ones as possible, without overlap of tags and between first and last
 */
function spread(tops, first, last, tall) {
  const step = tall + APART;
  // Tags that would overlap form a block around the mean of their positions.
  /** @type {{ sum: number, count: number }[]} */
  const blocks = [];
  tops.forEach((top, i) => {
    let block = { sum: top - i * step, count: 1 };
    for (let before = blocks.at(-1); before && before.sum / before.count > block.sum / block.count; before = blocks.at(-1)) {
      block = { sum: before.sum + block.sum, count: before.count + block.count };
      blocks.pop();
    }
    blocks.push(block);
  });
  const lowest = Math.max(first, last - tall - (tops.length - 1) * step);
  const apart = blocks.flatMap(({ sum, count }) => Array(count).fill(Math.min(Math.max(sum / count, first), lowest)));
  return apart.map((top, i) => top + i * step);
}
