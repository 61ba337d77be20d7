// The approximation: a search in a worker, whose best linkage is shown while it goes on.
import { sentence } from "assur/controls/problems.js";
import { section } from "assur/controls/section.js";
import { make, write } from "assur/core/dom.js";
import { Seen } from "assur/core/seen.js";
import { compiledWasm } from "assur/core/wasm.js";
import { choose, onLeaving } from "assur/kinds/point-path/choose.js";
import { TracingList } from "assur/kinds/point-path/tracing-list.js";
import { withoutExtras } from "assur/state/state.js";

/**
 * @typedef {import("assur/kinds/point-path/verdict.js").Snapshot} Snapshot
 * @typedef {import("assur/kinds/point-path/verdict.js").Found} Found
 * @typedef {import("assur/core/problem.js").Problem} Problem
 * @typedef {import("assur/types/web.js").TracingProgress} Progress
 */

/** Kinds of linkage that may be sought. */
const KINDS = Object.freeze(/** @type {const} */ (["four_bars", "swinging", "slider_cranks", "both"]));

/** Measures of the distance between path and curve that a search can minimise. */
const MEASURES = Object.freeze(/** @type {const} */ (["greatest", "squares"]));

/** Time after which a search ends, in seconds. */
const SECONDS = 10;

export class SearchView {
  #page;
  #kinds = make("select", { id: "path-kinds", class: "control", "data-t-label": "path.kinds" }, KINDS.map((kind) => make("option", { value: kind, "data-t": `path.kinds.${kind}` })));
  #measure = make("select", { id: "path-measure", class: "control", "data-t-label": "path.measure" }, MEASURES.map((measure) => make("option", { value: measure, "data-t": `path.measure.${measure}` })));
  #start = make("button", { id: "path-search", class: "control add", type: "button", "data-t": "path.search", onclick: () => this.#search() });
  #stop = make("button", { id: "path-search-stop", class: "control add", type: "button", "data-t": "path.stop", hidden: "", onclick: () => this.#finish() });
  #told = make("p", { id: "path-search-progress", role: "status" });
  #list;
  /** @type {Worker | null} */
  #worker = null;
  /** @type {readonly unknown[]} points, course and crank angles of the search */
  #subject = [];
  #changed = false;
  /** The linkage shown at the start, or the one that the search showed last. */
  #last = "";
  /** @type {readonly Found[]} */
  #found = [];
  /** @type {Progress | null} */
  #progress = null;
  /** @type {readonly Problem[]} */
  #problems = [];
  /** @type {Snapshot | null} */
  #snapshot = null;
  #shown = new Seen();

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    this.#page = page;
    this.#list = new TracingList("path-found", "path.found", page);
    onLeaving(page, () => this.#finish());
    section("point-path", "path.search_heading", "search", [this.#kinds, this.#measure, this.#start, this.#stop, this.#told, this.#list.element]);
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    this.#snapshot = snapshot;
    const { path, course, angles_deg: angles } = snapshot.state.document;
    if (this.#subject.length > 0 && (this.#subject[0] !== path || this.#subject[1] !== course || this.#subject[2] !== angles)) this.#forget();
    if (this.#shown.same(snapshot.summary, snapshot.state.document, snapshot.words, this.#found, this.#progress, this.#problems, this.#worker)) return;
    const { words } = snapshot;
    const { numbers } = words;
    this.#start.hidden = this.#worker !== null;
    this.#stop.hidden = this.#worker === null;
    const told = this.#progress ? [words.text(this.#progress.exact ? "path.search_exact" : "path.candidates", { count: numbers.exact(this.#progress.candidates) })] : [];
    write(this.#told, [...told, ...this.#problems.map((problem) => sentence(problem, words))].join(" "));
    this.#list.show(this.#found, snapshot);
  }

  #show() {
    if (this.#snapshot) this.render(this.#snapshot);
  }

  /** Ends the search, and forgets its results, which belong to another path. */
  #forget() {
    this.#worker?.terminate();
    this.#worker = this.#progress = null;
    this.#subject = this.#found = this.#problems = [];
  }

  #search() {
    this.#forget();
    const state = this.#page.store.get();
    if (state.kind !== "point-path") return;
    const kind = KINDS[this.#kinds.selectedIndex];
    const wishes = {
      squares: this.#measure.value === "squares",
      four_bars: kind !== "slider_cranks",
      slider_cranks: kind === "slider_cranks" || kind === "both",
      swinging: kind === "swinging",
    };
    this.#subject = [state.document.path, state.document.course, state.document.angles_deg];
    this.#changed = false;
    this.#last = this.#shownNow;
    const worker = new Worker(import.meta.resolve("assur/kinds/point-path/search-worker.js"), { type: "module" });
    this.#worker = worker;
    const lost = () => {
      if (worker === this.#worker) this.#receive({ problems: [{ code: "not_arrived" }] });
    };
    worker.addEventListener("message", ({ data }) => {
      if (worker === this.#worker) this.#receive(data);
    });
    worker.addEventListener("error", lost);
    compiledWasm().then((wasm) => worker.postMessage({ wasm, state: withoutExtras(state), wishes, seconds: SECONDS })).catch(lost);
    this.#show();
    this.#stop.focus();
  }

  /** @param {{ progress?: Progress, ended?: boolean, problems?: readonly Problem[] }} said message from the worker */
  #receive({ progress, ended = false, problems = [] }) {
    this.#problems = problems;
    if (progress) this.#progress = progress;
    if (progress?.found) {
      this.#found = progress.found;
      const [best] = progress.found;
      // If the reader has chosen another linkage or undone a step since then, the search ends and changes nothing.
      if (this.#last !== this.#shownNow) ended = true;
      else if (best && this.#isBetter(best)) this.#take(best);
    }
    if (ended || problems.length > 0) this.#finish();
    else this.#show();
  }

  /**
   * Shows an improvement on the page. All improvements of one search are undone in one step.
   * @param {Found} best
   */
  #take({ linkage }) {
    const { history } = this.#page;
    if (this.#changed) history.join();
    else history.close();
    this.#changed = true;
    choose(this.#page, linkage);
    this.#last = this.#shownNow;
  }

  /** The linkage of the document as text. */
  get #shownNow() {
    const state = this.#page.store.get();
    return state.kind === "point-path" ? JSON.stringify(state.document.linkage ?? null) : "";
  }

  /**
   * @param {Found} found
   * @returns {boolean} whether the found linkage is better than the shown one, or the shown one is of another kind
   */
  #isBetter(found) {
    const traced = this.#snapshot?.summary.traced;
    if (!traced) return true;
    const of = (/** @type {Found} */ { greatest, root_mean_square: mean }) => (this.#measure.value === "squares" ? mean ?? Infinity : greatest);
    return of(found) < of(traced) || "four_bar" in found.linkage !== "four_bar" in traced.linkage;
  }

  #finish() {
    const focused = document.activeElement === this.#stop;
    this.#worker?.terminate();
    this.#worker = null;
    this.#show();
    if (focused) this.#start.focus();
  }
}
