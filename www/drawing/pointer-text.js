// Text beside the pointer while the reader draws: its coordinates, and the length and angle of the link being drawn.
import { degrees } from "assur/core/angles.js";

/**
 * @typedef {readonly [number, number]} Point in the model
 * @typedef {import("assur/core/words.js").Words} Words
 */

/** `AWAY`: distance of the text from the pointer. `PAD`: space around the text. `SIZE`: height of the text. In pixels. */
const AWAY = 16;
const PAD = 5;
const SIZE = 13;

/**
 * @param {Point} at place of the pointer, on the grid
 * @param {Point | null} from start of the link or guide being drawn
 * @param {boolean} isLink whether a link is drawn, which has a length; a guide has none
 * @param {Words} words
 * @returns {string[]} lines of text
 */
export function pointerText([x, y], from, isLink, words) {
  const { numbers } = words;
  const place = `x ${numbers.short(x)}   y ${numbers.short(y)}`;
  if (!from) return [place];
  const [dx, dy] = [x - from[0], y - from[1]];
  const length = Math.hypot(dx, dy);
  if (length === 0) return [place];
  const angle = `φ ${numbers.fixed(degrees(Math.atan2(dy, dx)), 1)}°`;
  return [isLink ? `l ${words.length(numbers.short(length))}   ${angle}` : angle, place];
}

/**
 * Paints lines of text beside a pixel, on the side with room.
 * @param {CanvasRenderingContext2D} context
 * @param {readonly string[]} lines
 * @param {readonly [number, number]} pixel
 * @param {import("assur/drawing/axes.js").Area} area
 * @param {import("assur/canvas/theme.js").Theme} theme
 */
export function paintPointerText(context, lines, [x, y], area, { colours, scale, font }) {
  context.save();
  const size = SIZE * scale;
  context.font = `${size}px ${font}`;
  const width = Math.max(...lines.map((line) => context.measureText(line).width)) + 2 * PAD;
  const height = lines.length * 1.3 * size + 2 * PAD;
  const left = x + AWAY + width <= area.right ? x + AWAY : x - AWAY - width;
  const top = y - AWAY - height >= area.top ? y - AWAY - height : y + AWAY;
  context.globalAlpha = 0.9;
  context.fillStyle = colours.paper;
  context.fillRect(left, top, width, height);
  context.globalAlpha = 1;
  context.fillStyle = colours.ink;
  context.textAlign = "left";
  context.textBaseline = "middle";
  lines.forEach((line, k) => context.fillText(line, left + PAD, top + PAD + (k + 0.5) * 1.3 * size));
  context.restore();
}
