// Labels at zeros, extrema and limit positions: a value and its input, placed without overlap, as far as there is room.
import { covered, isFree } from "assur/canvas/boxes.js";
import { textWidth } from "assur/canvas/text-width.js";
import { across, down } from "assur/plots/panel.js";
import { setChartFont } from "assur/plots/text.js";
import { axisValueText } from "assur/plots/units.js";

/**
 * @typedef {import("assur/types/web.js").MarkLayout} Mark
 * @typedef {import("assur/types/web.js").PanelLayout} Panel
 * @typedef {import("assur/state/model.js").Snapshot} Snapshot
 * @typedef {import("assur/canvas/boxes.js").Box} Box
 * @typedef {Box & Pick<Mark, "phi" | "value">} Label box of a label, with the place of its mark
 */

/**
 * Label of a mark, in pixels at the usual text size. `GAP`: its distance from the mark. `HEIGHT`: its height.
 * `FARTHER`: further distance of the alternative places above and below the mark.
 */
const GAP = 5;
const HEIGHT = 13;
const FARTHER = 11;

/** Space between labels side by side, in pixels. */
const BETWEEN = 4;

/** Distance between the points that represent the zero line, in pixels. */
const SPARSE = 12;

/** Greatest number of points of curves that a label may cover. A single point lies under a corner of the label. */
const MAX_COVERED = 1;

/** Height of a plot of several curves, for each curve, below which only the marks are drawn, in pixels. The cursor then shows the labels. */
const LOW = 70;

/**
 * @param {import("assur/canvas/painter.js").Context} context
 * @param {Panel} panel
 * @param {readonly Box[]} occupied places, such as that of the panel's title
 * @param {Snapshot} snapshot
 * @param {import("assur/canvas/theme.js").Theme} theme
 * @param {{ cursor?: boolean }} [by] `cursor`: whether a cursor can give the labels that are missing; on paper none can
 * @returns {Label[]} boxes of the labels
 */
export function drawMarks(context, panel, occupied, snapshot, theme, { cursor = true } = {}) {
  const curves = new Set(panel.marks.map(({ role }) => role)).size;
  if (cursor && curves > 1 && panel.height < LOW * theme.scale * curves) return [];
  const font = setChartFont(context, theme);
  context.textAlign = "left";
  context.textBaseline = "middle";
  context.lineJoin = "round";
  context.lineWidth = 3;
  context.strokeStyle = theme.colours.paper;
  const points = [...closer(panel.points), ...zeroLine(panel)];
  const taken = [...occupied, ...panel.marks.map((mark) => around(across(panel, mark.phi), down(panel, mark.value), 3 * theme.scale))];
  const labels = [];
  for (const mark of labelled(panel.marks)) {
    const text = markText(mark, panel, snapshot);
    const box = freePlace(panel, mark, textWidth(context, font, text), taken, points, theme.scale);
    if (!box) continue;
    labels.push({ ...box, phi: mark.phi, value: mark.value });
    taken.push({ ...box, left: box.left - BETWEEN, right: box.right + BETWEEN });
    const middle = (box.top + box.bottom) / 2;
    context.strokeText(text, box.left, middle);
    context.fillStyle = theme.inks[mark.role];
    context.fillText(text, box.left, middle);
  }
  return labels;
}

/**
 * Returns the marks in the order of labelling: extrema by falling absolute value, then zeros. Curves that are zero at
 * the same input share one mark.
 * @param {readonly Mark[]} marks
 * @returns {Mark[]}
 */
function labelled(marks) {
  const zeros = new Map();
  for (const mark of marks) {
    if (mark.kind !== "zero") continue;
    const shared = zeros.has(mark.phi);
    zeros.set(mark.phi, shared ? { ...mark, role: "secondary" } : mark);
  }
  const extrema = marks.filter(({ kind }) => kind !== "zero").sort((a, b) => Math.abs(b.value) - Math.abs(a.value));
  return [...extrema, ...zeros.values()];
}

/**
 * @param {Mark} mark
 * @param {Panel} panel
 * @param {Snapshot} snapshot
 */
function markText({ kind, phi, value }, panel, { coordinate, words }) {
  const angle = coordinate.text(phi, words, 1);
  return kind === "zero" ? angle : words.text("plots.mark", { value: axisValueText(panel, value, words.numbers), angle });
}

/** `CLOSE`: distance between added points of a steep curve. `NEIGHBOURS`: greatest distance along the axis of neighbours on a curve. In pixels. */
const CLOSE = 4;
const NEIGHBOURS = 8;

/**
 * @param {readonly number[]} points of curves, x and y of each point
 * @returns {number[]} the points, with others added between them where a curve is steep
 */
function closer(points) {
  const all = points.slice(0, 2);
  for (let i = 2; i < points.length; i += 2) {
    const [dx, dy] = [points[i] - points[i - 2], points[i + 1] - points[i - 1]];
    const steps = dx > 0 && dx <= NEIGHBOURS ? Math.ceil(Math.abs(dy) / CLOSE) : 1;
    for (let k = 1; k < steps; k++) all.push(points[i - 2] + (dx * k) / steps, points[i - 1] + (dy * k) / steps);
    all.push(points[i], points[i + 1]);
  }
  return all;
}

/** Greatest distance along the axis at which the cursor is at a mark, in pixels. */
const AT = 4;

/**
 * @param {Panel} panel
 * @param {string} role of a curve
 * @param {number} x place of the cursor, in pixels
 * @param {readonly Label[]} labels labels of the panel
 * @param {Snapshot} snapshot
 * @returns {string | null} text of the curve's mark at the cursor; null if there is none, or if it has a label
 */
export function textAtCursor(panel, role, x, labels, snapshot) {
  const off = (/** @type {Mark} */ { phi }) => Math.abs(across(panel, phi) - x);
  const [mark] = panel.marks.filter((one) => one.role === role && off(one) <= AT).sort((a, b) => off(a) - off(b));
  if (!mark || labels.some(({ phi, value }) => phi === mark.phi && value === mark.value)) return null;
  return markText({ ...mark, kind: "max" }, panel, snapshot);
}

/**
 * @param {Panel} panel
 * @returns {number[]} points along the zero line, x and y of each, which labels avoid like those of a curve
 */
function zeroLine({ left, width, y0, y1, top, height }) {
  if (y0 >= 0 || y1 <= 0) return [];
  const y = top + (height * y1) / (y1 - y0);
  return Array.from({ length: Math.floor(width / SPARSE) }, (_, i) => [left + i * SPARSE, y]).flat();
}

/**
 * Finds the place for a label near its mark, free of other labels and of the curves.
 * @param {Panel} panel
 * @param {Mark} mark
 * @param {number} width
 * @param {readonly Box[]} taken
 * @param {readonly number[]} points of the curves, x and y of each point
 * @param {number} scale text size relative to the usual one
 * @returns {Box | null} null if there is none
 */
function freePlace(panel, mark, width, taken, points, scale) {
  const [gap, height, farther] = [GAP, HEIGHT, FARTHER].map((pixels) => pixels * scale);
  const x = across(panel, mark.phi);
  const y = down(panel, mark.value);
  const [above, below] = [y - gap - height, y + gap];
  const upwards = [above, above - farther];
  const downwards = [below, below + farther];
  const tops = [...(mark.kind === "max" ? [...upwards, ...downwards] : [...downwards, ...upwards]), y - height / 2, y - height, y];
  const lefts = [x - width / 2, x - width / 4, x - (3 * width) / 4, x + gap, x - gap - width];
  const boxes = tops
    .filter((top) => top >= panel.top - height && top + height <= panel.top + panel.height + 3)
    .flatMap((top) => lefts.map((wanted) => {
      const left = Math.min(Math.max(wanted, panel.left + 2), panel.left + panel.width - width);
      return { left, top, right: left + width, bottom: top + height };
    }))
    .filter((box) => isFree(box, taken));
  return boxes.find((box) => covered(points, 2, box) <= MAX_COVERED) ?? null;
}

/**
 * @param {number} x
 * @param {number} y
 * @param {number} by half the side
 * @returns {Box} square with the centre (x, y)
 */
function around(x, y, by) {
  return { left: x - by, top: y - by, right: x + by, bottom: y + by };
}
