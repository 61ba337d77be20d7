// Visible part of the scrubber: the bar, its part up to the current input, and the knob. They are painted on a
// canvas, because changing a style in every frame takes a browser several times as long.
import { Surface } from "assur/canvas/surface.js";

/** @typedef {import("assur/canvas/theme.js").Theme} Theme */

/** Sizes in pixels, as in the style sheet. `KNOB`: diameter. `RIM`: width of the rim. `BAR`: thickness of the bar. */
const KNOB = 22;
const RIM = 4;
const BAR = 6;

/** Opacity of the arcs in which the linkage can be assembled, on a bar with gaps between them. */
const OPEN = 0.35;

export class Scrubber {
  #surface;
  #theme;
  #part = 0;
  /** @type {readonly (readonly [number, number])[] | null} */
  #arcs = null;

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {Theme} theme
   */
  constructor(canvas, theme) {
    this.#theme = theme;
    this.#surface = new Surface(canvas, () => this.#draw());
  }

  /**
   * @param {number} part share of the axis up to the input, 0 to 1
   * @param {readonly (readonly [number, number])[] | null} arcs parts of the axis, from 0 to 1, in which the linkage
   * can be assembled; null for the whole axis
   */
  show(part, arcs) {
    this.#part = part;
    this.#arcs = arcs;
    this.#draw();
  }

  #draw() {
    if (!this.#surface.begin()) return;
    this.#surface.clear();
    const { context, width } = this.#surface;
    const { line, crank, paper } = this.#theme.colours;
    const at = (/** @type {number} */ part) => KNOB / 2 + part * (width - KNOB);
    this.#bar(0, width, line);
    if (this.#arcs) {
      context.globalAlpha = OPEN;
      for (const [from, to] of this.#arcs) this.#bar(at(from), at(to), crank);
      context.globalAlpha = 1;
    } else {
      this.#bar(0, at(this.#part), crank);
    }
    context.beginPath();
    context.arc(at(this.#part), this.#surface.height / 2, (KNOB - RIM) / 2, 0, 2 * Math.PI);
    context.fillStyle = paper;
    context.fill();
    context.strokeStyle = crank;
    context.lineWidth = RIM;
    context.stroke();
  }

  /**
   * @param {number} from
   * @param {number} to
   * @param {string} colour
   */
  #bar(from, to, colour) {
    const { context, height } = this.#surface;
    context.beginPath();
    context.roundRect(from, (height - BAR) / 2, to - from, BAR, BAR / 2);
    context.fillStyle = colour;
    context.fill();
  }
}
