// What is painted over a drawing while it is drawn: what is selected, what was pressed, the next bar.

/**
 * @typedef {{ page: import("assur/app/page.js").Page, work: import("assur/drawing/tools.js").Work, selection: import("assur/drawing/selection.js").Selection,
 *   hand: import("assur/drawing/hand.js").Hand }} Drawn
 */

/** Radius of the ring around a point, width of the line over a link, in pixels. */
const RING = 10;
const OVER = 12;
const DASHES = Object.freeze([6, 5]);

/**
 * @param {CanvasRenderingContext2D} context
 * @param {import("assur/canvas/transform.js").Transform} view
 * @param {import("assur/canvas/theme.js").Theme} theme
 * @param {Drawn} drawn
 */
export function paint(context, view, theme, { page, work, selection, hand }) {
  const places = new Map(page.mechanism.joints().map(({ name, x, y }) => [name, view.toScreen(x, y)]));
  const { links = [] } = /** @type {Partial<import("assur/state/state.js").LinkageDocument>} */ (page.store.get().document);
  context.save();
  context.strokeStyle = theme.colours.crank;
  context.fillStyle = theme.colours.crank;
  context.lineJoin = "round";
  context.lineCap = "round";
  context.globalAlpha = 0.3;
  context.lineWidth = OVER * theme.weight;
  for (const { name, points } of links) {
    if (!selection.links.has(name) && !work.pressed.some(({ point, link }) => point === null && link === name)) continue;
    const corners = points.flatMap((point) => places.get(point) ?? []);
    context.beginPath();
    for (let k = 0; k < corners.length; k += 2) context.lineTo(corners[k], corners[k + 1]);
    context.closePath();
    context.stroke();
  }
  context.globalAlpha = 1;
  context.lineWidth = 2 * theme.weight;
  for (const name of [...selection.points, ...work.pressed.map(({ point }) => point ?? "")]) {
    const place = places.get(name);
    if (place) ring(context, place, RING * theme.weight);
  }
  const last = work.pressed.at(-1);
  if (hand.over && last) {
    const from = (last.point && places.get(last.point)) || view.toScreen(...last.at);
    context.setLineDash([...DASHES]);
    context.beginPath();
    context.moveTo(...from);
    context.lineTo(...view.toScreen(...hand.over));
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
  if (hand.frame) {
    const [[left, top], [right, bottom]] = hand.frame.map(([x, y]) => view.toScreen(x, y));
    context.setLineDash([...DASHES]);
    context.strokeRect(left, top, right - left, bottom - top);
  }
  context.restore();
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {readonly number[]} place
 * @param {number} radius
 */
function ring(context, [left, top], radius) {
  context.beginPath();
  context.arc(left, top, radius, 0, 2 * Math.PI);
  context.stroke();
}
