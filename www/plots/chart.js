// The plots: curves from the engine, text from the page, both on one canvas that is redrawn only if one of them changes.
import { Surface } from "assur/canvas/surface.js";
import { setData } from "assur/core/dom.js";
import { attempt } from "assur/core/problem.js";
import { drawAgainstCursor, drawAgainstText } from "assur/plots/against.js";
import { paintCursorLine, pointsOf } from "assur/plots/cursor-line.js";
import { drawMarks } from "assur/plots/marks.js";
import { across } from "assur/plots/panel.js";
import { drawChartText, drawTitleSign } from "assur/plots/text.js";

/**
 * @typedef {import("assur/engine.js").Engine} Engine
 * @typedef {import("assur/types/web.js").PanelLayout} Panel
 * @typedef {import("assur/state/model.js").Snapshot} Snapshot
 * @typedef {import("assur/canvas/theme.js").Theme} Theme
 * @typedef {import("assur/canvas/boxes.js").Box} Box
 * @typedef {(context: import("assur/canvas/painter.js").Context, panels: readonly Panel[], snapshot: Snapshot, engine: Engine, theme: Theme) => readonly (Box | null)[]} Overlay
 * paints over the curves, and returns the covered box in each panel, null for none
 */

/** Size of plots that are saved while the page does not show them, in CSS pixels. */
const UNSEEN = Object.freeze({ width: 480, height: 540 });

export class ChartView {
  #surface;
  #engine;
  #theme;
  /** @type {Snapshot | null} */
  #snapshot = null;
  /** @type {string} values on which the last drawing depended, as text */
  #drawn = "";
  /** @type {readonly Panel[]} */
  panels = [];
  /** @type {import("assur/types/web.js").AgainstLayout | null} plot of one quantity against another, instead of the panels */
  against = null;
  /** @type {readonly (readonly import("assur/plots/marks.js").Label[])[]} labels of each panel */
  labels = [];
  /** @type {readonly Box[]} boxes of the titles of the panels */
  titles = [];
  /** @type {Overlay | null} */
  #overlay = null;
  #failed;
  /** Whether the last attempt to draw the plots succeeded. */
  #drawable = true;
  /** Called when the panels may have moved. */
  redrawn = () => {};

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {Engine} engine
   * @param {Theme} theme
   * @param {() => void} failed called when the plots cannot be drawn; not called again until they have been drawn
   */
  constructor(canvas, engine, theme, failed) {
    this.#failed = failed;
    this.#engine = engine;
    this.#theme = theme;
    this.#surface = new Surface(canvas, () => this.#draw());
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    this.#snapshot = snapshot;
    setData(this.#surface.canvas, "faded", String(snapshot.stale));
    const { start } = snapshot.coordinate.axis(snapshot.inputShown);
    const wanted = `${snapshot.revision} ${snapshot.words.lang} ${snapshot.words.has("forces.plots")} ${this.#theme.revision} ${start} ${snapshot.state.view.only}`;
    if (wanted === this.#drawn) return;
    this.#drawn = wanted;
    this.#draw();
  }

  #draw() {
    const snapshot = this.#snapshot;
    if (!snapshot || !this.#surface.begin()) return;
    this.#surface.clear();
    const { drawn, ...layout } = this.#paint(this.#surface, snapshot, this.#theme, false);
    ({ panels: this.panels, against: this.against, labels: this.labels, titles: this.titles } = layout);
    if (this.#drawable && !drawn) this.#failed();
    this.#drawable = drawn;
    this.redrawn();
  }

  /** @param {Overlay} overlay to paint over the curves from now on */
  lay(overlay) {
    this.#overlay = overlay;
    this.#draw();
  }

  /** @returns {import("assur/stage/figure.js").Size} size on the page, or `UNSEEN` while the plots are not shown, as in drawing mode */
  get size() {
    return this.#surface.visible ? this.#surface : UNSEEN;
  }

  /**
   * Paints the plots without the cursor on another target of the same size.
   * @param {import("assur/canvas/painter.js").Target} target
   * @param {Theme} theme
   */
  paint(target, theme) {
    if (this.#snapshot) this.#paint(target, this.#snapshot, theme, true);
  }

  /**
   * Paints the plots with a cursor at an input on another canvas of the same size.
   * @param {import("assur/canvas/painter.js").Target} target
   * @param {Theme} theme
   * @param {{ readonly frameInput: number, readonly plotted?: Float64Array | null }} moment
   */
  paintAt(target, theme, { frameInput, plotted = null }) {
    const snapshot = this.#snapshot;
    if (!snapshot) return;
    const { panels, against } = this.#paint(target, snapshot, theme, true);
    const { context } = target;
    for (const panel of panels) paintCursorLine(context, panel, across(panel, frameInput), pointsOf(panel, plotted), theme);
    if (against) drawAgainstCursor(/** @type {CanvasRenderingContext2D} */ (context), against, plotted, snapshot, theme, { tagged: false });
  }

  /**
   * @param {import("assur/canvas/painter.js").Target} target in CSS pixels
   * @param {Snapshot} snapshot
   * @param {Theme} theme
   * @param {boolean} fullDetail whether the curves go through all their points; otherwise indistinguishable points are omitted
   * @returns places of the plots and their labels, and whether they could be drawn
   */
  #paint({ context, ratio }, snapshot, theme, fullDetail) {
    const { width, height } = this.size;
    const { palette, scale } = theme;
    const { only } = snapshot.state.view;
    // On a new or resized canvas the value is "miter".
    context.lineJoin = "round";
    const { value } = attempt(() => this.#engine.chart(context, { width, height, palette, scale, ratio, whole: fullDetail, only, around: snapshot.input }));
    const { panels, against } = value ?? { panels: [], against: null };
    const covered = this.#overlay?.(context, panels, snapshot, this.#engine, theme) ?? [];
    const written = drawChartText(context, panels, snapshot, theme);
    // Exported plots have no sign, because they cannot be pressed.
    const sign = { alone: only !== "all", end: width };
    const titles = fullDetail ? written : written.map((title) => drawTitleSign(context, title, theme, sign));
    const by = { cursor: !fullDetail };
    const labels = panels.map((panel, i) => drawMarks(context, panel, [...titles, ...(covered[i] ? [covered[i]] : [])], snapshot, theme, by));
    if (against) drawAgainstText(context, against, snapshot, theme);
    return { panels, against, labels, titles, drawn: value !== null };
  }
}
