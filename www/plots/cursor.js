// The cursor over the plots: a line at the input, a dot and a number on each curve. Redrawn every frame. Where a
// pointer hovers, a second, dashed one.
import { Surface } from "assur/canvas/surface.js";
import { textWidth } from "assur/canvas/text-width.js";
import { setData } from "assur/core/dom.js";
import { attempt } from "assur/core/problem.js";
import { across, down, shows } from "assur/plots/panel.js";
import { setChartFont } from "assur/plots/text.js";
import { written } from "assur/plots/units.js";

/**
 * @typedef {import("assur/engine.js").Engine} Engine
 * @typedef {import("assur/engine.js").Panel} Panel
 * @typedef {import("assur/state/model.js").Snapshot} Snapshot
 * @typedef {import("assur/canvas/theme.js").Theme} Theme
 * @typedef {{ y: number, text: string, colour: string, ink: string }} Dot
 */

/** Radius of a dot and height of a number's box, at the usual size of text. */
const DOT = 4.5;
const TAG = 17;
/** Dashes of the second cursor's line, and of the first's. */
const GHOST = [4, 4];
/** @type {number[]} */
const WHOLE = [];

export class ChartCursor {
  #surface;
  #theme;
  #chart;
  #engine;
  /** @type {number | null} the input under a pointer */
  #hovered = null;
  /** @type {Snapshot | null} */
  #snapshot = null;
  /** @type {Float64Array | null} the values that were written last: in motion new ones come too fast to be read */
  #written = null;

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {Theme} theme
   * @param {{ readonly panels: readonly Panel[] }} chart
   * @param {Engine} engine
   */
  constructor(canvas, theme, chart, engine) {
    this.#theme = theme;
    this.#engine = engine;
    this.#chart = chart;
    this.#surface = new Surface(canvas, () => this.redraw());
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    this.#snapshot = snapshot;
    if (snapshot.legible || this.#written?.length !== snapshot.plotted?.length) this.#written = snapshot.plotted;
    setData(this.#surface.canvas, "faded", String(snapshot.stale));
    this.redraw();
  }

  /** @param {number | null} phi the input to show the values at */
  hover(phi) {
    if (phi === this.#hovered) return;
    this.#hovered = phi;
    this.redraw();
  }

  redraw() {
    const snapshot = this.#snapshot;
    if (!snapshot || !this.#surface.begin()) return;
    this.#surface.clear();
    const hovered = this.#hovered;
    const ghost = hovered === null ? null : attempt(() => this.#engine.plotted(hovered)).value;
    const { panels } = this.#chart;
    // Two sets of numbers would cover each other: under a pointer only its own are written.
    const phi = snapshot.input;
    for (const panel of panels) this.#panel(panel, snapshot, phi, snapshot.plotted, hovered === null ? this.#written : null);
    if (hovered === null || panels.length === 0) return;
    for (const panel of panels) this.#panel(panel, snapshot, hovered, ghost, ghost, GHOST);
    this.#angle(panels[0], hovered, snapshot);
  }

  get #dot() {
    return DOT * this.#theme.scale;
  }

  get #tall() {
    return TAG * this.#theme.scale;
  }

  /**
   * The input of the second cursor, above the topmost plot.
   * @param {Panel} panel
   * @param {number} phi
   * @param {Snapshot} snapshot
   */
  #angle(panel, phi, { coordinate, words }) {
    const { context } = this.#surface;
    const text = coordinate.text(phi, words, 1);
    const font = setChartFont(context, this.#theme);
    const width = textWidth(context, font, text) + 10;
    const middle = across(panel, phi);
    const left = Math.min(Math.max(middle - width / 2, panel.left), panel.left + panel.width + 8 - width);
    this.#tag(left, panel.top - this.#tall - 1, width, { y: 0, text, colour: this.#theme.colours.ink, ink: this.#theme.colours.ink });
  }

  /**
   * @param {Panel} panel
   * @param {Snapshot} snapshot
   * @param {number} phi
   * @param {Float64Array | null} values of the plotted quantities
   * @param {Float64Array | null} written the values to be written beside them
   * @param {number[]} dashes of the line
   */
  #panel(panel, snapshot, phi, values, written, dashes = WHOLE) {
    const { context } = this.#surface;
    const { colours, weight } = this.#theme;
    const x = across(panel, phi);
    if (!(x >= panel.left - 1 && x <= panel.left + panel.width + 1)) return;
    context.strokeStyle = colours.ink;
    context.lineWidth = weight;
    context.beginPath();
    context.moveTo(x, panel.top);
    context.lineTo(x, panel.top + panel.height);
    context.setLineDash(dashes);
    context.stroke();
    context.setLineDash(WHOLE);
    const dots = this.#dots(panel, snapshot, values, written);
    if (dots.length === 0) return;
    context.lineWidth = 2 * weight;
    for (const { y, colour } of dots) {
      context.beginPath();
      context.arc(x, y, this.#dot, 0, 2 * Math.PI);
      context.fillStyle = colours.paper;
      context.fill();
      context.strokeStyle = colour;
      context.stroke();
    }
    if (written) this.#tags(panel, x, dots);
  }

  /**
   * @param {Panel} panel
   * @param {Snapshot} snapshot
   * @param {Float64Array | null} values of the plotted quantities
   * @param {Float64Array | null} numbers those that are written of them
   * @returns {Dot[]} from the top down
   */
  #dots(panel, { words }, values, numbers) {
    if (!values) return [];
    const dots = [];
    for (const [i, { role }] of panel.series.entries()) {
      const value = values[3 * i + panel.order];
      if (!shows(panel, value)) continue;
      const text = numbers ? written(panel, numbers[3 * i + panel.order], words.numbers) : "";
      dots.push({ y: down(panel, value), text, colour: this.#theme.colours[role], ink: this.#theme.inks[role] });
    }
    return dots.sort((a, b) => a.y - b.y);
  }

  /**
   * The numbers stand beside the line, on the side with room, pushed apart where they would meet.
   * @param {Panel} panel
   * @param {number} x
   * @param {readonly Dot[]} dots
   */
  #tags(panel, x, dots) {
    const { context } = this.#surface;
    const font = setChartFont(context, this.#theme);
    const widths = dots.map(({ text }) => textWidth(context, font, text) + 10);
    const widest = Math.max(...widths);
    const [dot, tall] = [this.#dot, this.#tall];
    const toTheLeft = x + dot + 6 + widest > panel.left + panel.width + 8;
    const tops = spread(
      dots.map(({ y }) => y - tall / 2),
      panel.top,
      panel.top + panel.height,
      tall,
    );
    dots.forEach((each, i) => this.#tag(toTheLeft ? x - dot - 5 - widths[i] : x + dot + 5, tops[i], widths[i], each));
  }

  /**
   * @param {number} left
   * @param {number} top
   * @param {number} width
   * @param {Dot} dot
   */
  #tag(left, top, width, { text, colour, ink }) {
    const { context } = this.#surface;
    context.textAlign = "left";
    context.textBaseline = "middle";
    context.beginPath();
    context.roundRect(left, top, width, this.#tall, 5);
    context.globalAlpha = 0.92;
    context.fillStyle = this.#theme.colours.paper;
    context.fill();
    context.globalAlpha = 1;
    context.lineWidth = 1;
    context.strokeStyle = colour;
    context.stroke();
    context.fillStyle = ink;
    context.fillText(text, left + 5, top + this.#tall / 2 + 0.5);
  }
}

/**
 * @param {readonly number[]} tops in rising order
 * @param {number} first
 * @param {number} last
 * @param {number} tall the height of a tag
 * @returns {number[]} as near to them as may be, at least that far apart, between first and last
 */
function spread(tops, first, last, tall) {
  const step = tall + 2;
  // Those that would meet stand in a block round the mean of their places.
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
  const places = blocks.flatMap(({ sum, count }) => Array(count).fill(Math.min(Math.max(sum / count, first), lowest)));
  return places.map((place, i) => place + i * step);
}
