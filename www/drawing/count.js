// The count of the mobility in numbers, written before W in the status line while one draws.
import { make, write } from "assur/core/dom.js";
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
  /** @type {Map<string, HTMLElement>} */
  #outputs = new Map();
  #seen = new Seen();

  /**
   * @param {Pick<import("assur/state/model.js").AnySnapshot, "summary" | "words" | "withheld">} snapshot
   * @param {boolean} on whether the reader draws
   */
  render({ summary, words, withheld }, on) {
    if (this.#seen.same(summary, words, withheld, on, this.#place())) return;
    const counts = on && "counts" in summary && summary.counts && "by_count" in summary.counts ? summary.counts : null;
    // A lesson that asks for W does not have it counted.
    for (const [name, output] of this.#outputs) write(output, counts && !withheld.has(name) ? counted(counts, words.numbers) : "");
  }

  /** Puts the formula before the numbers that the status line has by now, and returns how many there are. */
  #place() {
    for (const name of MOBILITIES) {
      const value = document.getElementById(`out-${name}`);
      if (!value || this.#outputs.get(name)?.nextElementSibling === value) continue;
      const output = make("dd", { class: "draw-count" });
      value.before(output, " ");
      this.#outputs.set(name, output);
    }
    return this.#outputs.size;
  }
}
