// Chebyshev's formula for the mobility with its numbers, written before W in the status line while the reader draws.
import { byId, make, write } from "assur/core/dom.js";
import { Seen } from "assur/core/seen.js";

/**
 * @typedef {import("assur/types/web.js").CountsSummary} Counts
 * @typedef {import("assur/core/words.js").Words} Words
 */

/** Names of the entries of the status line that hold W. */
const MOBILITIES = Object.freeze(["draft-w", "linkage-w"]);

/**
 * Writes Chebyshev's formula with its numbers. Pairs are called p₅ and p₄ here, because P₁ and P₂ are traced points.
 * @param {Counts} counts `mobility` by rank exceeds `by_count` by the number q of redundant constraints
 * @param {Words["numbers"]} numbers
 */
export function counted({ links, lower, higher, mobility, by_count: byCount }, numbers) {
  const redundant = mobility - byCount;
  const symbols = `3n − 2p₅ − p₄${redundant === 0 ? "" : " + q"}`;
  const values = [`3·${numbers.exact(links)}`, `2·${numbers.exact(lower)}`, numbers.exact(higher)].join(" − ");
  return `= ${symbols} = ${values}${redundant === 0 ? "" : ` + ${numbers.exact(redundant)}`} =`;
}

export class Count {
  #seen = new Seen();
  /** @type {readonly string[]} the formula for each entry of `MOBILITIES`; empty for none */
  #formulas = MOBILITIES.map(() => "");

  constructor() {
    // The status line gets the entries of a kind of document with the first document of this kind.
    new MutationObserver(() => this.#write()).observe(byId("status", HTMLElement), { childList: true });
  }

  /**
   * @param {Pick<import("assur/state/model.js").AnySnapshot, "summary" | "words" | "withheld">} snapshot
   * @param {boolean} on whether the reader draws
   */
  render({ summary, words, withheld }, on) {
    if (this.#seen.same(summary, words, withheld, on)) return;
    const counts = on && "counts" in summary && summary.counts && "by_count" in summary.counts ? summary.counts : null;
    // If a lesson asks for W, the formula is hidden.
    this.#formulas = MOBILITIES.map((name) => (counts && !withheld.has(name) ? counted(counts, words.numbers) : ""));
    this.#write();
  }

  /** Writes each formula before its number, if the number is there yet. */
  #write() {
    for (const [i, name] of MOBILITIES.entries()) {
      const value = document.getElementById(`out-${name}`);
      if (!value) continue;
      if (!value.previousElementSibling?.matches(".draw-count")) value.before(make("dd", { class: "draw-count" }), " ");
      write(/** @type {Element} */ (value.previousElementSibling), this.#formulas[i]);
    }
  }
}
