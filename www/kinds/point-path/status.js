// The status line of a path: how the shown linkage traces it.
import { degrees } from "assur/core/angles.js";
import { missedBy, typeOf } from "assur/kinds/point-path/verdict.js";

/** @typedef {import("assur/kinds/point-path/verdict.js").Found} Found */

/** @type {readonly { name: string, title: string, say: (found: Found, snapshot: import("assur/kinds/point-path/verdict.js").Snapshot) => import("assur/controls/status.js").Said | null }[]} */
const SAID = Object.freeze([
  { name: "type", title: "path.status.type", say: (found, { words }) => ({ text: typeOf(found, words) }) },
  { name: "distance", title: "path.status.distance", say: (found, { summary: { size }, words }) => ({ text: missedBy(found, size, words), value: found.greatest }) },
  { name: "passage", title: "path.status.passage", say: ({ verdict }, { words }) => (verdict ? { text: words.text(`path.passage.${verdict.passage}`) } : null) },
  {
    name: "order", title: "path.status.order",
    say: ({ verdict }, { words }) => (verdict?.passage === "continuous" ? { text: words.text(`path.order.${verdict.order}`) } : null),
  },
  {
    name: "transmission", title: "status.transmission",
    say: ({ verdict }, { words }) => (verdict ? { text: words.numbers.angle(verdict.transmission, 2), value: degrees(verdict.transmission) } : null),
  },
  { name: "ratio", title: "path.ratio", say: ({ verdict }, { words }) => (verdict ? { text: words.numbers.upTo(verdict.size_ratio, 2), value: verdict.size_ratio } : null) },
]);

export const ENTRIES = Object.freeze(SAID.map(({ name, title, say }) => ({
  name: `path-${name}`,
  title,
  say: (/** @type {import("assur/kinds/point-path/verdict.js").Snapshot} */ snapshot) => {
    const { traced } = snapshot.summary;
    return traced ? say(traced, snapshot) : null;
  },
})));
