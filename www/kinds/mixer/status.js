// The status line of a mixer: kind and properties of the mechanism.
import { degrees } from "assur/core/angles.js";
import { WHEELS, wheelLink } from "assur/kinds/mixer/wheels.js";

/**
 * @typedef {import("assur/state/details.js").Summaries["mixer"]} Summary
 * @typedef {import("assur/state/model.js").OwnSnapshot<"mixer">} Snapshot
 * @typedef {import("assur/state/state.js").State<"mixer">} State
 * @typedef {import("assur/core/words.js").Words} Words
 * @typedef {import("assur/controls/status.js").Said} Entry
 * @typedef {import("assur/controls/status.js").Item<Snapshot>} Item
 */

/** @typedef {(summary: Summary, words: Words, state: State) => Entry | null} Say gives the content of an entry, or null for no entry */

/** One entry for the swing of each possible peripheral wheel. */
const WHEEL_SWINGS = [...Array(WHEELS.most).keys()].map((index) => {
  const wheel = wheelLink(index);
  const how = { title: "status.swing-wheel", n: String(index + WHEELS.first), reveals: swingOf(wheel) };
  return entry(`swing-${wheel}`, ({ outputs: [, ...wheels] }, words) => (wheels[index] ? swingEntry(wheels[index].swing, words) : null), how);
});

export const ENTRIES = Object.freeze([
  entry("grashof", ({ four_bars: [{ grashof }] }, words) => ({ text: words.text(`grashof.${grashof}`) })),
  entry("assembly", (_, words, { document }) => ({
    text: words.text("status.assembly_of", { number: words.numbers.exact(document.assembly), count: words.numbers.exact(2) }),
    value: document.assembly,
  })),
  entry("swing-rocker", ({ outputs: [{ swing }] }, words) => swingEntry(swing, words), { reveals: swingOf("rocker") }),
  ...WHEEL_SWINGS,
  entry("overlaps", ({ overlaps }, words) => overlapsEntry(overlaps, words), { class: "warning" }),
  entry("turns", ({ outputs: [, ...wheels] }, words) => ({
    text: wheels.map(({ turns }) => turns.map((one) => words.numbers.fixed(one, 3)).join(", ")).join("; "),
    value: wheels[0].turns[0],
  })),
  entry("ratio", ({ ratios }, words) => ({ text: ratios.map((ratio) => words.numbers.upTo(ratio, 4)).join("; "), value: ratios[0] })),
  entry("time-ratio", ({ outputs: [{ time_ratio: ratio }] }, words) => (ratio === null ? null : { text: words.numbers.fixed(ratio, 3), value: ratio }), { reveals: /:time_ratio$/ }),
  entry("transmission", ({ transmissions: [{ worst }] }, words) => (worst === null ? null : angleEntry(worst, words)), { reveals: /\.transmission:worst$/ }),
  entry("range", ({ cycle }, words) => (cycle.full ? null : { text: cycle.arcs.map((arc) => arc.map((end) => words.numbers.angle(end, 2)).join("…")).join(", ") })),
  entry("dead-points", ({ dead_points: points }, words) => anglesEntry(points.map(({ input }) => input), words)),
  entry("change-points", ({ change_points: points }, words) => anglesEntry(points, words)),
]);

/**
 * @param {string} name
 * @param {Say} say
 * @param {Partial<Item>} [more]
 * @returns {Item}
 */
function entry(name, say, more) {
  return { name, title: `status.${name}`, say: ({ summary, words, state }) => say(summary, words, state), ...more };
}

/**
 * @param {string} link
 * @returns {RegExp} the name by which a lesson asks for the link's swing
 */
function swingOf(link) {
  return new RegExp(`^${link}\\.angle:swing$`);
}

/**
 * @param {readonly (import("assur/types/web.js").Between | null)[]} swings one for every arc of the cycle; null if the link turns fully
 * @param {Words} words
 * @returns {Entry}
 */
function swingEntry(swings, words) {
  const entries = swings.map((swing) =>
    swing ? angleEntry(swing.stroke, words) : { text: words.text("status.turns_fully") },
  );
  return entries.length === 1 ? entries[0] : { text: entries.map(({ text }) => text).join(", ") };
}

/**
 * @param {readonly (readonly [number, number])[]} pairs of overlapping wheels, as indices from 0
 * @param {Words} words
 * @returns {Entry | null}
 */
function overlapsEntry(pairs, words) {
  if (pairs.length === 0) return null;
  const { first } = WHEELS;
  const pair = (/** @type {readonly [number, number]} */ [one, other]) =>
    words.text("status.pair", { one: String(one + first), other: String(other + first) });
  return { text: pairs.map(pair).join(", ") };
}

/**
 * @param {number} angle
 * @param {Words} words
 * @returns {Entry}
 */
function angleEntry(angle, words) {
  return { text: `${words.numbers.fixed(degrees(angle), 3)}°`, value: degrees(angle) };
}

/**
 * @param {readonly number[]} angles
 * @param {Words} words
 * @returns {Entry | null}
 */
function anglesEntry(angles, words) {
  if (angles.length === 0) return null;
  return { text: angles.map((angle) => words.numbers.angle(angle, 2)).join(", ") };
}
