// The status line of a linkage: its structure, its assembly, the limits of its motion.
import { called, calledIn, numbered } from "assur/core/names.js";
import { html } from "assur/core/html.js";
import { subscript } from "assur/core/symbols.js";

/**
 * @typedef {import("assur/state/details.js").MotionSummary} Summary
 * @typedef {import("assur/kinds/linkage/rail.js").Snapshot} Snapshot
 * @typedef {import("assur/core/words.js").Words} Words
 */

/** @type {readonly import("assur/controls/status.js").Item<Snapshot>[]} */
export const ENTRIES = Object.freeze([
  entry("linkage-w", "status.w", ({ counts: { mobility } }, words) => words.numbers.exact(mobility), { reveals: /^W$/ }),
  entry("redundant", "status.redundant", ({ redundant, counts: { by_count: count, mobility } }, words) =>
    (redundant.length > 0 ? words.text("status.redundant_of", { pairs: listed([...new Set(redundant)], words), count: words.numbers.exact(count), q: words.numbers.exact(mobility - count) }) : "")),
  entry("passive", "status.passive", ({ passive }, words) => listed(passive, words)),
  entry("class", "status.class", ({ class: highest, order }, words) => `${highest}, ${words.numbers.exact(order)}`),
  { name: "formula", title: "status.formula", say: ({ summary: { formula, groups }, words, state: { view } }) => (view.groups ? coloured(groups, words) : { text: calledIn(formula, words) }) },
  entry("linkage-assembly", "status.assembly", (summary, words, coordinate) => numbered(summary, coordinate, words), { late: true }),
  entry("linkage-grashof", "status.grashof", ({ four_bars: bars }, words) =>
    bars.map(({ grashof, links }) => words.text(`grashof.${grashof}`) + (bars.length > 1 ? ` (${listed(links, words)})` : "")).join("; ")),
  entry("linkage-swing", "status.swing-rocker", ({ outputs }, words) => strokes(outputs, true, words), { reveals: /\.angle:swing$/ }),
  entry("linkage-stroke", "status.stroke", ({ outputs }, words) => strokes(outputs, false, words), { reveals: /(?<!\.angle):swing$/ }),
  entry("linkage-time-ratio", "status.time-ratio", ({ outputs }, words) =>
    outputs.flatMap(({ name, time_ratio: ratio }) =>
      ratio === null ? [] : [`${words.numbers.fixed(ratio, 3)} (${called(name.replace(/\.angle$/, ""), words)})`],
    ).join("; "), { reveals: /:time_ratio$/ }),
  entry("linkage-transmission", "status.transmission", ({ transmissions }, words) => worst(transmissions, "transmission", words), { reveals: /\.transmission:worst$/ }),
  entry("linkage-pressure", "status.pressure", ({ transmissions }, words) => worst(transmissions, "pressure", words), { reveals: /\.pressure:worst$/ }),
  entry("linkage-range", "status.range", ({ cycle }, words, coordinate) =>
    (cycle.full ? "" : cycle.arcs.map((arc) => arc.map((end) => coordinate.short(end, words, 2)).join("…")).join(", "))),
  entry("linkage-dead", "status.dead-points", ({ dead_points: dead }, words, coordinate) =>
    dead.map(({ input, kind, links }) => `${coordinate.short(input, words, 2)} ${words.text(`dead.${kind}`)} (${listed(links, words)})`).join("; ")),
  entry("linkage-change", "status.change-points", ({ change_points: points }, words, coordinate) => points.map((input) => coordinate.short(input, words, 2)).join(", ")),
  entry("linkage-unsearched", "status.unsearched", ({ unsearched }, words) =>
    (unsearched ? words.text("status.unsearched_why", { turns: words.numbers.exact(unsearched.turns), most: words.numbers.exact(unsearched.most) }) : "")),
]);

/**
 * @param {string} name
 * @param {string} title
 * @param {(summary: Summary, words: Words, coordinate: Snapshot["coordinate"]) => string} text
 * @param {{ reveals?: RegExp, late?: boolean }} [how]
 * @returns {import("assur/controls/status.js").Item<Snapshot>}
 */
function entry(name, title, text, how) {
  return { name, title, say: ({ summary, words, coordinate }) => ({ text: text(summary, words, coordinate) }), ...how };
}

/**
 * @param {Summary["groups"]} groups
 * @param {Words} words
 * @returns {import("assur/controls/status.js").Said} the structural formula, each term with the colour of its links in the drawing
 */
function coloured(groups, words) {
  const terms = groups.map(({ term }) => calledIn(term, words));
  const marked = groups.map(({ role }, i) =>
    html`${i > 0 ? " → " : ""}<span class="group"><i class="swatch" .style=${`--accent: var(--role-${role})`} data-role=${role} aria-hidden="true"></i>${terms[i]}</span>`);
  return { text: terms.join(" → "), marked };
}

/**
 * @param {Summary["outputs"]} outputs
 * @param {boolean} angles true for the swings of links, false for the strokes of points
 * @param {Words} words
 * @returns {string} swings or strokes, one for every arc of the motion
 */
function strokes(outputs, angles, words) {
  const said = (/** @type {number} */ stroke) => (angles ? words.numbers.angle(stroke, 2) : words.length(words.numbers.short(stroke)));
  return outputs.filter(({ name, searched, swing }) => searched && name.endsWith(".angle") === angles && swing.every((one) => one !== null)).map(({ name, swing }) =>
    `${swing.map((one) => said(one?.stroke ?? 0)).join(", ")} (${called(name.replace(/\.angle$/, ""), words)})`,
  ).join("; ");
}

/**
 * @param {Summary["transmissions"]} transmissions
 * @param {Summary["transmissions"][number]["what"]} what
 * @param {Words} words
 * @returns {string} the worst angle of each dyad, with the name of its inner joint
 */
function worst(transmissions, what, words) {
  const found = transmissions.filter((one) => one.what === what);
  return found.flatMap((one) => (one.worst === null ? [] : [`${words.numbers.angle(one.worst, 2)} (${subscript(one.joint)})`])).join("; ");
}

/**
 * @param {readonly string[]} links
 * @param {Words} words
 */
function listed(links, words) {
  return links.map((link) => called(link, words)).join(", ");
}
