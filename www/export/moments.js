// Moments of one period of a motion, for several poses in one picture, or for an animation that repeats without a jump.
import { Refusal, attempt } from "assur/core/problem.js";

/**
 * @typedef {import("assur/export/pictures.js").Moment} Moment
 * @typedef {import("assur/app/page.js").Page} Page
 * @typedef {{ readonly moments: number, readonly width: number, readonly seconds: number, readonly plots?: boolean }} Wishes number of moments, width in pixels,
 * duration of a period in seconds, and whether the plots stand beside the drawing
 * @typedef {{ readonly signal: AbortSignal, tell: (share: number) => void }} Job work that can be cancelled and reports its progress
 */

/** Tolerance within which an input beyond the end of an arc counts as on the arc, in the engine's unit. */
const END_TOLERANCE = 1e-9;

/**
 * @param {Page} page
 * @param {number} count
 * @returns {number[]} inputs over one period, in the engine's unit, at equal steps. A full cycle starts at the current
 * input; a rocking crank or a slide goes to the end of its arc and back; time only goes forward
 */
export function inputs({ model: { summary, coordinate }, store }, count) {
  if (summary.moves === null) return [];
  const { start, end, full, arcs } = summary.cycle;
  const here = coordinate.input(coordinate.of(store.get()));
  const steps = Array.from({ length: count }, (_, number) => number / count);
  if (full) return steps.map((step) => start + modulo(here - start + step * (end - start), end - start));
  const [from, to] = arcs.find(([first, last]) => here >= first - END_TOLERANCE && here <= last + END_TOLERANCE) ?? arcs[0] ?? [start, end];
  // Time does not run backwards.
  if (summary.moves === "time") return steps.map((step) => from + step * (to - from));
  return steps.map((step) => from + (to - from) * (1 - Math.abs(1 - 2 * step)));
}

/**
 * @param {number} value
 * @param {number} period
 */
function modulo(value, period) {
  return value - period * Math.floor(value / period);
}

/**
 * Finds the inputs of `count` − 1 distinct poses over a period, to be shown together with the current pose.
 * @param {Page} page
 * @param {number} count
 * @returns {number[]}
 */
export function others(page, count) {
  const { summary } = page.model;
  if (summary.moves === null) return [];
  if (summary.cycle.full || summary.moves === "time") return inputs(page, count).slice(1);
  const steps = count - 2;
  return inputs(page, 2 * steps).slice(0, steps + 1);
}

/**
 * Yields the moments of the present mechanism in turn. Between two moments the page may do other work. Throws an `AbortError` if the mechanism
 * is replaced meanwhile, and a `Refusal` if it cannot be assembled at any of the inputs.
 * @param {Page} page
 * @param {readonly number[]} inputs of the engine
 * @param {Job} work
 * @returns {AsyncGenerator<Moment>}
 */
export function moments(page, inputs, work) {
  return momentsOf(page.model.lastAccepted.document, page, inputs, work);
}

/**
 * @param {Page["model"]["lastAccepted"]["document"]} document of the mechanism
 * @param {Page} page
 * @param {readonly number[]} inputs
 * @param {Job} work
 * @returns {AsyncGenerator<Moment>}
 */
async function* momentsOf(document, page, inputs, { signal, tell }) {
  let found = false;
  /** @type {readonly import("assur/core/problem.js").Problem[]} */
  let why = [];
  for (const [number, input] of inputs.entries()) {
    await breath();
    signal.throwIfAborted();
    // If the mechanism has been replaced, further moments would not belong to this motion.
    if (page.model.lastAccepted.document !== document) throw new DOMException("", "AbortError");
    const { value, problems } = attempt(() => page.engine.at(input));
    if (value) found = true;
    else why = problems;
    if (value) yield { frame: value.frame, frameInput: input, readouts: value.readouts, plotted: value.plotted, compared: page.engine.compared(input) };
    tell((number + 1) / inputs.length);
  }
  if (!found) throw new Refusal([...why]);
}

/** @returns {Promise<void>} resolves after the page has done its pending work */
function breath() {
  const channel = new MessageChannel();
  return new Promise((resolve) => {
    channel.port1.onmessage = () => {
      channel.port1.close();
      resolve();
    };
    channel.port2.postMessage(null);
  });
}

/**
 * @param {HTMLCanvasElement | OffscreenCanvas} canvas
 * @param {import("assur/stage/figure.js").Size} size of the sheet
 * @param {number} width wanted width in pixels
 * @param {CanvasRenderingContext2DSettings} [settings]
 * @returns {{ context: import("assur/canvas/painter.js").Context & CanvasRenderingContext2D, ratio: number }}
 */
export function targetOn(canvas, size, width, settings = { alpha: false }) {
  const ratio = width / size.width;
  // Video formats require even numbers of pixels. Rounding down keeps all pixels on the sheet.
  const even = (/** @type {number} */ pixels) => Math.max(2 * Math.floor(pixels / 2), 2);
  canvas.width = even(width);
  canvas.height = even(size.height * ratio);
  const context = /** @type {CanvasRenderingContext2D | null} */ (canvas.getContext("2d", settings));
  if (!context) throw new Error("no 2d context");
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  return { context, ratio };
}
