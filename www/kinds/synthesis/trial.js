// Lengths to try instead of a solution, typed or set by sliders.
import { NumberRow } from "assur/controls/number-row.js";
import { section } from "assur/controls/section.js";
import { make } from "assur/core/dom.js";
import { numberEntries } from "assur/core/names.js";
import { Seen } from "assur/core/seen.js";
import { edited } from "assur/state/state.js";

/**
 * @typedef {import("assur/kinds/synthesis/positions.js").Snapshot} Snapshot
 * @typedef {NonNullable<import("assur/state/state.js").Documents["synthesis"]["trial"]>} Lengths
 */

/** For the lengths of coupler, output link and driver: the subscript of the symbol and the role of the colour. */
const LENGTHS = Object.freeze([{ n: "₁", role: "coupler" }, { n: "₂", role: "rocker" }, { n: "₃", role: "crank" }]);

/** `RANGE`: range of a slider, as multiples of the frame's length. `STEP`: step of a slider, in the unit of length. */
const RANGE = Object.freeze([0.05, 3]);
const STEP = 0.01;

/** Significant digits to which the initial lengths, those of the drawn linkage, are rounded. */
const DIGITS = 4;

export class TrialView {
  #rows;
  #given = make("input", { id: "trial", type: "checkbox" });
  /** @type {Snapshot | null} */
  #snapshot = null;
  #shown = new Seen();

  /** @param {import("assur/app/page.js").Page} page */
  constructor({ store, drafts }) {
    const edit = (/** @type {Lengths | null} */ trial) => store.update((state) => edited(state, "synthesis", () => ({ trial })));
    numberEntries("trial", (index) => LENGTHS[index].n);
    this.#rows = LENGTHS.map(({ n, role }, index) => new NumberRow(
      { field: `trial[${index}]`, id: `trial-${index + 1}`, key: "trial", n, symbol: `l${n}`, role, slider: { min: RANGE[0], max: RANGE[1], step: STEP } },
      drafts,
      (value) => {
        const lengths = this.#lengths();
        if (lengths) edit(replaced(lengths, index, value));
      },
    ));
    this.#given.addEventListener("change", () => edit(this.#given.checked ? this.#lengths() : null));
    section("synthesis", "trial.heading", "trial", [
      make("label", { class: "check" }, [this.#given, " ", make("span", { "data-t": "trial.given" })]),
      ...this.#rows.map(({ element }) => element),
    ]);
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    const { state: { document: { trial, frame } }, summary, problems, words } = snapshot;
    this.#snapshot = snapshot;
    const wrong = new Set(problems.map(({ field }) => field));
    if (this.#shown.same(trial, frame, summary, words, ...wrong)) return;
    this.#given.checked = Boolean(trial);
    for (const [index, row] of this.#rows.entries()) {
      row.element.hidden = !trial;
      if (!trial) continue;
      row.fit(RANGE[0] * frame, RANGE[1] * frame);
      row.show(trial[index], words, wrong.has(row.field));
    }
  }

  /** @returns {Lengths | null} the tried lengths, or, if none are tried, those of the drawn linkage */
  #lengths() {
    if (!this.#snapshot) return null;
    const { state: { document: { trial } }, summary: { drawn } } = this.#snapshot;
    if (trial) return trial;
    const [l1, l2, l3] = drawn.lengths.map((length) => Number(length.toPrecision(DIGITS)));
    return [l1, l2, l3];
  }
}

/**
 * @param {Lengths} lengths
 * @param {number} index index of the changed length
 * @param {number} value
 * @returns {Lengths}
 */
function replaced([l1, l2, l3], index, value) {
  return [index === 0 ? value : l1, index === 1 ? value : l2, index === 2 ? value : l3];
}
