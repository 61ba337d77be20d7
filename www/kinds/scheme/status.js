// The status line of a scheme: counts, and the mobility by rank.
import { StatusLine } from "assur/controls/status.js";
import { actual, symbolOf } from "assur/kinds/scheme/sums.js";

/** @typedef {import("assur/kinds/scheme/opening.js").Snapshot} Snapshot */

/** @type {Readonly<Record<string, (summary: Snapshot["summary"], words: import("assur/core/words.js").Words) => import("assur/controls/status.js").Entry | null>>} */
export const ENTRIES = Object.freeze({
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

/** Makes the status line. It is empty for a practice task, because the task asks for its numbers. @returns {StatusLine<Snapshot>} */
export function schemeStatus() {
  return new StatusLine("scheme", Object.entries(ENTRIES).map(([name, say]) => ({
    name: `scheme-${name}`,
    title: `status.scheme.${name}`,
    say: ({ summary, words, state }) => (state.document.task != null ? null : say(summary, words)),
  })));
}
