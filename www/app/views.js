// All views of the page. The views of most kinds of document load when the kind is first shown, the description for
// screen readers when the mechanism is first at rest.
import { Becoming } from "assur/app/becoming.js";
import { awaited } from "assur/app/busy.js";
import { BROKE, LOST } from "assur/app/notices.js";
import { Rendering } from "assur/app/rendering.js";
import { Pace } from "assur/app/pace.js";
import { Title } from "assur/app/title.js";
import { AboutLink } from "assur/controls/about.js";
import { LengthUnits } from "assur/controls/lengths.js";
import { Column } from "assur/controls/column.js";
import { Comparing } from "assur/controls/comparing.js";
import { Measures } from "assur/controls/measures.js";
import { ProblemView } from "assur/controls/problems.js";
import { Switches } from "assur/controls/switches.js";
import { Transport } from "assur/controls/transport.js";
import { compiledWasm } from "assur/core/wasm.js";
import { Bringing } from "assur/core/bringing.js";
import { byId, setData } from "assur/core/dom.js";
import { HERE, LATER } from "assur/kinds/index.js";
import { PlotBar } from "assur/plots/bar.js";
import { ChartCursor } from "assur/plots/cursor.js";
import { ChartPointer } from "assur/plots/pointer.js";
import { ReadoutTable } from "assur/plots/readouts.js";
import { Legend } from "assur/stage/legend.js";
import { moves } from "assur/state/model.js";

/**
 * @typedef {import("assur/app/page.js").Page} Page
 * @typedef {import("assur/state/model.js").AnySnapshot} AnySnapshot
 * @typedef {{ render(snapshot: AnySnapshot): void }} View
 * @typedef {{ render(snapshot: import("assur/state/model.js").Snapshot): void }} MotionView view of documents that move
 * @typedef {(page: Page) => readonly View[]} Make makes the views of a kind; they get snapshots of this kind only
 */

/** @type {Readonly<Record<"all_assemblies" | "polygons" | "forces" | "force_plan" | "under_load" | "curvature", (page: Page) => Promise<MotionView>>>} views loaded when their switch is on */
const PANELS = Object.freeze({
  all_assemblies: async (page) => new (await import("assur/assemblies/panel.js")).Assemblies(page),
  polygons: async (page) => new (await import("assur/polygons/panel.js")).Polygons(page),
  forces: async (page) => new (await page.withForces(import("assur/forces/panel.js"))).Forces(page),
  force_plan: async (page) => new (await page.withForces(import("assur/force-plan/panel.js"))).ForcePlan(page),
  under_load: async (page) => new (await page.withForces(import("assur/under-load/panel.js"))).UnderLoad(page),
  curvature: async (page) => new (await import("assur/plots/curvature.js")).Curvature(page),
});
/** Fold of the rail that loads its content when it is first opened. */
const LOADS = "fold-loads";
const PANEL_NAMES = Object.freeze(/** @type {(keyof typeof PANELS)[]} */ (Object.keys(PANELS)));

/** @type {Readonly<Record<"drawing", (page: Page) => Promise<View>>>} views loaded when their switch is on, even if the document has no motion */
const TOOLS = Object.freeze({
  drawing: async (page) => new (await import("assur/drawing/drawing.js")).Drawing(page),
});
const TOOL_NAMES = Object.freeze(/** @type {(keyof typeof TOOLS)[]} */ (Object.keys(TOOLS)));

/** Least time between two drawings of the plots, and between two writings of the other views, while a hand changes the mechanism; milliseconds. */
const PLOTTING_PERIOD = 50;
const WRITING_PERIOD = 200;

export class Views {
  #page;
  /** @type {readonly View[]} views written in every frame: the drawing and its pointer */
  #held;
  #rendering;
  /** @type {View[]} */
  #views;
  /** @type {readonly MotionView[]} */
  #plots;
  #paces = { plots: new Pace(PLOTTING_PERIOD), others: new Pace(WRITING_PERIOD) };
  /** @type {MotionView[]} */
  #moving;
  /** Kind of the document that is drawn. */
  #kind = "";
  /** @type {Map<string, readonly View[]>} views of the loaded kinds */
  #own = new Map();
  #bringing;
  /** Whether the page opened in motion. */
  #opened;

  /**
   * @param {Page} page
   * @param {readonly View[]} held views written in every frame
   * @param {readonly View[]} views of the page itself
   */
  constructor(page, held, views) {
    const { store, engine, theme, chart } = page;
    this.#page = page;
    byId("rail", HTMLFormElement).addEventListener("submit", (event) => event.preventDefault());
    this.#opened = store.get().view.playing;
    const cursor = new ChartCursor(byId("chart-cursor", HTMLCanvasElement), theme, chart, engine);
    chart.redrawn = () => cursor.redraw();
    if (!page.habits.embedding) {
      new Column("rail", "rail", "left");
      new Column("plots", "plot-column", "right");
    }
    new ChartPointer(byId("charts", HTMLCanvasElement), cursor, page);
    this.#held = held;
    this.#rendering = new Rendering(() => page.notices.tell(BROKE));
    this.#bringing = new Bringing(() => page.redraw(), () => page.notices.tell(LOST));
    this.#views = [...views, new ProblemView(), new Switches(store), new LengthUnits(page), new Title(page), new Becoming(page)];
    this.#plots = [chart, cursor];
    this.#moving = [new Transport(page), new PlotBar(page), new ReadoutTable(page), new AboutLink(page), new Legend(page), new Measures(page), new Comparing(page)];
    byId(LOADS, HTMLDetailsElement).addEventListener("toggle", () => page.redraw());
    for (const [kind, here] of HERE) this.#add(kind, here);
  }

  /** @param {AnySnapshot} snapshot */
  render(snapshot) {
    this.#rendering.all(this.#held, snapshot);
    const { revision } = snapshot;
    const { plots, others } = this.#paces;
    const plotted = !moves(snapshot) || plots.run(revision, () => this.#rendering.all(this.#plots, snapshot));
    const written = others.run(revision, () => this.#write(snapshot));
    if (!plotted || !written) this.#page.redraw();
  }

  /** @param {AnySnapshot} snapshot */
  #write(snapshot) {
    const { state, kind } = snapshot;
    if (!state.view.playing) this.#describe();
    if (kind !== this.#kind) {
      this.#page.shown.clear();
      this.#turn(kind);
    }
    setData(document.documentElement, "still", String(snapshot.summary.moves === null));
    this.#rendering.all(this.#views, snapshot);
    for (const name of TOOL_NAMES) if (state.view[name]) this.#bringLater(name, TOOLS[name], this.#views);
    for (const name of PANEL_NAMES) if (state.view[name]) this.#bringLater(name, PANELS[name], this.#moving);
    if (this.#page.engine.simulator.plotsForces()) this.#bringLater("forces", PANELS.forces, this.#moving);
    if (byId(LOADS, HTMLDetailsElement).open) {
      this.#bringLater(LOADS, async (page) => new (await page.withForces(import("assur/forces/loads.js"))).LoadFold(page), this.#moving);
    }
    if (moves(snapshot)) this.#rendering.all(this.#moving, snapshot);
    if (state.kind !== kind) return;
    const own = this.#own.get(kind);
    if (!own) this.#bring(kind);
    this.#rendering.all(own ?? [], snapshot);
  }

  /**
   * Shows the elements of one kind of document and hides those of others.
   * @param {string} kind
   */
  #turn(kind) {
    this.#kind = kind;
    setData(document.documentElement, "kind", kind);
    for (const element of document.querySelectorAll("[data-of]")) {
      element.classList.toggle("elsewhere", element instanceof HTMLElement && element.dataset.of !== kind);
    }
  }

  /** @param {string} kind */
  #bring(kind) {
    const load = LATER.get(kind);
    if (!load) return;
    this.#bringing.bring(`kind ${kind}`, async () => {
      const loading = awaited(load());
      const { views, words } = await loading;
      if (words) await this.#page.withWords(words, loading);
      this.#add(kind, views);
    });
  }

  /**
   * @param {string} kind
   * @param {Make} views
   */
  #add(kind, views) {
    this.#own.set(kind, views(this.#page));
    this.#page.words.fill(document);
    this.#turn(this.#kind);
  }

  /**
   * @template T
   * @param {keyof typeof PANELS | keyof typeof TOOLS | typeof LOADS} name
   * @param {(page: Page) => Promise<T>} load
   * @param {T[]} views list that the loaded view joins
   */
  #bringLater(name, load, views) {
    this.#bringing.bring(name, async () => {
      views.push(await awaited(load(this.#page)));
    });
  }

  /** Loads the description for screen readers. Most visits begin in motion and do not need it yet. */
  #describe() {
    this.#bringing.bring("description", async () => {
      // The description names the assembly, for which the engine needs its second part.
      const [{ Description }] = await Promise.all([import("assur/app/description.js"), compiledWasm()]);
      this.#views.push(new Description(this.#page.chart, this.#opened));
    });
  }
}
