// A plane of two lengths on logarithmic scales, with shades, lines and dots.
import { Surface } from "assur/canvas/surface.js";
import { make } from "assur/core/dom.js";

/**
 * @typedef {import("assur/types/web.js").PlaneSummary} Shade
 * @typedef {readonly number[]} Point of the plane: the horizontal length and the vertical one
 */

/** Room for the numbers of the axes, in pixels. */
const MARGIN = Object.freeze({ left: 34, bottom: 30, top: 10, right: 10 });

/** Lengths at the grid lines, as multiples of the frame's length. */
const LINES = Object.freeze([0.1, 0.3, 1, 3, 10]);

const DOT = 6;

/** `STEPS`: number of shades. `DARKEST`: opacity of the darkest shade. */
const STEPS = 12;
const DARKEST = 0.75;

export class Plane {
  #surface;
  #theme;
  #symbols;
  #frame = 1;
  element;

  /**
   * @param {string} id
   * @param {import("assur/canvas/theme.js").Theme} theme
   * @param {readonly [string, string]} symbols of the horizontal length and of the vertical one
   * @param {() => void} repaint paints the content again
   */
  constructor(id, theme, symbols, repaint) {
    this.element = make("canvas", { id, class: "map", role: "img" });
    this.#surface = new Surface(this.element, repaint);
    this.#theme = theme;
    this.#symbols = symbols;
  }

  /**
   * Paints the grid and its numbers. The caller then paints the content and calls `end`.
   * @param {number} frame length of the frame
   * @param {import("assur/core/words.js").Words} words
   * @returns {boolean} whether there is a visible area to paint on
   */
  begin(frame, words) {
    this.#frame = frame;
    if (!this.#surface.begin()) return false;
    this.#surface.clear();
    const { context, width, height } = this.#surface;
    const { colours, font, weight } = this.#theme;
    const bottom = height - MARGIN.bottom;
    context.font = `12px ${font}`;
    context.lineWidth = weight;
    context.strokeStyle = colours.line;
    context.fillStyle = colours.secondary;
    for (const [i, line] of LINES.entries()) {
      const [x, y] = this.at([line * frame, line * frame]);
      this.#trace([[x, MARGIN.top], [x, bottom]]);
      this.#trace([[MARGIN.left, y], [width - MARGIN.right, y]]);
      const text = words.numbers.short(line * frame);
      // In the corner, a centred number would overlap a number of the vertical axis.
      write(context, text, x, bottom + 3, i === 0 ? "left" : "center", "top");
      write(context, text, MARGIN.left - 4, y, "right", i === 0 ? "bottom" : "middle");
    }
    const [right, up] = this.#symbols;
    write(context, right, width - MARGIN.right, height, "right", "bottom");
    write(context, up, MARGIN.left + 4, MARGIN.top, "left", "top");
    context.save();
    context.beginPath();
    context.rect(MARGIN.left, MARGIN.top, width - MARGIN.left - MARGIN.right, bottom - MARGIN.top);
    context.clip();
    return true;
  }

  /** Ends the painting of the content. */
  end() {
    this.#surface.context.restore();
  }

  /**
   * @param {Point} point
   * @returns {[number, number]} the pixel of the point
   */
  at([right, up]) {
    const { width, height } = this.#surface;
    const [least, most] = [LINES[0], LINES[LINES.length - 1]].map(Math.log);
    const part = (/** @type {number} */ length) => (Math.log(length / this.#frame) - least) / (most - least);
    const [wide, high] = [width - MARGIN.left - MARGIN.right, height - MARGIN.top - MARGIN.bottom];
    return [MARGIN.left + wide * part(right), MARGIN.top + high * (1 - part(up))];
  }

  /**
   * Paints values as shades in steps of darkness.
   * @param {Shade} shade
   * @param {(value: number) => number} share gives the darkness for a value, from 0 to 1
   */
  shade({ bounds: [least, most], values }, share) {
    const { context } = this.#surface;
    context.fillStyle = this.#theme.colours.crank;
    const edge = (/** @type {number} */ part) => least * (most / least) ** (part / values.length);
    values.forEach((row, i) => row.forEach((value, j) => {
      context.globalAlpha = (DARKEST * Math.min(Math.floor(STEPS * share(value)), STEPS - 1)) / (STEPS - 1);
      const [left, bottom] = this.at([edge(i), edge(j)]).map(Math.round);
      const [right, top] = this.at([edge(i + 1), edge(j + 1)]).map(Math.round);
      context.fillRect(left, top, right - left, bottom - top);
    }));
    context.globalAlpha = 1;
  }

  /**
   * @param {readonly Point[]} points
   * @param {{ role: string, dash?: readonly number[], width?: number }} look
   */
  line(points, { role, dash = [], width = 1 }) {
    const { context } = this.#surface;
    context.strokeStyle = this.#theme.colours[role];
    context.lineWidth = width * this.#theme.weight;
    context.setLineDash([...dash]);
    this.#trace(points.map((point) => this.at(point)));
    context.setLineDash([]);
    context.lineWidth = this.#theme.weight;
  }

  /**
   * @param {Point} point
   * @param {string} role
   */
  dot(point, role) {
    const { context } = this.#surface;
    const { colours, weight } = this.#theme;
    const [x, y] = this.at(point);
    context.beginPath();
    context.arc(x, y, DOT * weight, 0, 2 * Math.PI);
    context.fillStyle = colours[role];
    context.fill();
    context.strokeStyle = colours.ink;
    context.stroke();
  }

  /** @param {readonly (readonly number[])[]} points in pixels */
  #trace(points) {
    const { context } = this.#surface;
    context.beginPath();
    for (const [x, y] of points) context.lineTo(x, y);
    context.stroke();
  }
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {string} text
 * @param {number} x
 * @param {number} y
 * @param {CanvasTextAlign} align
 * @param {CanvasTextBaseline} baseline
 */
function write(context, text, x, y, align, baseline) {
  context.textAlign = align;
  context.textBaseline = baseline;
  context.fillText(text, x, y);
}
