// The labels at limit positions and extrema: a value and its angle, placed where no label covers another.
import { degrees } from "assur/angles.js";
import { attempt } from "assur/engine.js";
import { READOUT_OF, across, down, shows } from "assur/panels.js";

/**
 * @typedef {import("assur/engine.js").Engine} Engine
 * @typedef {import("assur/engine.js").Panel} Panel
 * @typedef {import("assur/engine.js").Series} Series
 * @typedef {import("assur/engine.js").Summary} Summary
 * @typedef {import("assur/words.js").Words} Words
 * @typedef {{ series: Series, phi: number, value: number, upward: boolean }} Mark
 * @typedef {{ phi: number, readouts: import("assur/engine.js").Readouts }} Sample
 * @typedef {{ left: number, top: number, right: number, bottom: number }} Box
 */

/** Sizes in pixels: from a mark to its label, height of a label, a second try farther off, between samples. */
const GAP = 5;
const HEIGHT = 13;
const FARTHER = 11;
const SAMPLE = 5;

/** A label that would cover more points of the curves than this is left out. */
const MOST_COVERED = 4;

/**
 * @param {Summary} summary
 * @param {Panel} panel
 * @param {Engine} engine
 * @returns {Mark[]} the widest swings first
 */
export function marksOf(summary, panel, engine) {
  const marks = panel.order === 0 ? limitMarks(summary, engine) : [];
  for (const { series, order, kind, phi, value } of summary.extrema) {
    if (order === panel.order) marks.push({ series, phi, value, upward: kind === "max" });
  }
  return marks.filter(({ value }) => shows(panel, value)).sort((a, b) => Math.abs(b.value) - Math.abs(a.value));
}

/**
 * @param {Summary} summary
 * @param {Engine} engine
 * @returns {Mark[]}
 */
function limitMarks({ limits }, engine) {
  const read = limits.map(({ phi }) => ({ phi, readouts: attempt(() => engine.readouts(phi)).value }));
  /** @type {Mark[]} */
  const marks = [];
  for (const series of /** @type {const} */ (["rocker", "wheel5"])) {
    const values = read.flatMap(({ phi, readouts }) => (readouts ? [{ phi, value: readouts[READOUT_OF[series][0]] }] : []));
    const middle = values.reduce((sum, { value }) => sum + value, 0) / values.length;
    for (const { phi, value } of values) marks.push({ series, phi, value, upward: value > middle });
  }
  return marks;
}

/**
 * @param {Engine} engine
 * @param {Panel} panel
 * @returns {Sample[]} points of the curves close enough to keep labels off them
 */
export function sampleCurves(engine, { x0, x1, width }) {
  const count = Math.max(Math.ceil(width / SAMPLE), 1);
  const samples = [];
  for (let i = 0; i <= count; i++) {
    const phi = x0 + ((x1 - x0) * i) / count;
    const readouts = attempt(() => engine.readouts(phi)).value;
    if (readouts) samples.push({ phi, readouts });
  }
  return samples;
}

/**
 * @param {CanvasRenderingContext2D} context with the font of the labels
 * @param {Panel} panel
 * @param {readonly Mark[]} marks
 * @param {readonly Sample[]} samples
 * @param {Box} title the place of the panel's title
 * @param {Words} words
 * @param {(mark: Mark) => string} colour
 * @param {string} paper
 */
export function drawMarks(context, panel, marks, samples, title, words, colour, paper) {
  context.textAlign = "left";
  context.textBaseline = "middle";
  context.lineJoin = "round";
  context.lineWidth = 3;
  context.strokeStyle = paper;
  const curves = samples.flatMap(({ phi, readouts }) =>
    panel.series.map(({ name }) => ({
      x: across(panel, phi),
      y: down(panel, readouts[READOUT_OF[name][panel.order]]),
    })),
  );
  const taken = [title, ...marks.map((mark) => around(across(panel, mark.phi), down(panel, mark.value)))];
  for (const mark of marks) {
    const text = markText(mark, panel, words);
    const box = freePlace(panel, mark, context.measureText(text).width, taken, curves);
    if (!box) continue;
    taken.push(box);
    const middle = (box.top + box.bottom) / 2;
    context.strokeText(text, box.left, middle);
    context.fillStyle = colour(mark);
    context.fillText(text, box.left, middle);
  }
}

/**
 * @param {Mark} mark
 * @param {Panel} panel
 * @param {Words} words
 */
function markText({ phi, value }, panel, words) {
  const written = panel.order === 0 ? `${words.numbers.fixed(degrees(value), 1)}°` : words.numbers.fixed(value, 3);
  return words.text("plots.mark", { value: written, angle: `${words.numbers.fixed(degrees(phi), 1)}°` });
}

/**
 * The place near a mark that covers nothing, or least of the curves.
 * @param {Panel} panel
 * @param {Mark} mark
 * @param {number} width
 * @param {readonly Box[]} taken
 * @param {readonly { x: number, y: number }[]} curves
 * @returns {Box | null} null where every place is taken
 */
function freePlace(panel, mark, width, taken, curves) {
  const x = across(panel, mark.phi);
  const y = down(panel, mark.value);
  const [above, below] = [y - GAP - HEIGHT, y + GAP];
  const tops = mark.upward ? [above, above - FARTHER, below, below + FARTHER] : [below, below + FARTHER, above, above - FARTHER];
  const lefts = [x - width / 2, x - width / 4, x - (3 * width) / 4, x + GAP, x - GAP - width];
  let best = null;
  let least = MOST_COVERED + 1;
  for (const top of tops) {
    if (top < panel.top - HEIGHT || top + HEIGHT > panel.top + panel.height + 3) continue;
    for (const wanted of lefts) {
      const left = Math.min(Math.max(wanted, panel.left + 2), panel.left + panel.width - width);
      const box = { left, top, right: left + width, bottom: top + HEIGHT };
      if (taken.some((other) => overlap(box, other))) continue;
      const covered = curves.filter((point) => overlap(box, around(point.x, point.y, 1))).length;
      if (covered >= least) continue;
      least = covered;
      best = box;
    }
  }
  return best;
}

/**
 * @param {number} x
 * @param {number} y
 * @param {number} [by]
 * @returns {Box}
 */
function around(x, y, by = 3) {
  return { left: x - by, top: y - by, right: x + by, bottom: y + by };
}

/**
 * @param {Box} a
 * @param {Box} b
 */
function overlap(a, b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}
