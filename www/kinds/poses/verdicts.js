// Verdicts on pairs of dyads in words, and sentences on the number of dyads.
import { sentence } from "assur/controls/problems.js";
import { degrees } from "assur/core/angles.js";

/**
 * @typedef {import("assur/types/web.js").DyadPairSummary} Pair
 * @typedef {NonNullable<Pair["verdict"]>} Verdict
 * @typedef {import("assur/kinds/poses/task.js").Snapshot} Snapshot
 * @typedef {import("assur/core/words.js").Words} Words
 */

/** Number of pairs of circle point and centre point of five poses, complex ones included. */
const BURMESTER = 4;

/** Tests of the filters, by their names. */
export const FILTERS = Object.freeze(/** @type {Readonly<Record<string, (pair: Pair) => boolean>>} */ ({
  all: () => true,
  works: ({ verdict }) => verdict?.passage === "continuous",
  sound: ({ sound }) => sound,
}));

/**
 * @param {Verdict} verdict
 * @param {Words} words
 * @returns {string} type of the linkage; of a four-bar also its Grashof type
 */
export function typeOf({ mechanism, grashof }, words) {
  const type = words.text(`poses.type.${mechanism}`);
  return grashof === null ? type : `${type}, ${words.text(`grashof.${grashof}`)}`;
}

/**
 * @param {Pair} pair
 * @param {Words} words
 * @returns {string}
 */
export function verdictOf({ verdict }, words) {
  if (!verdict) return words.text("poses.no_linkage");
  const { passage, order, turns, transmission, size_ratio: ratio } = verdict;
  return [
    words.text(`poses.passage.${passage}`),
    ...(passage === "continuous" ? [words.text(`poses.order.${order}`)] : []),
    words.text(turns ? "poses.turns" : "poses.rocks"),
    ...(transmission === null ? [] : [`μ ≥ ${words.numbers.angle(transmission, 2)}`]),
    `${words.text("poses.ratio")} ${words.numbers.upTo(ratio, 2)}`,
  ].join("; ");
}

/**
 * @param {Snapshot} snapshot
 * @returns {string[]} sentences on the number of dyads, on special poses and on what prevents the shown linkage
 */
export function saidOf({ summary, state: { document }, words }) {
  const { special, repeated, dyads, complex, complete, pairs, reasons } = summary;
  const { numbers } = words;
  const said = repeated.length > 0 ? [words.text("poses.repeated", { poses: repeated.join(", ") })] : [];
  if (special) {
    const [x = 0, y = 0] = special.at ?? [];
    said.push(words.text(`poses.special.${special.code}`, { x: numbers.short(x), y: numbers.short(y), angle: numbers.angle(Math.atan2(y, x), 2) }));
  } else if (document.poses.length - repeated.length === 5) {
    const [real, most] = [dyads.length, BURMESTER].map((count) => numbers.exact(count));
    said.push(words.text("poses.burmester", { real, most }));
    if (!complete) said.push(words.text("poses.incomplete"));
    if (complex > 0 && dyads.length < 2) said.push(words.text("poses.complex"));
  }
  // The sentence on special poses already names what guides the body.
  if (special) return said;
  if (pairs.length > 0) said.push(...reasons.map((problem) => sentence(problem, words, document)));
  else said.push(words.text("problem.no_guidance"));
  return said;
}

/** Columns of the file of pairs. */
const COLUMNS = Object.freeze([
  "dyad1", "dyad2", "centre1_x", "centre1_y", "point1_x", "point1_y", "centre2_x", "centre2_y", "point2_x", "point2_y", "residual",
  "mechanism", "grashof", "passage", "order", "input_turns", "transmission_deg", "size_ratio", "no_defects",
]);

/**
 * @param {Snapshot["summary"]} summary
 * @param {readonly number[]} listed numbers of pairs
 * @returns {string} the pairs as CSV, with a line of names
 */
export function csvOf({ pairs, dyads }, listed) {
  const lines = listed.map((number) => {
    const { dyads: both, sound, verdict } = pairs[number - 1];
    const of = both.map((k) => dyads[k - 1]);
    const places = of.flatMap(({ centre, point }) => [...(centre ?? ["", ""]), ...(point ?? ["", ""])]);
    const residual = Math.max(...of.map((dyad) => dyad.residual));
    const { mechanism = "", grashof = null, passage = "", order = "", turns = "", transmission = null, size_ratio: ratio = "" } = verdict ?? {};
    const judged = [mechanism, grashof ?? "", passage, order, turns, transmission === null ? "" : degrees(transmission), ratio];
    return [...of.map(({ code }) => code), ...places, residual, ...judged, sound];
  });
  return [COLUMNS, ...lines].map((cells) => `${cells.join(",")}\n`).join("");
}
