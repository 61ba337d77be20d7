// All that shows the state. What only one kind of mechanism has comes with its kind, sentences for screen readers with the
// first rest.
import { LOST } from "assur/app/notices.js";
import { ProblemView } from "assur/controls/problems.js";
import { Switches } from "assur/controls/switches.js";
import { Transport } from "assur/controls/transport.js";
import { byId, setData } from "assur/core/dom.js";
import { HERE, LATER } from "assur/kinds/kinds.js";
import { PlotBar } from "assur/plots/bar.js";
import { ChartCursor } from "assur/plots/cursor.js";
import { ChartPointer } from "assur/plots/pointer.js";
import { ReadoutTable } from "assur/plots/readouts.js";

/**
 * @typedef {import("assur/app/page.js").Page} Page
 * @typedef {import("assur/state/model.js").Snapshot} Snapshot
 * @typedef {import("assur/state/state.js").Kind} Kind
 * @typedef {{ render(snapshot: Snapshot): void }} View
 */

export class Views {
  #page;
  /** @type {View[]} */
  #views;
  /** @type {Map<Kind, readonly View[]>} those of the kinds that were loaded, or are on their way */
  #own = new Map();
  #described = false;
  /** Whether the first rest is a reader's doing. */
  #opened;

  /**
   * @param {Page} page
   * @param {readonly View[]} views that the page has itself
   */
  constructor(page, views) {
    const { store, engine, theme, chart } = page;
    this.#page = page;
    byId("rail", HTMLFormElement).addEventListener("submit", (event) => event.preventDefault());
    this.#opened = store.get().view.playing;
    const cursor = new ChartCursor(byId("chart-cursor", HTMLCanvasElement), theme, chart, engine);
    chart.redrawn = () => cursor.redraw();
    new ChartPointer(byId("charts", HTMLCanvasElement), cursor, page);
    this.#views = [...views, cursor, new Transport(page), new PlotBar(page), new ReadoutTable(), new ProblemView(), new Switches(store)];
    for (const [kind, make] of HERE) this.#add(kind, make);
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    const { state, kind } = snapshot;
    if (!state.view.playing && !this.#described) this.#describe();
    setData(document.documentElement, "kind", kind);
    for (const view of this.#views) view.render(snapshot);
    if (state.kind !== kind) return;
    const own = this.#own.get(kind);
    if (!own) this.#bring(kind);
    for (const view of own ?? []) view.render(snapshot);
  }

  /** @param {Kind} kind */
  async #bring(kind) {
    this.#own.set(kind, []);
    try {
      const make = await LATER.get(kind)?.();
      if (make) this.#add(kind, make);
      this.#page.redraw();
    } catch {
      this.#page.notices.tell(LOST);
    }
  }

  /**
   * @param {Kind} kind
   * @param {import("assur/kinds/kinds.js").Make} make
   */
  #add(kind, make) {
    const { views, common } = make(this.#page);
    this.#own.set(kind, views);
    this.#views.push(...common);
    this.#page.words.fill(document);
  }

  /** Most visits begin in motion, and need no sentences for screen readers. */
  async #describe() {
    this.#described = true;
    try {
      const { Description } = await import("assur/app/description.js");
      this.#views.push(new Description(this.#page.chart, this.#opened));
      this.#page.redraw();
    } catch {
      this.#described = false;
    }
  }
}
