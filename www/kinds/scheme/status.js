// The status line of a scheme: counts, and the mobility by rank.
import { actual, symbolOf } from "assur/kinds/scheme/sums.js";

/** @typedef {import("assur/kinds/scheme/opening.js").Snapshot} Snapshot */

/** @type {Readonly<Record<string, (summary: Snapshot["summary"], words: import("assur/core/words.js").Words) => import("assur/controls/status.js").Said | null>>} contents, by name */
export const SAID = Object.freeze({
  w: ({ mobility }, { numbers }) => ({ text: numbers.exact(mobility), value: mobility }),
  q: (summary, { numbers }) => {
    const { redundant } = actual(summary);
    return { text: numbers.exact(redundant), value: redundant };
  },
  rank: ({ plane, space }, { numbers }) => {
    const judged = plane ?? space;
    return judged && { text: numbers.exact(judged.mobility), value: judged.mobility };
  },
  links: ({ counts }, { numbers }) => ({ text: numbers.exact(counts.links), value: counts.links }),
  pairs: ({ counts }, { numbers }) => ({ text: counts.pairs.map(({ freedoms, count }) => `${symbolOf(freedoms)} = ${numbers.exact(count)}`).join(", ") }),
});

/** The entries. They are empty for a practice task, because the task asks for their numbers. */
export const ENTRIES = Object.freeze(Object.entries(SAID).map(([name, say]) => ({
  name: `scheme-${name}`,
  title: `status.scheme.${name}`,
  say: (/** @type {Snapshot} */ { summary, words, state }) => (state.document.task != null ? null : say(summary, words)),
})));
