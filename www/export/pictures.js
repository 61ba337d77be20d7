// Drawing and plots as separate pictures: the content of the screen, painted by the same code in the colours of light paper.
import { textWidth } from "assur/canvas/text-width.js";
import { Theme } from "assur/canvas/theme.js";
import { make } from "assur/core/dom.js";
import { symbol } from "assur/core/symbols.js";
import { Svg, SvgPath } from "assur/export/svg.js";
import { setChartFont } from "assur/plots/text.js";

/**
 * @typedef {import("assur/stage/figure.js").Size} Size
 * @typedef {import("assur/canvas/painter.js").Target} Target
 * @typedef {{ readonly size: Size, paint: (target: Target, theme: Theme, newPath?: () => Path2D) => void }} Picture
 * @typedef {Pick<import("assur/stage/figure.js").Snapshot, "frame" | "frameInput" | "readouts" | "compared"> & { readonly plotted?: Float64Array | null }} Moment state of the mechanism at one input
 * @typedef {object} Sheet picture of the mechanism that can be painted at any input
 * @property {Size} size
 * @property {(theme: Theme, newPath?: () => Path2D, places?: import("assur/canvas/places.js").Places) => Drawing} begin begins a series of paintings with labels in the same places
 * @typedef {object} Drawing
 * @property {(target: Target) => void} ground paints the fixed shapes
 * @property {(target: Target, here?: Moment, labelled?: boolean) => void} moment paints the moving shapes, by default at the current input
 */

const SVG = "image/svg+xml";

/** Pixels of a PNG per CSS pixel: sharp in print and on a projector. */
const SHARPNESS = 3;

/**
 * Legend above the plots, in pixels. `ROW`: height of a row. `SAMPLE`: length of the sample of a curve. `ROOM`: space
 * between the sample and its text. `LEFT`: left edge.
 */
const ROW = 20;
const SAMPLE = 22;
const ROOM = 7;
const LEFT = 44;

/** Size of the text under a drawing, in pixels. */
const CAPTION = 14;

/** @type {Theme | null} */
let paper = null;

/**
 * Returns the theme for print, with light paper whatever the theme of the page.
 * @param {readonly string[]} roles
 */
export function paperTheme(roles) {
  if (!paper) {
    const sample = make("div", { class: "paper", hidden: "" });
    document.body.append(sample);
    paper = new Theme(roles, () => {}, sample);
  }
  return paper;
}

/**
 * @param {Picture} picture
 * @param {Theme} theme
 * @param {string} title description of the picture
 */
export function toSvg(picture, theme, title) {
  return new Blob([svgText(picture, theme, title)], { type: SVG });
}

/**
 * Makes an SVG element of the picture, to be inserted in a page.
 * @param {Picture} picture
 * @param {Theme} theme
 * @param {string} title description of the picture
 * @returns {Element}
 */
export function toSvgElement(picture, theme, title) {
  return new DOMParser().parseFromString(svgText(picture, theme, title), SVG).documentElement;
}

/**
 * @param {Picture} picture
 * @param {Theme} theme
 * @param {string} title
 */
function svgText(picture, theme, title) {
  const svg = new Svg(picture.size, title);
  picture.paint({ context: svg, ratio: 1 }, theme, () => new SvgPath());
  return svg.toString();
}

/**
 * @param {Picture} picture
 * @param {Theme} theme
 * @returns {Promise<Blob>}
 */
export function toPng(picture, theme) {
  const { width, height } = picture.size;
  const canvas = new OffscreenCanvas(width * SHARPNESS, height * SHARPNESS);
  const context = canvas.getContext("2d", { alpha: false });
  if (!context) throw new Error("no 2d context");
  context.setTransform(SHARPNESS, 0, 0, SHARPNESS, 0, 0);
  picture.paint({ context, ratio: SHARPNESS }, theme);
  return canvas.convertToBlob({ type: "image/png" });
}

/**
 * Makes a picture of the drawing with a line of text below.
 * @param {import("assur/stage/view.js").MechanismView} mechanism
 * @param {Theme} theme
 * @param {string} text
 * @returns {Picture}
 */
export function withCaption(mechanism, theme, text) {
  const measure = blank();
  const measured = textWidth(measure, setChartFont(measure, theme, CAPTION), text);
  const { size: { width, height }, paint } = mechanism.cropped(Math.ceil(measured) + 2 * ROOM);
  const size = { width, height: height + 2 * ROW };
  /** @type {Picture["paint"]} */
  const withText = (target, its, newPath) => {
    const { context, ratio } = target;
    paint(target, its, newPath);
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.fillStyle = its.colours.paper;
    context.fillRect(0, height, width, 2 * ROW);
    setChartFont(context, its, CAPTION);
    context.textAlign = "center";
    context.textBaseline = "middle";
    context.fillStyle = its.colours.ink;
    context.fillText(text, width / 2, height + ROW);
  };
  return { size, paint: withText };
}

/** Makes a context for measuring text. */
function blank() {
  const context = new OffscreenCanvas(1, 1).getContext("2d");
  if (!context) throw new Error("no 2d context");
  return context;
}

/**
 * Makes a picture of the plots with a legend of their curves above. On the page, a table explains the colours; it is
 * not exported.
 * @param {import("assur/plots/chart.js").ChartView} chart
 * @param {Theme} theme
 * @param {import("assur/core/words.js").Words} words
 * @returns {Picture}
 */
export function withLegend(chart, theme, words) {
  const { width, height } = chart.size;
  const { entries, rows } = legend(chart, theme, words);
  const below = rows * ROW;
  const size = { width, height: height + below };
  const paint = (/** @type {Target} */ { context, ratio }) => {
    context.fillStyle = theme.colours.paper;
    context.fillRect(0, 0, size.width, size.height);
    setChartFont(context, theme, 12);
    context.textAlign = "left";
    context.textBaseline = "middle";
    context.lineWidth = 2;
    for (const { text, role, left, row } of entries) {
      const middle = (row + 0.5) * ROW;
      context.strokeStyle = theme.colours[role];
      context.beginPath();
      context.moveTo(left, middle);
      context.lineTo(left + SAMPLE, middle);
      context.stroke();
      context.fillStyle = theme.colours.ink;
      context.fillText(text, left + SAMPLE + ROOM, middle);
    }
    context.setTransform(ratio, 0, 0, ratio, 0, below * ratio);
    chart.paint({ context, ratio }, theme);
  };
  return { size, paint };
}

/**
 * @param {import("assur/plots/chart.js").ChartView} chart
 * @param {Theme} theme
 * @param {import("assur/core/words.js").Words} words
 */
function legend({ panels, size }, theme, words) {
  const context = blank();
  const font = setChartFont(context, theme, 12);
  let left = LEFT;
  let row = 0;
  const series = panels[0]?.series ?? [];
  const entries = series.map(({ role, ...one }) => {
    const text = symbol(one, 0, false, words);
    const width = SAMPLE + ROOM + textWidth(context, font, text);
    if (left > LEFT && left + width > size.width) {
      left = LEFT;
      row += 1;
    }
    const entry = { text, role, left, row };
    left += width + 2 * ROOM;
    return entry;
  });
  return { entries, rows: entries.length > 0 ? row + 1 : 0 };
}
