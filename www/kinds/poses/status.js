// The status line of poses: the verdict on the shown linkage.
import { degrees } from "assur/core/angles.js";
import { typeOf } from "assur/kinds/poses/verdicts.js";

/** @typedef {import("assur/kinds/poses/verdicts.js").Verdict} Verdict */

/** Content of an entry without a value. */
const NONE = Object.freeze({ text: "–" });

/** @type {readonly { name: string, title: string, say: (verdict: Verdict, words: import("assur/core/words.js").Words) => import("assur/controls/status.js").Said }[]} */
const SAID = Object.freeze([
  { name: "type", title: "poses.status.type", say: (verdict, words) => ({ text: typeOf(verdict, words) }) },
  { name: "passage", title: "poses.heading", say: ({ passage }, words) => ({ text: words.text(`poses.passage.${passage}`) }) },
  { name: "order", title: "poses.status.order", say: ({ passage, order }, words) => (passage === "continuous" ? { text: words.text(`poses.order.${order}`) } : NONE) },
  {
    name: "transmission", title: "status.transmission",
    say: ({ transmission }, words) => (transmission === null ? NONE : { text: words.numbers.angle(transmission, 2), value: degrees(transmission) }),
  },
  { name: "ratio", title: "poses.ratio", say: ({ size_ratio: ratio }, words) => ({ text: words.numbers.upTo(ratio, 2), value: ratio }) },
]);

export const ENTRIES = Object.freeze(SAID.map(({ name, title, say }) => ({
  name: `poses-${name}`,
  title,
  say: (/** @type {import("assur/kinds/poses/task.js").Snapshot} */ { summary: { pairs, number }, words }) => {
    const verdict = pairs[(number ?? 0) - 1]?.verdict;
    return verdict ? say(verdict, words) : null;
  },
})));
