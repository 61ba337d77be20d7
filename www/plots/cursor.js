// The cursor over the plots: a line at the input, with a dot and a number on each curve. Hovering adds a dashed cursor.
import { isFree } from "assur/canvas/boxes.js";
import { Surface } from "assur/canvas/surface.js";
import { textWidth } from "assur/canvas/text-width.js";
import { setData } from "assur/core/dom.js";
import { attempt } from "assur/core/problem.js";
import { idOf } from "assur/core/quantity.js";
import { drawAgainstCursor } from "assur/plots/against.js";
import { dotRadius, paintCursorLine, pointsOf } from "assur/plots/cursor-line.js";
import { textAtCursor } from "assur/plots/marks.js";
import { across } from "assur/plots/panel.js";
import { paintTag, placedTags } from "assur/plots/tags.js";
import { setChartFont } from "assur/plots/text.js";
import { axisValueText } from "assur/plots/units.js";

/**
 * @typedef {import("assur/plots/marks.js").Label} Label
 * @typedef {import("assur/types/web.js").PanelLayout} Panel
 * @typedef {import("assur/state/model.js").Snapshot} Snapshot
 * @typedef {{ y: number, text: string, colour: string, ink: string }} Dot
 */

/** Height of a number's box, in pixels at the usual text size. */
const TAG = 17;
/** Dashes of the second cursor's line. */
const GHOST = [4, 4];
/** Look of the first cursor: an unbroken line, without the input as text. */
const FIRST = Object.freeze({ named: false });

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

  get #tall() {
    return TAG * this.#theme.scale;
  }

  /**
   * @param {Panel} panel
   * @param {Snapshot} snapshot
   * @param {number} input
   * @param {Float64Array | null} values of the plotted quantities
   * @param {readonly Label[] | null} labels labels that the written values avoid; null to write no values
   * @param {{ dashes?: number[], named: boolean }} [line] `named`: whether the input is written, too, at the top of the line
   */
  #panel(panel, snapshot, input, values, labels, { dashes, named } = FIRST) {
    const x = across(panel, input);
    const points = pointsOf(panel, values);
    if (!paintCursorLine(this.#surface.context, panel, x, points, this.#theme, dashes)) return;
    if (!labels) return;
    const { ink } = this.#theme.colours;
    const top = named ? [{ y: panel.top + this.#tall / 2, text: snapshot.coordinate.text(input, snapshot.words, 1), colour: ink, ink }] : [];
    const dots = [...top, ...this.#dots(panel, snapshot, points, x, labels)];
    if (dots.length > 0) this.#tags(panel, x, dots, labels);
  }

  /**
   * @param {Panel} panel
   * @param {Snapshot} snapshot
   * @param {readonly import("assur/plots/cursor-line.js").Point[]} points
   * @param {number} x place of the cursor
   * @param {readonly Label[]} labels
   * @returns {Dot[]} dots in order from top to bottom
   */
  #dots(panel, snapshot, points, x, labels) {
    const { state: { view: { playing } }, words, withheld } = snapshot;
    // In motion, the exact values of marks are not written, because the numbers would jump at every mark.
    const marked = (/** @type {string} */ role) => (!playing || this.#hovered !== null ? textAtCursor(panel, role, x, labels, snapshot) : null);
    const dots = points.map(({ index, value, y, role }) => {
      const hidden = withheld.has(idOf(panel.series[index].name, panel.order));
      const text = hidden ? "?" : marked(role) ?? axisValueText(panel, value, words.numbers, playing);
      return { y, text, colour: this.#theme.colours[role], ink: this.#theme.inks[role] };
    });
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
    const tags = placedTags({ middles, widths, tall: this.#tall, x, off: dotRadius(this.#theme) + 5, room, labels });
    // A number that would cover a label is omitted; the table of values has it.
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
