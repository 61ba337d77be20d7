// The method of sections: cuts step by step, the count of the open chain, and the resulting mobility.
import { section } from "assur/controls/section.js";
import { make } from "assur/core/dom.js";
import { html, render } from "assur/core/html.js";
import { called } from "assur/core/names.js";
import { Seen } from "assur/core/seen.js";
import { actual, asked, freedomsOf, sum } from "assur/kinds/scheme/sums.js";
import { edited } from "assur/state/state.js";

/**
 * @typedef {import("assur/kinds/scheme/opening.js").Snapshot} Snapshot
 * @typedef {NonNullable<Snapshot["summary"]["sections"]>} Sections
 */

/** Time between two cuts, in milliseconds: enough to watch the chain fall open and to look at the result. */
const PAUSE = 1600;

export class MethodView {
  #page;
  #step = make("button", { id: "cut-step", class: "control add", type: "button", "data-t": "method.step", onclick: () => this.#begin() });
  #join = make("button", { id: "cut-join", class: "control add", type: "button", "data-t": "method.join", onclick: () => this.#put([]) });
  #said = make("div", { id: "method-said", "aria-live": "polite" });
  /** @type {readonly string[]} cuts still to be shown */
  #coming = [];
  #timer = 0;
  /** @type {Snapshot | null} */
  #snapshot = null;
  #shown = new Seen();

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    this.#page = page;
    section("scheme", "method.heading", "method", [make("div", { class: "buttons" }, [this.#step, this.#join]), this.#said]);
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    const { state: { document }, summary, words, stale, withheld } = snapshot;
    if (this.#shown.same(document, summary, words, stale, withheld)) return;
    this.#snapshot = snapshot;
    // A different cut, made by hand, stops the automatic cuts.
    if (this.#coming.length > 0 && !document.cut.every((name, i) => name === summary.automatic[i])) this.#stop();
    this.#step.hidden = document.task != null;
    this.#step.disabled = summary.automatic.length === 0;
    this.#join.disabled = document.cut.length === 0;
    const lines = stale ? [] : this.#lines(snapshot);
    render(lines.map((line) => html`<p>${line}</p>`), this.#said);
  }

  /** @param {Snapshot} snapshot */
  #lines(snapshot) {
    const { state: { document }, summary: { sections, closed, apart, planar, mobility }, words } = snapshot;
    const { numbers } = words;
    if (closed.length > 0) return [words.text("method.closed", { pairs: closed.join(", ") })];
    if (apart.length > 0) return [words.text("method.apart", { links: apart.map((link) => called(link, words)).join(", ") })];
    if (!sections || document.task != null) return [];
    // Without cuts W₀ equals W, so a lesson that asks for W hides W₀, too.
    const total = sections.cuts.length > 0 ? numbers.exact(sections.open) : asked(sections.open, "w", snapshot);
    const lines = [words.text("method.open"), `W₀ = ${freedomsOf(sections.left, total, words)}`];
    if (sections.cuts.length > 0) {
      lines.push(
        words.text(planar ? "method.removed_plane" : "method.removed_space"), `ΣS = ${sum(sections.loops.map((loop) => loop.constraints), words)}`,
        words.text("method.mobility"), `W = W₀ − ΣS = ${numbers.exact(sections.open)} − ${numbers.exact(sections.removed)} = ${asked(mobility, "w", snapshot)}`,
      );
    }
    if (planar && sections.cuts.length > 0) lines.push(words.text(actual(snapshot.summary).ranked ? "method.redundant_ranked" : "method.redundant"), redundant(sections, snapshot));
    if (!snapshot.withheld.has("scheme-w")) lines.push(drives(mobility, words));
    return lines;
  }

  #begin() {
    const { automatic } = this.#snapshot?.summary ?? { automatic: [] };
    this.#put([]);
    this.#coming = automatic;
    this.#timer = setTimeout(() => this.#next(0), PAUSE / 4);
  }

  /** @param {number} count of the cuts already made */
  #next(count) {
    if (this.#coming.length <= count) {
      this.#stop();
      return;
    }
    this.#cut(this.#coming.slice(0, count + 1));
    this.#timer = setTimeout(() => this.#next(count + 1), PAUSE);
  }

  #stop() {
    clearTimeout(this.#timer);
    this.#coming = [];
  }

  /** @param {readonly string[]} cut */
  #put(cut) {
    this.#stop();
    this.#cut(cut);
  }

  /** @param {readonly string[]} cut */
  #cut(cut) {
    this.#page.store.update((state) => edited(state, "scheme", () => ({ cut: [...cut] })));
  }
}

/**
 * @param {Sections} sections of a planar scheme
 * @param {Snapshot} snapshot
 * @returns {string} q = ΣS + W − W₀, with ΣS and W₀ in space
 */
function redundant({ loops, removed_spatial: removed, open_spatial: open }, snapshot) {
  const { numbers } = snapshot.words;
  const { mobility, redundant: q } = actual(snapshot.summary);
  const terms = loops.length > 1 ? `(${loops.map((loop) => numbers.exact(loop.spatial_constraints)).join(" + ")})` : numbers.exact(removed);
  return `q = ΣS + W − W₀ = ${terms} + ${asked(mobility, "w", snapshot)} − ${numbers.exact(open)} = ${asked(q, "q", snapshot)}`;
}

/**
 * @param {number} mobility
 * @param {import("assur/core/words.js").Words} words
 */
function drives(mobility, words) {
  if (mobility < 1) return words.text("method.locked");
  if (mobility === 1) return words.text("method.single");
  const [count, more] = [mobility, mobility - 1].map((one) => words.numbers.exact(one));
  return words.text("method.drives", { count, more });
}
