// The cursor over the plots: a line at the input, with a dot and a number on each curve. Hovering adds a dashed cursor.
import { isFree } from "assur/canvas/boxes.js";
import { Surface } from "assur/canvas/surface.js";
import { textWidth } from "assur/canvas/text-width.js";
import { setData } from "assur/core/dom.js";
import { attempt } from "assur/core/problem.js";
import { readoutOf } from "assur/core/symbols.js";
import { drawAgainstCursor } from "assur/plots/against.js";
import { textAtCursor } from "assur/plots/marks.js";
import { across, down, shows } from "assur/plots/panel.js";
import { paintTag, placedTags } from "assur/plots/tags.js";
import { setChartFont } from "assur/plots/text.js";
import { axisValueText } from "assur/plots/units.js";

/**
 * @typedef {import("assur/plots/marks.js").Label} Label
 * @typedef {import("assur/types/web.js").PanelLayout} Panel
 * @typedef {import("assur/state/model.js").Snapshot} Snapshot
 * @typedef {{ y: number, text: string, colour: string, ink: string }} Dot
 */

/** In pixels at the usual text size. `DOT`: radius of a dot. `TAG`: height of a number's box. */
const DOT = 4.5;
const TAG = 17;
/** Dashes of the second cursor's line. */
const GHOST = [4, 4];
/** @type {number[]} dashes of the first cursor's line: none */
const SOLID = [];
const FIRST = Object.freeze({ dashes: SOLID, named: false });

export class ChartCursor {
  #surface;
  #theme;
  #chart;
  #engine;
  /** @type {number | null} the input under a pointer */
  #hovered = null;
  /** @type {Snapshot | null} */
  #snapshot = null;

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {import("assur/canvas/theme.js").Theme} theme
   * @param {{ readonly panels: readonly Panel[], readonly against: import("assur/types/web.js").AgainstLayout | null, readonly labels: readonly (readonly Label[])[] }} chart
   * @param {import("assur/engine.js").Engine} engine
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
    setData(this.#surface.canvas, "faded", String(snapshot.stale));
    this.redraw();
  }

  /** @param {number | null} input of the second cursor, null for none */
  hover(input) {
    if (input === this.#hovered) return;
    this.#hovered = input;
    this.redraw();
  }

  redraw() {
    const snapshot = this.#snapshot;
    if (!snapshot || !this.#surface.begin()) return;
    this.#surface.clear();
    const hovered = this.#hovered;
    const ghost = hovered === null ? null : attempt(() => this.#engine.simulator.plotted(hovered)).value;
    const { panels, against, labels } = this.#chart;
    if (against) {
      const { context } = this.#surface;
      drawAgainstCursor(context, against, snapshot.plotted, snapshot, this.#theme, { tagged: hovered === null });
      if (hovered !== null) drawAgainstCursor(context, against, ghost, snapshot, this.#theme, { tagged: true, input: hovered });
    }
    // While a pointer hovers, only the second cursor has numbers: two sets of numbers would overlap.
    const { input } = snapshot;
    panels.forEach((panel, i) => this.#panel(panel, snapshot, input, snapshot.plotted, hovered === null ? labels[i] : null));
    if (hovered === null) return;
    panels.forEach((panel, i) => this.#panel(panel, snapshot, hovered, ghost, labels[i], { dashes: GHOST, named: i === 0 }));
  }

  get #dot() {
    return DOT * this.#theme.scale;
  }

  get #tall() {
    return TAG * this.#theme.scale;
  }

  /**
   * @param {Panel} panel
   * @param {Snapshot} snapshot
   * @param {number} input
   * @param {Float64Array | null} values of the plotted quantities
   * @param {readonly Label[] | null} labels labels that the written values avoid; null to write no values
   * @param {{ dashes: number[], named: boolean }} [line] `named`: whether the input is written, too, at the top of the line
   */
  #panel(panel, snapshot, input, values, labels, { dashes, named } = FIRST) {
    const { context } = this.#surface;
    const { colours, weight } = this.#theme;
    const x = across(panel, input);
    if (!(x >= panel.left - 1 && x <= panel.left + panel.width + 1)) return;
    context.strokeStyle = colours.ink;
    context.lineWidth = weight;
    context.beginPath();
    context.moveTo(x, panel.top);
    context.lineTo(x, panel.top + panel.height);
    context.setLineDash(dashes);
    context.stroke();
    context.setLineDash(SOLID);
    const dots = this.#dots(panel, snapshot, values, x, labels);
    context.lineWidth = 2 * weight;
    for (const { y, colour } of dots) {
      context.beginPath();
      context.arc(x, y, this.#dot, 0, 2 * Math.PI);
      context.fillStyle = colours.paper;
      context.fill();
      context.strokeStyle = colour;
      context.stroke();
    }
    const { ink } = colours;
    const top = named ? [{ y: panel.top + this.#tall / 2, text: snapshot.coordinate.text(input, snapshot.words, 1), colour: ink, ink }] : [];
    if (labels && dots.length + top.length > 0) this.#tags(panel, x, [...top, ...dots], labels);
  }

  /**
   * @param {Panel} panel
   * @param {Snapshot} snapshot
   * @param {Float64Array | null} values of the plotted quantities
   * @param {number} x place of the cursor
   * @param {readonly Label[] | null} labels
   * @returns {Dot[]} dots in order from top to bottom
   */
  #dots(panel, snapshot, values, x, labels) {
    const { state: { view: { playing } }, words, withheld } = snapshot;
    if (!values) return [];
    // In motion the numbers would jump at every mark.
    const marked = (/** @type {string} */ role) => (labels && (!playing || this.#hovered !== null) ? textAtCursor(panel, role, x, labels, snapshot) : null);
    const dots = [];
    for (const [i, { name, role }] of panel.series.entries()) {
      const value = values[3 * i + panel.order];
      if (!shows(panel, value)) continue;
      const text = withheld.has(readoutOf(name, panel.order)) ? "?" : marked(role) ?? axisValueText(panel, value, words.numbers, playing);
      dots.push({ y: down(panel, value), text, colour: this.#theme.colours[role], ink: this.#theme.inks[role] });
    }
    return dots.sort((a, b) => a.y - b.y);
  }

  /**
   * @param {Panel} panel
   * @param {number} x
   * @param {readonly Dot[]} dots
   * @param {readonly Label[]} labels
   */
  #tags(panel, x, dots, labels) {
    const { context } = this.#surface;
    const font = setChartFont(context, this.#theme);
    const widths = dots.map(({ text }) => textWidth(context, font, text) + 10);
    const { left, top, width, height } = panel;
    const room = { left, top, right: left + width + 7, bottom: top + height };
    const middles = dots.map(({ y }) => y);
    const tags = placedTags({ middles, widths, tall: this.#tall, x, off: this.#dot + 5, room, labels });
    // A number without room beside the labels is left out: the table has it.
    dots.forEach((dot, i) => isFree(tags[i], labels) && this.#tag(tags[i].left, tags[i].top, widths[i], dot));
  }

  /**
   * @param {number} left
   * @param {number} top
   * @param {number} width
   * @param {Dot} tag
   */
  #tag(left, top, width, tag) {
    paintTag(this.#surface.context, { left, top, width, tall: this.#tall }, tag, this.#theme);
  }
}
