// Marks painted over the drawing while it is edited: the selection, the points and links pressed so far, the line from
// the last press to the pointer, locked dimensions, the marks on the picture behind the drawing, and the text beside
// the pointer.
import { paintPointerText, pointerText } from "assur/drawing/pointer-text.js";
import { level } from "assur/drawing/tools.js";

/**
 * @typedef {{ page: import("assur/app/page.js").Page, work: import("assur/drawing/tools.js").Work, selection: import("assur/drawing/selection.js").Selection,
 *   hand: import("assur/drawing/hand.js").Hand, area: import("assur/drawing/axes.js").Area }} Drawn
 */

/** `RING`: radius of the ring around a point, in pixels. `OVER`: width of the line over a link, in pixels. */
const RING = 10;
const OVER = 12;
/** Radius of the ring around a link with only one point, such as a wheel or a block, in pixels. */
const WHEEL = 22;
/** Padlock of a locked dimension, in pixels. `LOCK`: its width. `AWAY`: its distance from the vertex of an angle. */
const LOCK = 9;
const AWAY = 24;
const DASHES = Object.freeze([6, 5]);

/**
 * @param {CanvasRenderingContext2D} context
 * @param {import("assur/canvas/transform.js").Transform} view
 * @param {import("assur/canvas/theme.js").Theme} theme
 * @param {Drawn} drawn
 */
export function paint(context, view, theme, { page, work, selection, hand, area }) {
  const pixels = new Map(page.mechanism.joints().map(({ name, x, y }) => [name, view.toScreen(x, y)]));
  const { links = [], locks = [] } = /** @type {Partial<import("assur/state/state.js").LinkageDocument>} */ (page.store.get().document);
  context.save();
  context.strokeStyle = theme.colours.crank;
  context.fillStyle = theme.colours.crank;
  context.lineJoin = "round";
  context.lineCap = "round";
  context.globalAlpha = 0.3;
  context.lineWidth = OVER * theme.weight;
  for (const { name, points } of links) {
    if (!selection.links.has(name) && !work.pressed.some(({ point, link }) => point === null && link === name)) continue;
    const corners = points.flatMap((point) => pixels.get(point) ?? []);
    if (corners.length === 2) ring(context, corners, WHEEL * theme.weight);
    context.beginPath();
    for (let k = 0; k < corners.length; k += 2) context.lineTo(corners[k], corners[k + 1]);
    context.closePath();
    context.stroke();
  }
  context.globalAlpha = 1;
  context.lineWidth = 2 * theme.weight;
  for (const name of [...selection.points, ...work.pressed.map(({ point }) => point ?? "")]) {
    const pixel = pixels.get(name);
    if (pixel) ring(context, pixel, RING * theme.weight);
  }
  for (const lock of locks) {
    const at = lock.flatMap((name) => [pixels.get(name) ?? []]);
    if (at.some((pixel) => pixel.length < 2)) continue;
    // The padlock of a length is in the middle of the length; that of an angle is near the vertex, between the sides.
    const [from, to] = [at[0], at[at.length - 1]];
    const middle = [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2];
    padlock(context, at.length === 2 ? middle : toward(at[1], middle, AWAY * theme.weight), theme);
  }
  const last = work.pressed.at(-1);
  if (hand.over && last) {
    const from = (last.point && pixels.get(last.point)) || view.toScreen(...last.at);
    // A guide that is nearly horizontal or vertical becomes exactly so.
    const to = work.tool === "slide" ? level(last.at, hand.over) : hand.over;
    context.setLineDash([...DASHES]);
    context.beginPath();
    context.moveTo(...from);
    context.lineTo(...view.toScreen(...to));
    context.stroke();
  }
  if (work.tool === "picture") {
    const marks = work.picture.marks.map(([x, y]) => view.toScreen(x, y));
    for (const mark of marks) ring(context, mark, RING / 2 * theme.weight);
    context.beginPath();
    for (const mark of marks) context.lineTo(...mark);
    context.stroke();
  }
  if (hand.over && (work.tool !== "select" || hand.keyed)) {
    context.setLineDash([]);
    ring(context, view.toScreen(...hand.over), 3 * theme.weight);
  }
  const at = hand.held ?? (hand.over && (work.tool !== "select" || hand.keyed) ? hand.over : null);
  if (at && work.tool !== "picture") {
    const guide = work.tool === "slide";
    const from = hand.held || !last ? null : last.at;
    context.setLineDash([]);
    paintPointerText(context, pointerText(guide && from ? level(from, at) : at, from, !guide, page.words), view.toScreen(...at), area, theme);
  }
  if (hand.frame) {
    const [[left, top], [right, bottom]] = hand.frame.map(([x, y]) => view.toScreen(x, y));
    context.setLineDash([...DASHES]);
    context.strokeRect(left, top, right - left, bottom - top);
  }
  context.restore();
}

/**
 * @param {readonly number[]} from
 * @param {readonly number[]} to
 * @param {number} way distance in pixels
 * @returns {number[]} the pixel at that distance from `from` towards `to`, or above `from` if both coincide
 */
function toward([x, y], [left, top], way) {
  const length = Math.hypot(left - x, top - y);
  return length > 1 ? [x + ((left - x) * way) / length, y + ((top - y) * way) / length] : [x, y - way];
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {readonly number[]} middle of the padlock
 * @param {import("assur/canvas/theme.js").Theme} theme
 */
function padlock(context, [left, top], { colours, weight }) {
  const size = LOCK * weight;
  context.save();
  context.setLineDash([]);
  context.lineWidth = 1.5 * weight;
  context.strokeStyle = colours.ink;
  context.beginPath();
  context.arc(left, top - 0.1 * size, 0.33 * size, Math.PI, 0);
  context.stroke();
  context.fillStyle = colours.paper;
  context.beginPath();
  context.rect(left - 0.5 * size, top - 0.1 * size, size, 0.75 * size);
  context.fill();
  context.stroke();
  context.restore();
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {readonly number[]} middle
 * @param {number} radius
 */
function ring(context, [left, top], radius) {
  context.beginPath();
  context.arc(left, top, radius, 0, 2 * Math.PI);
  context.stroke();
}
