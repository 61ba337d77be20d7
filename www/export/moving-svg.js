// An animated SVG file, and several poses in one picture.
import { inputs, moments, others, targetOn } from "assur/export/moments.js";
import { Svg, SvgPath } from "assur/export/svg.js";

/**
 * @typedef {import("assur/app/page.js").Page} Page
 * @typedef {import("assur/canvas/theme.js").Theme} Theme
 * @typedef {import("assur/export/moments.js").Job} Job
 */

const SVG = "image/svg+xml";

/** Opacities of the poses other than the current one: they increase from `FAINT` to at most `STRONG`. */
const FAINT = 0.12;
const STRONG = 0.5;

/** Pixels of a PNG per CSS pixel. */
const SHARPNESS = 3;

/**
 * @param {Page} page
 * @param {Theme} theme
 * @param {import("assur/export/moments.js").Wishes} wishes
 * @param {Job} work
 * @param {string} title description of the picture
 * @returns {Promise<Blob>}
 */
export async function toMovingSvg(page, theme, { moments: count, width, seconds }, work, title) {
  const { size, begin } = page.mechanism.sheet();
  const svg = new Svg(size, title, width / size.width);
  const target = { context: svg, ratio: 1 };
  const { ground, moment } = begin(theme, () => new SvgPath());
  ground(target);
  let number = 0;
  for await (const here of moments(page, inputs(page, count), work)) {
    svg.moment(number, count, seconds);
    moment(target, here);
    svg.end();
    number += 1;
  }
  return new Blob([svg.toString()], { type: SVG });
}

/**
 * Paints poses of one period over one another, and finally the current pose with its labels.
 * @param {Page} page
 * @param {Theme} theme
 * @param {number} count
 * @param {Job} work
 * @param {string} title
 * @returns {Promise<Blob>}
 */
export async function posesAsSvg(page, theme, count, work, title) {
  const { size, begin } = page.mechanism.sheet();
  const svg = new Svg(size, title);
  const target = { context: svg, ratio: 1 };
  const { ground, moment } = begin(theme, () => new SvgPath());
  ground(target);
  for await (const [strength, here] of faded(page, count, work)) {
    svg.faded(strength);
    moment(target, here, false);
    svg.end();
  }
  begin(theme, () => new SvgPath()).moment(target);
  return new Blob([svg.toString()], { type: SVG });
}

/**
 * @param {Page} page
 * @param {Theme} theme
 * @param {number} count
 * @param {Job} work
 * @returns {Promise<Blob>}
 */
export async function posesAsPng(page, theme, count, work) {
  const { size, begin } = page.mechanism.sheet();
  const width = size.width * SHARPNESS;
  const canvas = new OffscreenCanvas(1, 1);
  const target = targetOn(canvas, size, width);
  const { ground, moment } = begin(theme);
  ground(target);
  const one = new OffscreenCanvas(1, 1);
  for await (const [strength, here] of faded(page, count, work)) {
    moment(targetOn(one, size, width, { alpha: true }), here, false);
    target.context.setTransform(1, 0, 0, 1, 0, 0);
    target.context.globalAlpha = strength;
    target.context.drawImage(one, 0, 0);
    target.context.globalAlpha = 1;
  }
  begin(theme).moment(target);
  return canvas.convertToBlob({ type: "image/png" });
}

/**
 * Yields the poses other than the current one, each with its opacity; the opacities increase.
 * @param {Page} page
 * @param {number} count
 * @param {Job} work
 * @returns {AsyncGenerator<[number, import("assur/export/pictures.js").Moment]>}
 */
async function* faded(page, count, work) {
  let number = 0;
  for await (const here of moments(page, others(page, count), work)) {
    number += 1;
    yield [FAINT + ((STRONG - FAINT) * number) / count, here];
  }
}
