// All four-bars whose coupler point passes through nine points, found in workers.
import { sentence } from "assur/controls/problems.js";
import { section } from "assur/controls/section.js";
import { make, write } from "assur/core/dom.js";
import { download } from "assur/core/download.js";
import { Seen } from "assur/core/seen.js";
import { onLeaving } from "assur/kinds/point-path/choose.js";
import { NineWorkers } from "assur/kinds/point-path/nine-workers.js";
import { TracingList } from "assur/kinds/point-path/tracing-list.js";
import { FILTERS, csvOf } from "assur/kinds/point-path/verdict.js";
import { withoutExtras } from "assur/state/state.js";

/**
 * @typedef {import("assur/kinds/point-path/verdict.js").Snapshot} Snapshot
 * @typedef {import("assur/kinds/point-path/verdict.js").Found} Found
 * @typedef {import("assur/core/problem.js").Problem} Problem
 * @typedef {import("assur/types/web.js").NinePointProgress} Progress
 */

/** Number of points that leave a finite number of four-bars. */
const POINTS = 9;

export class NinePointsView {
  #page;
  #start = make("button", { id: "nine-search", class: "control add", type: "button", "data-t": "path.nine", onclick: () => this.#search() });
  #stop = make("button", { id: "nine-stop", class: "control add", type: "button", "data-t": "path.stop", hidden: "", onclick: () => this.#finish() });
  #bar = make("progress", { id: "nine-progress", "data-t-label": "path.nine", hidden: "" });
  #told = make("p", { id: "nine-told", role: "status" });
  #filter = make("select", { id: "nine-filter", class: "control", "data-t-label": "path.filter" });
  #count = make("p", { id: "nine-count" });
  #save;
  #list;
  /** @type {NineWorkers | null} */
  #workers = null;
  /** @type {unknown} points of the search */
  #subject = null;
  /** @type {readonly Found[]} */
  #found = [];
  /** @type {Progress | null} */
  #progress = null;
  #ended = false;
  /** @type {readonly Problem[]} */
  #problems = [];
  /** @type {Snapshot | null} */
  #snapshot = null;
  #section;
  #shown = new Seen();

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    this.#page = page;
    this.#list = new TracingList("nine-found", "path.nine_found", page);
    for (const name of Object.keys(FILTERS)) this.#filter.append(make("option", { value: name, "data-t": `path.filter.${name}` }));
    this.#filter.addEventListener("change", () => this.#write());
    this.#save = make("button", { id: "nine-csv", class: "control add", type: "button", "data-t": "path.csv", onclick: () => this.#download() });
    onLeaving(page, () => this.#finish());
    this.#section = section("point-path", "path.nine_heading", "nine", [this.#start, this.#stop, this.#bar, this.#told, this.#filter, this.#count, this.#list.element, this.#save]);
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    this.#snapshot = snapshot;
    const { state: { document }, words } = snapshot;
    if (this.#subject && this.#subject !== document.path) this.#forget();
    if (this.#shown.same(document, words)) return;
    this.#section.hidden = (document.course ?? "points") !== "points";
    this.#write();
  }

  #write() {
    const snapshot = this.#snapshot;
    if (!snapshot) return;
    const { state: { document }, words } = snapshot;
    const { numbers } = words;
    const nine = document.path.length === POINTS;
    const working = this.#workers !== null;
    this.#start.hidden = working;
    this.#start.disabled = !nine;
    this.#stop.hidden = this.#bar.hidden = !working;
    const progress = this.#progress;
    if (progress) {
      this.#bar.max = progress.all;
      this.#bar.value = progress.all - progress.left;
    }
    write(this.#told, [...(nine ? [] : [words.text("path.not_nine", { count: numbers.exact(document.path.length) })]), ...this.#said(words)].join(" "));
    const listed = this.#found.filter(FILTERS[this.#filter.value]);
    this.#filter.hidden = this.#save.hidden = this.#found.length === 0;
    this.#count.hidden = listed.length === this.#found.length;
    const [shown, all] = [listed.length, this.#found.length].map((count) => numbers.exact(count));
    write(this.#count, words.text("path.listed", { shown, all }));
    this.#list.show(listed, snapshot);
  }

  /** @param {import("assur/core/words.js").Words} words */
  #said(words) {
    const { numbers } = words;
    const said = this.#problems.map((problem) => sentence(problem, words));
    if (!this.#progress) return said;
    const { curves, all, unproved, complete } = this.#progress;
    const real = new Set(this.#found.map(({ curve }) => curve)).size;
    said.push(words.text("path.curves", { curves: numbers.exact(curves), all: numbers.exact(all), real: numbers.exact(real), four_bars: numbers.exact(this.#found.length) }));
    if (unproved > 0) said.push(words.text("path.unproved", { count: numbers.exact(unproved) }));
    if (this.#ended && !complete) said.push(words.text("path.incomplete"));
    return said;
  }

  /** Ends the search, and forgets its results, which belong to other points. */
  #forget() {
    this.#workers?.stop();
    this.#workers = this.#subject = this.#progress = null;
    this.#found = this.#problems = [];
    this.#ended = false;
  }

  #search() {
    this.#forget();
    const state = this.#page.store.get();
    if (state.kind !== "point-path") return;
    this.#subject = state.document.path;
    const workers = new NineWorkers(withoutExtras(state), (said) => {
      if (workers === this.#workers) this.#receive(said);
    });
    this.#workers = workers;
    this.#write();
    this.#stop.focus();
  }

  /** @param {import("assur/kinds/point-path/nine-workers.js").Said} said */
  #receive({ progress, found, ended, problems = [] }) {
    if (progress) this.#progress = progress;
    if (found) this.#found = found;
    this.#problems = problems;
    if (ended || problems.length > 0) this.#finish();
    else this.#write();
  }

  #finish() {
    if (!this.#workers) return;
    const focused = document.activeElement === this.#stop;
    this.#workers?.stop();
    this.#workers = null;
    this.#ended = true;
    this.#write();
    if (focused) this.#start.focus();
  }

  #download() {
    const listed = this.#found.filter(FILTERS[this.#filter.value]);
    download(new Blob([csvOf(listed)], { type: "text/csv" }), "four-bars.csv");
  }
}
