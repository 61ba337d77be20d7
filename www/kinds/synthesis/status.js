// The status line of a synthesis: the verdict on the drawn linkage.
import { degrees } from "assur/core/angles.js";

/** @typedef {import("assur/types/web.js").SynthesisSummary["drawn"]} Solution */

/** @typedef {NonNullable<Solution["verdict"]>} Verdict */

/** @type {Readonly<Record<string, (verdict: Verdict, words: import("assur/core/words.js").Words, solution: Solution) => import("assur/controls/status.js").Said>>} contents, by name */
const SAID = Object.freeze({
  grashof: ({ grashof }, words) => ({ text: words.text(`grashof.${grashof}`) }),
  passage: ({ passage }, words) => ({ text: words.text(`verdict.${passage}`) }),
  order: ({ order }, words) => ({ text: words.text(`verdict.${order}`) }),
  transmission: ({ transmission }, words) => ({ text: words.numbers.angle(transmission, 2), value: degrees(transmission) }),
  ratio: ({ size_ratio: ratio }, words) => ({ text: words.numbers.upTo(ratio, 2), value: ratio }),
  gap: (_, words, { gap }) => ({ text: words.numbers.upTo(gap, 4), value: gap }),
});

const TITLES = Object.freeze({
  grashof: "status.grashof", passage: "verdict.passage", order: "verdict.order", transmission: "status.transmission", ratio: "verdict.ratio", gap: "verdict.gap",
});

export const ENTRIES = Object.freeze(Object.entries(SAID).map(([name, say]) => ({
  name: `synthesis-${name}`,
  title: TITLES[/** @type {keyof typeof TITLES} */ (name)],
  say: (/** @type {import("assur/kinds/synthesis/positions.js").Snapshot} */ { summary: { drawn }, words }) => drawn.verdict && say(drawn.verdict, words, drawn),
})));
