// The plots: curves by the engine, text by us, both on one canvas that is redrawn only when the curves change.
import { Surface } from "assur/canvas/surface.js";
import { setData } from "assur/core/dom.js";
import { attempt } from "assur/core/problem.js";
import { drawAgainstText } from "assur/plots/against.js";
import { drawMarks } from "assur/plots/marks.js";
import { drawChartText } from "assur/plots/text.js";

/**
 * @typedef {import("assur/engine.js").Engine} Engine
 * @typedef {import("assur/engine.js").Panel} Panel
 * @typedef {import("assur/state/model.js").Snapshot} Snapshot
 * @typedef {import("assur/canvas/theme.js").Theme} Theme
 * @typedef {import("assur/plots/marks.js").Box} Box
 * @typedef {(context: import("assur/canvas/painter.js").Context, panels: readonly Panel[], snapshot: Snapshot, engine: Engine, theme: Theme) => readonly (Box | null)[]} Overlay
 * the places that it covers in each panel
 */

export class ChartView {
  #surface;
  #engine;
  #theme;
  /** @type {Snapshot | null} */
  #snapshot = null;
  /** @type {string} what was drawn last */
  #drawn = "";
  /** @type {readonly Panel[]} */
  panels = [];
  /** @type {import("assur/engine.js").Field | null} what is plotted against each other instead of them */
  against = null;
  /** @type {readonly (readonly Box[])[]} where the labels are, of each panel */
  labels = [];
  /** @type {Overlay | null} */
  #overlay = null;
  #failed;
  /** Whether the plots could be drawn when it was tried last. */
  #drawable = true;
  /** Called when the panels may have changed their places. */
  redrawn = () => {};

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {Engine} engine
   * @param {Theme} theme
   * @param {() => void} failed called where the plots cannot be drawn: once until they are drawn again
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
    const { start } = snapshot.coordinate.axis(snapshot.place);
    const wanted = `${snapshot.revision} ${snapshot.words.lang} ${this.#theme.revision} ${start} ${snapshot.state.view.only}`;
    if (wanted === this.#drawn) return;
    this.#drawn = wanted;
    this.#draw();
  }

  #draw() {
    const snapshot = this.#snapshot;
    if (!snapshot || !this.#surface.begin()) return;
    this.#surface.clear();
    const { drawn, ...places } = this.#paint(this.#surface, snapshot, this.#theme, false);
    ({ panels: this.panels, against: this.against, labels: this.labels } = places);
    if (this.#drawable && !drawn) this.#failed();
    this.#drawable = drawn;
    this.redrawn();
  }

  /** @param {Overlay} overlay what is painted over the curves from now on */
  lay(overlay) {
    this.#overlay = overlay;
    this.#draw();
  }

  /** @returns {import("assur/stage/figure.js").Size} */
  get size() {
    return this.#surface;
  }

  /**
   * Paints the plots, without the cursor, on another target of the same size.
   * @param {import("assur/canvas/painter.js").Target} target
   * @param {Theme} theme
   */
  paint(target, theme) {
    if (this.#snapshot) this.#paint(target, this.#snapshot, theme, true);
  }

  /**
   * @param {import("assur/canvas/painter.js").Target} target one unit of which is one CSS pixel
   * @param {Snapshot} snapshot
   * @param {Theme} theme
   * @param {boolean} whole whether the curves go through all their points
   * @returns where the plots and their labels are, and whether they are drawn
   */
  #paint({ context, ratio }, snapshot, theme, whole) {
    const { width, height } = this.#surface;
    const { palette, scale } = theme;
    const { only } = snapshot.state.view;
    // Not as the text that was written last left it.
    context.lineJoin = "round";
    const { value } = attempt(() => this.#engine.chart(context, { width, height, palette, scale, ratio, whole, only, around: snapshot.input }));
    const { panels, against } = value ?? { panels: [], against: null };
    const covered = this.#overlay?.(context, panels, snapshot, this.#engine, theme) ?? [];
    const titles = drawChartText(context, panels, snapshot, theme);
    const labels = panels.map((panel, i) => drawMarks(context, panel, [titles[i], ...(covered[i] ? [covered[i]] : [])], snapshot, theme));
    if (against) drawAgainstText(context, against, snapshot, theme);
    return { panels, against, labels, drawn: value !== null };
  }
}
