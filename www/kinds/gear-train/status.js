// The status line of a differential: speeds, largest ratio, mobility, assembly, slip.
import { StatusLine } from "assur/controls/status.js";
import { notation } from "assur/kinds/gear-train/ratios.js";

/** @typedef {import("assur/kinds/gear-train/drives.js").Snapshot} Snapshot */

const BODIES = Object.freeze(/** @type {const} */ ([["sun", "₁"], ["satellite", "₂"], ["carrier", "₃"], ["ring", "₄"]]));

/** @type {Readonly<Record<string, (summary: Snapshot["summary"], words: import("assur/core/words.js").Words) => import("assur/controls/status.js").Entry | null>>} */
const ENTRIES = Object.freeze({
  largest: ({ ratios }, { numbers }) => {
    const found = ratios.find(({ largest }) => largest);
    return found ? { text: `${notation(found.name)} = ${numbers.upTo(found.value, 4)}`, value: found.value } : null;
  },
  // The mobility by count is too low by the number of passive constraints, which remove no freedom.
  w: ({ mobility: { mobility, passive } }, { numbers }) => ({ text: numbers.exact(mobility + passive), value: mobility + passive }),
  builds: ({ builds }) => ({ text: builds ? "✓" : "✗", value: Number(builds) }),
  slipped: ({ slips }, { numbers }) => slips && { text: slips.map((count) => numbers.exact(count)).join(", ") },
});

/** @returns {StatusLine<Snapshot>} */
export function trainStatus() {
  const speeds = BODIES.map(([body, number]) => ({
    name: `train-${body}`,
    title: "status.train.speed",
    n: number,
    say: (/** @type {Snapshot} */ { summary: { speeds: all }, words }) => ({ text: words.numbers.upTo(all[body], 3), value: all[body] }),
  }));
  const rest = Object.entries(ENTRIES).map(([name, say]) => ({
    name: `train-${name}`,
    title: `status.train.${name}`,
    say: (/** @type {Snapshot} */ { summary, words }) => say(summary, words),
  }));
  return new StatusLine("gear-train", [...speeds, ...rest]);
}
