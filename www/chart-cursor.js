// The cursor over the plots: a line at the crank angle, a dot and a number on each curve. Redrawn every frame.
import { degrees, radians } from "assur/angles.js";
import { setChartFont } from "assur/chart-text.js";
import { READOUT_OF, across, down, shows } from "assur/panels.js";
import { setData } from "assur/dom.js";
import { Surface } from "assur/surface.js";

/**
 * @typedef {import("assur/engine.js").Panel} Panel
 * @typedef {import("assur/model.js").Snapshot} Snapshot
 * @typedef {import("assur/theme.js").Theme} Theme
 * @typedef {{ y: number, text: string, colour: string, ink: string }} Dot
 */

const DOT = 4.5;
const TAG = 17;

export class ChartCursor {
  #surface;
  #theme;
  #chart;
  /** @type {Snapshot | null} */
  #snapshot = null;

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {Theme} theme
   * @param {{ readonly panels: readonly Panel[] }} chart
   */
  constructor(canvas, theme, chart) {
    this.#theme = theme;
    this.#chart = chart;
    this.#surface = new Surface(canvas, () => this.redraw());
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    this.#snapshot = snapshot;
    setData(this.#surface.canvas, "faded", String(snapshot.stale));
    this.redraw();
  }

  redraw() {
    const snapshot = this.#snapshot;
    if (!snapshot || !this.#surface.visible) return;
    this.#surface.clear();
    for (const panel of this.#chart.panels) this.#panel(panel, snapshot);
  }

  /**
   * @param {Panel} panel
   * @param {Snapshot} snapshot
   */
  #panel(panel, snapshot) {
    const { context } = this.#surface;
    const { colours } = this.#theme;
    const x = across(panel, radians(snapshot.phiDeg));
    if (!(x >= panel.left - 1 && x <= panel.left + panel.width + 1)) return;
    context.strokeStyle = colours.ink;
    context.lineWidth = 1;
    context.beginPath();
    context.moveTo(x, panel.top);
    context.lineTo(x, panel.top + panel.height);
    context.stroke();
    const dots = this.#dots(panel, snapshot);
    if (dots.length === 0) return;
    context.lineWidth = 2;
    for (const { y, colour } of dots) {
      context.beginPath();
      context.arc(x, y, DOT, 0, 2 * Math.PI);
      context.fillStyle = colours.paper;
      context.fill();
      context.strokeStyle = colour;
      context.stroke();
    }
    this.#tags(panel, x, dots);
  }

  /**
   * @param {Panel} panel
   * @param {Snapshot} snapshot
   * @returns {Dot[]} from the top down
   */
  #dots(panel, { readouts, words }) {
    if (!readouts) return [];
    const dots = [];
    for (const { name, role } of panel.series) {
      const value = readouts[READOUT_OF[name][panel.order]];
      if (!shows(panel, value)) continue;
      const text = panel.order === 0 ? `${words.numbers.fixed(degrees(value), 1)}°` : words.numbers.fixed(value, 3);
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
    setChartFont(context, this.#theme);
    context.textAlign = "left";
    context.textBaseline = "middle";
    const widths = dots.map(({ text }) => context.measureText(text).width + 10);
    const widest = Math.max(...widths);
    const toTheLeft = x + DOT + 6 + widest > panel.left + panel.width + 8;
    const tops = spread(
      dots.map(({ y }) => y - TAG / 2),
      panel.top,
      panel.top + panel.height,
    );
    dots.forEach(({ text, colour, ink }, i) => {
      const left = toTheLeft ? x - DOT - 5 - widths[i] : x + DOT + 5;
      context.beginPath();
      context.roundRect(left, tops[i], widths[i], TAG, 5);
      context.globalAlpha = 0.92;
      context.fillStyle = this.#theme.colours.paper;
      context.fill();
      context.globalAlpha = 1;
      context.lineWidth = 1;
      context.strokeStyle = colour;
      context.stroke();
      context.fillStyle = ink;
      context.fillText(text, left + 5, tops[i] + TAG / 2 + 0.5);
    });
  }
}

/**
 * @param {readonly number[]} tops in rising order
 * @param {number} first
 * @param {number} last
 * @returns {number[]} the same, at least a tag's height apart, between first and last
 */
function spread(tops, first, last) {
  const placed = tops.map((top) => Math.min(Math.max(top, first), last - TAG));
  for (let i = 1; i < placed.length; i++) {
    const lack = placed[i - 1] + TAG + 2 - placed[i];
    if (lack <= 0) continue;
    const down = Math.min(lack / 2, last - TAG - placed[i]);
    placed[i] += down;
    placed[i - 1] -= lack - down;
  }
  return placed;
}
