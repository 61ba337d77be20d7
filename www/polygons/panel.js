// Polygons of velocities and accelerations at the current input, drawn to scale step by step. Loaded on demand.
import "assur/polygons/style.js";
import { readDisplayList } from "assur/canvas/display-list.js";
import { labelledPoints, Painter } from "assur/canvas/painter.js";
import { Places } from "assur/canvas/places.js";
import { Surface } from "assur/canvas/surface.js";
import { Transform } from "assur/canvas/transform.js";
import { byId, make, write } from "assur/core/dom.js";
import { html, nothing, render } from "assur/core/html.js";
import { attempt } from "assur/core/problem.js";
import { subscript } from "assur/core/symbols.js";
import { axisTitle, unitOf } from "assur/plots/units.js";
import { alongLines, closeUp } from "assur/polygons/close-up.js";
import { amount, describeStep } from "assur/polygons/equations.js";

/**
 * @typedef {import("assur/state/model.js").Snapshot} Snapshot
 * @typedef {import("assur/types/web.js").PolygonsHere} Here
 */

/** Free room around a polygon for the names of its vertices, in pixels. */
const MARGIN = 26;
/** Number of steps to show that stands for all steps; no construction has so many. */
const ALL = 1e6;
/** Code of the engine's problem for a document that is not a linkage. */
const NO_LINKAGE = "bad_state";
/** Pose of the frame, the only body: the polygons are drawn in its coordinates. */
const POSES = Object.freeze([Object.freeze([0, 0, 0])]);

export class Polygons {
  #page;
  #painter;
  #shown = ALL;
  #back = make("button", { type: "button", class: "control", id: "polygons-back", "data-t": "polygons.back", onclick: () => this.#go(-1) });
  #next = make("button", { type: "button", class: "control", id: "polygons-next", "data-t": "polygons.next", onclick: () => this.#go(1) });
  #all = make("button", { type: "button", class: "control", id: "polygons-all", "data-t": "polygons.all", onclick: () => this.#go(ALL) });
  #oneScale = make("button", { type: "button", class: "control", id: "polygons-scale", "aria-pressed": "false", "data-t": "polygons.one_scale", onclick: () => this.#keepScale() });
  #step = make("p", { id: "polygon-step", role: "status" });
  #none = make("p", { id: "polygon-none", "data-t": "polygons.none" });
  #equations = make("ol", { id: "polygon-equations" });
  #drawn;
  #sheets;
  /** @type {Here | null} */
  #here = null;
  /** @type {Here | null} with all steps */
  #whole = null;
  /** @type {Snapshot | null} */
  #snapshot = null;

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    this.#page = page;
    this.#painter = new Painter(page.theme);
    this.#sheets = ["velocity", "acceleration"].map((name, order) => {
      const canvas = make("canvas", { id: `polygon-${name}`, role: "img" });
      const [title, scale] = [make("span"), make("span", { id: `polygon-${name}-scale` })];
      const surface = new Surface(canvas, () => this.#paint(order));
      return { canvas, title, scale, surface, places: new Places() };
    });
    const figures = this.#sheets.map(({ canvas, title, scale }) => make("figure", { class: "polygon" }, [canvas, make("figcaption", {}, [title, scale])]));
    const steps = make("div", { class: "polygon-steps", role: "group", "data-t-label": "polygons.steps" }, [this.#back, this.#next, this.#all, this.#oneScale, this.#step]);
    this.#drawn = make("div", {}, [steps, make("div", { class: "polygon-sheets" }, figures), this.#equations]);
    this.element = make("section", { id: "polygons-shown", "data-field": "polygons" }, [make("h2", { "data-t": "polygons.heading" }), this.#none, this.#drawn]);
    byId("readouts", HTMLTableElement).after(this.element);
    page.words.fill(this.element);
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    const { state, frameInput, stale } = snapshot;
    if (stale) return;
    this.#snapshot = snapshot;
    this.#here = null;
    this.element.hidden = !state.view.polygons;
    if (this.element.hidden) return;
    const drawn = (/** @type {number} */ steps) => attempt(() => this.#page.engine.simulator.polygons(frameInput, steps));
    const { value, problems } = drawn(this.#shown);
    this.#here = value;
    this.#whole = value && this.#shown < value.steps.length ? drawn(ALL).value : value;
    // A document that is not a linkage has no polygons at any input.
    this.element.hidden = problems.some(({ code }) => code === NO_LINKAGE);
    this.#none.hidden = this.#here !== null;
    this.#drawn.hidden = this.#here === null;
    if (!this.#here) return;
    if (snapshot.numbersDue) this.#tell(this.#here, snapshot);
    this.#sheets.forEach((_, order) => this.#paint(order));
  }

  /**
   * Shows more or fewer steps of the construction. After the last step, the first is shown alone again.
   * @param {number} by number of steps to add, or {@link ALL}
   */
  #go(by) {
    const count = this.#here?.steps.length ?? 0;
    const at = Math.min(this.#shown, count);
    this.#shown = by === ALL ? ALL : at + by > count ? 1 : Math.max(at + by, 1);
    this.#page.redraw();
  }

  /**
   * @param {Here} here
   * @param {Snapshot} snapshot
   */
  #tell({ steps, pictures }, { state, coordinate, words }) {
    const at = Math.min(this.#shown, steps.length);
    write(this.#step, words.text("polygons.step", { n: words.numbers.exact(at), count: words.numbers.exact(steps.length) }));
    this.#back.disabled = at <= 1;
    const physical = state.view.axes === "physical";
    // Units as on plots of lengths; the range from −1 to 1 avoids a power of ten.
    const panels = [1, 2].map((order) => /** @type {import("assur/types/web.js").PanelLayout} */ ({ kind: "length", order, physical, y0: -1, y1: 1 }));
    const [velocity, acceleration] = panels.map((panel) => unitOf(panel, coordinate, words));
    this.#sheets.forEach(({ canvas, title, scale }, order) => {
      const said = axisTitle(panels[order], coordinate, words);
      write(title, said);
      const close = this.#closeUp(order);
      const { bar, smaller } = close ? { bar: close.bar, smaller: 1 } : pictures[order];
      const shown = `├─┤ ${amount(bar, order === 0 ? velocity : acceleration, words)}`;
      write(scale, smaller > 1 ? `${shown}, ${words.text("polygons.smaller", { n: words.numbers.exact(smaller) })}` : shown);
      canvas.setAttribute("aria-label", `${words.text("polygons.heading")}: ${said}`);
    });
    render(steps.slice(0, at).map((step, k) => html`<li aria-current=${k + 1 === at && at < steps.length ? "step" : nothing}>${describeStep(step, step.found.length > 0, [velocity, acceleration], words)}</li>`), this.#equations);
  }

  /** @param {number} order */
  #paint(order) {
    const picture = this.#here?.pictures[order];
    const { surface, places } = this.#sheets[order];
    if (!picture || !this.#snapshot || !surface.begin()) return;
    surface.clear();
    const { width, height } = surface;
    const close = this.#closeUp(order);
    const layers = readDisplayList(Float32Array.from(close?.list ?? picture.list), 0, this.#page.engine.roles, picture.names, () => new Path2D());
    const view = close?.view ?? Transform.fit(picture.bounds, width, height, MARGIN);
    this.#painter.shapes(surface, layers, view, POSES);
    if (close) this.#paintBar(surface, close.bar * view.scale);
    places.begin(surface, labelledPoints(layers, view, POSES), alongLines(layers, view));
    this.#painter.labels(surface, layers, view, POSES, subscript, places, true);
  }
  /** Switches between polygons as large as their boxes allow and polygons of one scale for the whole motion. */
  #keepScale() {
    this.#oneScale.ariaPressed = String(this.#oneScale.ariaPressed !== "true");
    this.#page.redraw();
  }

  /**
   * @param {number} order
   * @returns the enlarged polygon; null in motion, and if one scale is chosen
   */
  #closeUp(order) {
    if (this.#snapshot?.state.view.playing || this.#oneScale.ariaPressed === "true") return null;
    const [picture, whole] = [this.#here, this.#whole].map((here) => here?.pictures[order]);
    const { surface } = this.#sheets[order];
    return picture && whole && surface.visible ? closeUp(picture, whole, surface, MARGIN) : null;
  }

  /**
   * @param {Surface} surface
   * @param {number} length of the scale bar, in pixels
   */
  #paintBar(surface, length) {
    surface.toPixels();
    const { context, height } = surface;
    const [left, middle] = [10, height - 9];
    context.strokeStyle = this.#page.theme.colours.ink;
    context.lineWidth = 2;
    context.beginPath();
    for (const [x0, y0, x1, y1] of [[0, 0, length, 0], [0, -4, 0, 4], [length, -4, length, 4]]) {
      context.moveTo(left + x0, middle + y0);
      context.lineTo(left + x1, middle + y1);
    }
    context.stroke();
  }
}
