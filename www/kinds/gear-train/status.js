// The status line of a differential: speeds, largest ratio, mobility, assembly, slip.
import { speedOf } from "assur/kinds/gear-train/drives.js";
import { notation } from "assur/kinds/gear-train/ratios.js";

/** @typedef {import("assur/kinds/gear-train/drives.js").Snapshot} Snapshot */

const BODIES = Object.freeze(/** @type {const} */ ([["sun", "₁"], ["satellite", "₂"], ["carrier", "₃"], ["ring", "₄"]]));

/** @type {Readonly<Record<string, (summary: Snapshot["summary"], words: import("assur/core/words.js").Words) => import("assur/controls/status.js").Said | null>>} contents of the further entries, by name */
const SAID = Object.freeze({
  largest: ({ ratios }, { numbers }) => {
    const found = ratios.find(({ largest }) => largest);
    return found ? { text: `${notation(found.name)} = ${numbers.upTo(found.value, 4)}`, value: found.value } : null;
  },
  // The mobility by count is too low by the number of passive constraints, which remove no freedom.
  w: ({ mobility: { mobility, passive } }, { numbers }) => ({ text: numbers.exact(mobility + passive), value: mobility + passive }),
  builds: ({ builds }) => ({ text: builds ? "✓" : "✗", value: Number(builds) }),
  slipped: ({ slips }, { numbers }) => slips && { text: slips.map((count) => numbers.exact(count)).join(", ") },
});

export const ENTRIES = Object.freeze([
  ...BODIES.map(([body, n]) => ({
    name: `train-${body}`,
    title: "status.train.speed",
    n,
    reveals: speedOf(body),
    say: (/** @type {Snapshot} */ { summary: { speeds }, words }) => ({ text: words.numbers.upTo(speeds[body], 3), value: speeds[body] }),
  })),
  ...Object.entries(SAID).map(([name, say]) => ({
    name: `train-${name}`,
    title: `status.train.${name}`,
    say: (/** @type {Snapshot} */ { summary, words }) => say(summary, words),
  })),
]);
