// Labels at zeros, extrema and limit positions: a value and its input, placed without overlap.
import { cheapest, covered, isFree } from "assur/canvas/boxes.js";
import { textWidth } from "assur/canvas/text-width.js";
import { across, down } from "assur/plots/panel.js";
import { setChartFont } from "assur/plots/text.js";
import { axisValueText } from "assur/plots/units.js";

/**
 * @typedef {import("assur/types/web.js").MarkLayout} Mark
 * @typedef {import("assur/types/web.js").PanelLayout} Panel
 * @typedef {import("assur/state/model.js").Snapshot} Snapshot
 * @typedef {import("assur/canvas/boxes.js").Box} Box
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

/** Greatest number of points of curves that a label may cover. */
const MAX_COVERED = 4;

/**
 * @param {import("assur/canvas/painter.js").Context} context
 * @param {Panel} panel
 * @param {readonly Box[]} occupied places, such as that of the panel's title
 * @param {Snapshot} snapshot
 * @param {import("assur/canvas/theme.js").Theme} theme
 * @returns {Box[]} boxes of the labels
 */
export function drawMarks(context, panel, occupied, snapshot, theme) {
  const font = setChartFont(context, theme);
  context.textAlign = "left";
  context.textBaseline = "middle";
  context.lineJoin = "round";
  context.lineWidth = 3;
  context.strokeStyle = theme.colours.paper;
  const points = [...panel.points, ...zeroLine(panel)];
  const taken = [...occupied, ...panel.marks.map((mark) => around(across(panel, mark.phi), down(panel, mark.value), 3 * theme.scale))];
  const labels = [];
  for (const mark of labelled(panel.marks)) {
    const text = markText(mark, panel, snapshot);
    const box = freePlace(panel, mark, textWidth(context, font, text), taken, points, theme.scale);
    if (!box) continue;
    labels.push(box);
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
 * Finds the place for a label near its mark: free of other labels, and with the fewest covered points of the curves.
 * @param {Panel} panel
 * @param {Mark} mark
 * @param {number} width
 * @param {readonly Box[]} taken
 * @param {readonly number[]} points of the curves, x and y of each point
 * @param {number} scale text size relative to the usual one
 * @returns {Box | null} null if every place is taken
 */
function freePlace(panel, mark, width, taken, points, scale) {
  const [gap, height, farther] = [GAP, HEIGHT, FARTHER].map((pixels) => pixels * scale);
  const x = across(panel, mark.phi);
  const y = down(panel, mark.value);
  const [above, below] = [y - gap - height, y + gap];
  const tops = mark.kind === "max" ? [above, above - farther, below, below + farther] : [below, below + farther, above, above - farther];
  const lefts = [x - width / 2, x - width / 4, x - (3 * width) / 4, x + gap, x - gap - width];
  const cost = (/** @type {Box} */ box) => covered(points, 2, box);
  const boxes = tops
    .filter((top) => top >= panel.top - height && top + height <= panel.top + panel.height + 3)
    .flatMap((top) => lefts.map((wanted) => {
      const left = Math.min(Math.max(wanted, panel.left + 2), panel.left + panel.width - width);
      return { left, top, right: left + width, bottom: top + height };
    }))
    .filter((box) => isFree(box, taken) && cost(box) <= MAX_COVERED);
  return boxes.length > 0 ? cheapest(boxes, cost) : null;
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
