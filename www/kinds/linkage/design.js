// "Design your dwell": targets for the output, lengths that may change, and a search whose improvements are shown.
import { NumberRow } from "assur/controls/number-row.js";
import { sentence } from "assur/controls/problems.js";
import { degrees, radians } from "assur/core/angles.js";
import { make, write } from "assur/core/dom.js";
import { called } from "assur/core/names.js";
import { Seen } from "assur/core/seen.js";
import { compiledWasm } from "assur/core/wasm.js";
import { withDocument } from "assur/state/state.js";

/**
 * @typedef {import("assur/core/problem.js").Problem} Problem
 * @typedef {import("assur/kinds/linkage/rail.js").Snapshot} Snapshot
 * @typedef {import("assur/state/state.js").State} State
 * @typedef {import("assur/types/web.js").StepSummary} Progress
 */

/** Choices for the limit of a length's change, in per cent. */
const PER_CENT = Object.freeze(["1", "2", "5", "10", "20"]);
const USUAL = "5";

/** Number of candidates after which progress is reported if none improves. Screen readers announce every report. */
const TOLD = 10;

/** Pause of the search after an improvement is shown, in milliseconds. Without it the motion would be jerky. */
const SHOWN = 400;

/** Keys of the texts for the ways in which a search ends. */
const ENDS = Object.freeze({ fulfilled: "design.fulfilled", settled: "design.settled", stopped: "design.stopped" });

export class DesignView {
  #store;
  #drafts;
  #history;
  #wanted = make("div");
  #links = make("div");
  #start = make("button", { id: "design-start", class: "control add", type: "button", "data-t": "design.start", onclick: () => this.#search() });
  #stop = make("button", { id: "design-stop", class: "control add", type: "button", "data-t": "design.stop", onclick: () => this.#finish("stopped") });
  #told = make("p", { id: "design-progress", role: "status" });
  /** @type {{ arc: NumberRow, stroke: NumberRow } | null} */
  #rows = null;
  /** @type {{ arc: number | null, stroke: number | null }} targets in the units of the fields: degrees, and for a stroke the unit of length; null for the present value */
  #wish = { arc: null, stroke: null };
  /** @type {{ field: string, name: string, said: HTMLElement, moves: HTMLInputElement, by: HTMLSelectElement }[]} */
  #movable = [];
  #built = new Seen();
  /** @type {Snapshot | null} */
  #snapshot = null;
  /** @type {Worker | null} */
  #worker = null;
  /** @type {ReturnType<typeof subject> | null} document and plot at the start of the search or after its last improvement */
  #subject = null;
  #changed = false;
  /** @type {Progress | null} */
  #progress = null;
  /** @type {keyof typeof ENDS | null} */
  #end = null;
  /** @type {readonly Problem[]} */
  #problems = [];

  /** @param {import("assur/app/page.js").Page} page */
  constructor({ store, drafts, history }) {
    this.#store = store;
    this.#drafts = drafts;
    this.#history = history;
    this.element = make("details", { id: "design" }, [
      make("summary", { "data-t": "design.heading" }),
      this.#wanted,
      this.#links,
      this.#start,
      this.#stop,
      this.#told,
    ]);
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    const before = this.#snapshot;
    this.#snapshot = snapshot;
    const { state, summary, coordinate, words, stale } = snapshot;
    this.element.hidden = coordinate.moves !== "angle";
    if (this.#worker && !this.#holds(state)) this.#finish("stopped");
    this.#build(snapshot);
    this.#name(words);
    const { profile } = summary;
    const { arc, stroke } = this.#now();
    this.#rows?.arc.show(this.#wish.arc ?? arc, words, false);
    this.#rows?.stroke.show(this.#wish.stroke ?? stroke, words, false);
    this.#start.disabled = stale || !summary.cycle.full || typeof profile?.stroke !== "number";
    this.#show();
    if (before?.words !== words) this.#tell();
  }

  /** Returns the present arc and stroke in the units of the fields, and whether the output is an angle. */
  #now() {
    const { profile, plotted } = /** @type {Snapshot} */ (this.#snapshot).summary;
    const angle = plotted[0]?.endsWith(".angle") ?? true;
    const arc = profile?.dwell ? profile.dwell.arc[1] - profile.dwell.arc[0] : 0;
    const stroke = profile?.stroke ?? 0;
    return { angle, arc: degrees(arc), stroke: angle ? degrees(stroke) : stroke };
  }

  /**
   * Builds the fields for another linkage or another output.
   * @param {Snapshot} snapshot
   */
  #build({ state: { document: linkage }, summary, words }) {
    const { angle } = this.#now();
    const lengths = summary.dimensions.filter(({ kind }) => kind === "length");
    if (this.#built.same(JSON.stringify([linkage.drivers, lengths.map(({ field, name }) => [field, name]), summary.plotted[0]]))) return;
    this.#wish = { arc: null, stroke: null };
    this.#progress = this.#end = null;
    this.#problems = [];
    this.#drafts.dropAll(["design.arc", "design.stroke", "design.swing"]);
    this.#rows = {
      arc: new NumberRow({ field: "design.arc", id: "design-arc", symbol: "θ", role: "coupler", unit: "°" }, this.#drafts, (arc) => this.#wishes({ arc })),
      stroke: new NumberRow(
        { field: angle ? "design.swing" : "design.stroke", id: "design-stroke", symbol: "s", role: "coupler", unit: angle ? "°" : "" },
        this.#drafts,
        (stroke) => this.#wishes({ stroke }),
      ),
    };
    this.#wanted.replaceChildren(this.#rows.arc.element, this.#rows.stroke.element);
    const crank = linkage.drivers[0]?.crank;
    this.#movable = lengths.map(({ field, index, name }) => {
      const moves = make("input", { id: `design-move-${index}`, type: "checkbox", "data-t-label": "design.move", "data-n": name });
      moves.checked = name !== crank;
      const by = make("select", { id: `design-by-${index}`, class: "control", "data-t-label": "design.by", "data-n": name },
        PER_CENT.map((value) => make("option", { value }, [`± ${value} %`])));
      by.value = USUAL;
      return { field, name, said: make("span"), moves, by };
    });
    this.#links.replaceChildren(
      ...this.#movable.map(({ said, moves, by }) => make("div", { class: "row" }, [make("label", { class: "check" }, [moves, " ", said]), by])),
    );
    words.fill(this.element);
    this.#tell();
  }

  /**
   * Writes the names of the links that may change.
   * @param {import("assur/core/words.js").Words} words
   */
  #name(words) {
    for (const { name, said, moves, by } of this.#movable) {
      const link = called(name, words);
      if (said.textContent === link) continue;
      write(said, link);
      moves.dataset.n = by.dataset.n = link;
      if (moves.parentElement?.parentElement) words.fill(moves.parentElement.parentElement);
    }
  }

  /** @param {Partial<{ arc: number, stroke: number }>} change */
  #wishes(change) {
    this.#wish = { ...this.#wish, ...change };
  }

  /**
   * Checks whether the page still shows the mechanism of the search.
   * @param {State} state
   */
  #holds({ document: linkage, view: { plot } }) {
    return linkage === this.#subject?.document && plot === this.#subject.plot;
  }

  #search() {
    const state = this.#store.get();
    const { angle, arc, stroke } = this.#now();
    // A missing target is set to the value at the start, because the present value changes with each improvement.
    this.#wish = { arc: this.#wish.arc ?? arc, stroke: this.#wish.stroke ?? stroke };
    const wishes = {
      arc: radians(this.#wish.arc ?? 0),
      stroke: angle ? radians(this.#wish.stroke ?? 0) : this.#wish.stroke,
      movable: this.#movable.filter(({ moves }) => moves.checked).map(({ field, by }) => ({ field, by: Number(by.value) / 100 })),
    };
    this.#subject = subject(state);
    this.#changed = false;
    this.#progress = this.#end = null;
    this.#problems = [];
    const worker = new Worker(import.meta.resolve("assur/kinds/linkage/design-worker.js"), { type: "module" });
    this.#worker = worker;
    const lost = () => {
      if (worker === this.#worker) this.#receive({ problems: [{ code: "not_arrived" }] });
    };
    worker.addEventListener("message", ({ data }) => {
      // Messages sent before the search was stopped are ignored.
      if (worker === this.#worker) this.#receive(data);
    });
    worker.addEventListener("error", lost);
    compiledWasm().then((wasm) => worker.postMessage({ wasm, state, wishes })).catch(lost);
    this.#show();
    this.#stop.focus();
    this.#tell();
  }

  /** @param {{ progress?: Progress, problems?: readonly Problem[] }} said message from the worker */
  #receive({ progress, problems }) {
    if (!progress) {
      this.#problems = problems ?? [];
      this.#finish(null);
      return;
    }
    if (!this.#holds(this.#store.get())) {
      this.#finish("stopped");
      return;
    }
    this.#progress = progress;
    if (progress.document) this.#take(progress.document);
    if (progress.end) this.#finish(progress.end);
    else if (progress.accepted || progress.judged % TOLD === 0) this.#tell();
  }

  /**
   * Shows an improvement on the page. All improvements of one search are undone in one step.
   * @param {Partial<import("assur/state/state.js").LinkageDocument>} change
   */
  #take(change) {
    if (this.#changed) this.#history.join();
    else this.#history.close();
    this.#changed = true;
    this.#store.update((state) => withDocument(state, change));
    this.#subject = subject(this.#store.get());
    const worker = this.#worker;
    setTimeout(() => worker?.postMessage({}), SHOWN);
  }

  /** @param {keyof typeof ENDS | null} end */
  #finish(end) {
    this.#worker?.terminate();
    this.#worker = null;
    this.#end = end;
    this.#history.close();
    const focused = document.activeElement === this.#stop;
    this.#show();
    if (focused) this.#start.focus();
    this.#tell();
  }

  /** Shows the button that stops a running search, otherwise the button that starts one. */
  #show() {
    this.#start.hidden = this.#worker !== null;
    this.#stop.hidden = this.#worker === null;
  }

  /** Writes the progress of the search. */
  #tell() {
    if (!this.#snapshot) return;
    const { words } = this.#snapshot;
    const { numbers } = words;
    const { angle } = this.#now();
    // The engine calls the swing of an angle a stroke, too.
    const swings = (/** @type {Problem} */ problem) => angle && problem.field === "design.stroke";
    const said = this.#problems.map((problem) => sentence(swings(problem) ? { ...problem, field: "design.swing" } : problem, words));
    if (this.#progress) {
      const { judged, before, reached: { arc, stroke, residual, singularity_margin } } = this.#progress;
      said.push(words.text("design.progress", {
        judged: numbers.exact(judged),
        arc: numbers.angle(arc, 2),
        travel: words.text(angle ? "dwell.swing" : "dwell.stroke"),
        stroke: angle ? numbers.angle(stroke, 2) : words.length(numbers.short(stroke)),
        deviation: numbers.short(100 * residual),
        before: numbers.short(100 * before),
      }));
      if (this.#end) said.push(words.text(ENDS[this.#end]), words.text("design.checked"));
      // The margin from singular poses is 1 if no group is solved by iteration.
      const tight = Math.abs(singularity_margin);
      if (this.#end && tight < 1) said.push(words.text("design.conditioning", { conditioning: numbers.short(tight) }));
      this.#told.dataset.value = String(residual);
    } else if (this.#worker) said.push(words.text("design.coming"));
    write(this.#told, said.join(" "));
  }
}

/** @param {State} state */
function subject({ document, view: { plot } }) {
  return { document, plot };
}
