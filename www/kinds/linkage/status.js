// The status line of a linkage: its structure, its assembly, the limits of its motion.
import { StatusLine } from "assur/controls/status.js";
import { called, calledIn, numbered } from "assur/core/names.js";
import { make } from "assur/core/dom.js";
import { subscript } from "assur/core/symbols.js";

/**
 * @typedef {import("assur/state/details.js").MotionSummary} Summary
 * @typedef {import("assur/kinds/linkage/rail.js").Snapshot} Snapshot
 * @typedef {import("assur/core/words.js").Words} Words
 */

/** @type {Readonly<Record<string, (summary: Summary, words: Words, snapshot: Snapshot) => string | (Node | string)[]>>} */
const ENTRIES = Object.freeze({
  "linkage-w": ({ counts: { mobility } }, words) => words.numbers.exact(mobility),
  redundant: ({ redundant, counts: { by_count: count, mobility } }, words) =>
    (redundant.length > 0 ? words.text("status.redundant_of", { pairs: listed([...new Set(redundant)], words), count: words.numbers.exact(count), q: words.numbers.exact(mobility - count) }) : ""),
  passive: ({ passive }, words) => listed(passive, words),
  class: ({ class: highest, order }, words) => `${highest}, ${words.numbers.exact(order)}`,
  formula: ({ formula, groups }, words, { state: { view } }) => (view.groups ? coloured(groups, words) : calledIn(formula, words)),
  "linkage-assembly": (summary, words, { coordinate }) => numbered(summary, coordinate, words),
  "linkage-grashof": ({ four_bars: bars }, words) =>
    bars.map(({ grashof, links }) => words.text(`grashof.${grashof}`) + (bars.length > 1 ? ` (${listed(links, words)})` : "")).join("; "),
  "linkage-swing": ({ outputs }, words) => strokes(outputs, true, words),
  "linkage-stroke": ({ outputs }, words) => strokes(outputs, false, words),
  "linkage-time-ratio": ({ outputs }, words) =>
    outputs.flatMap(({ name, time_ratio: ratio }) =>
      ratio === null ? [] : [`${words.numbers.fixed(ratio, 3)} (${called(name.replace(/\.angle$/, ""), words)})`],
    ).join("; "),
  "linkage-transmission": ({ transmissions }, words) => worst(transmissions, "transmission", words),
  "linkage-pressure": ({ transmissions }, words) => worst(transmissions, "pressure", words),
  "linkage-range": ({ cycle }, words, { coordinate }) =>
    (cycle.full ? "" : cycle.arcs.map((arc) => arc.map((end) => coordinate.short(end, words, 2)).join("…")).join(", ")),
  "linkage-dead": ({ dead_points: dead }, words, { coordinate }) =>
    dead.map(({ input, kind, links }) => `${coordinate.short(input, words, 2)} ${words.text(`dead.${kind}`)} (${listed(links, words)})`).join("; "),
  "linkage-change": ({ change_points: points }, words, { coordinate }) => points.map((input) => coordinate.short(input, words, 2)).join(", "),
  "linkage-unsearched": ({ unsearched }, words) => (unsearched ? words.text("status.unsearched_why", { turns: words.numbers.exact(unsearched.turns), most: words.numbers.exact(unsearched.most) }) : ""),
});

const TITLES = Object.freeze(/** @type {Record<string, string>} */ ({
  "linkage-w": "w",
  "linkage-assembly": "assembly", "linkage-grashof": "grashof", "linkage-swing": "swing-rocker", "linkage-stroke": "stroke",
  "linkage-time-ratio": "time-ratio",
  "linkage-transmission": "transmission", "linkage-pressure": "pressure", "linkage-range": "range", "linkage-dead": "dead-points", "linkage-change": "change-points",
  "linkage-unsearched": "unsearched",
}));

/** Entries that take some time to compute. */
const LATE = Object.freeze(["linkage-assembly"]);

/** @returns {StatusLine<Snapshot>} */
export function linkageStatus() {
  return new StatusLine("linkage", Object.entries(ENTRIES).map(([name, say]) => ({
    name, title: `status.${TITLES[name] ?? name}`, late: LATE.includes(name), say: (snapshot) => ({ text: say(snapshot.summary, snapshot.words, snapshot) }),
  })));
}

/**
 * @param {Summary["groups"]} groups
 * @param {Words} words
 * @returns {(Node | string)[]} the structural formula, each term with the colour of its links in the drawing
 */
function coloured(groups, words) {
  const swatch = (/** @type {string} */ role) => make("i", { class: "swatch", style: `--accent: var(--role-${role})`, "data-role": role, "aria-hidden": "true" });
  return groups.flatMap(({ term, role }, i) => [...(i > 0 ? [" → "] : []), make("span", { class: "group" }, [swatch(role), calledIn(term, words)])]);
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
