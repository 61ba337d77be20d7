// Verdicts on linkages that trace a path, in words.
import { degrees } from "assur/core/angles.js";

/**
 * @typedef {import("assur/types/web.js").FoundTracing} Found
 * @typedef {NonNullable<Found["verdict"]>} Verdict
 * @typedef {import("assur/core/words.js").Words} Words
 * @typedef {import("assur/state/model.js").OwnSnapshot<"point-path">} Snapshot
 */

/** Distance from a path that counts as none, as a part of the size of the path. */
const EXACT = 1e-10;

/** Tests of the filters, by their names. */
export const FILTERS = Object.freeze(/** @type {Readonly<Record<string, (found: Found) => boolean>>} */ ({
  all: () => true,
  works: ({ verdict }) => verdict?.passage === "continuous",
  sound: ({ verdict }) => verdict?.passage === "continuous" && verdict.order !== "mixed",
}));

/**
 * @param {Found} found
 * @param {Words} words
 * @returns {string} type of the linkage; of a four-bar also its Grashof type
 */
export function typeOf({ linkage, verdict }, words) {
  const type = words.text("four_bar" in linkage ? "path.type.four_bar" : "path.type.slider_crank");
  return verdict?.grashof ? `${type}, ${words.text(`grashof.${verdict.grashof}`)}` : type;
}

/**
 * @param {Found} found
 * @param {number} size of the path
 * @param {Words} words
 * @returns {string} greatest distance from the path, as a length and as a share of the size of the path
 */
export function missedBy({ greatest }, size, words) {
  const { numbers } = words;
  // A smaller distance than the precision of the numbers is a rounding error.
  if (greatest <= EXACT * size) return words.text("path.exact");
  return words.text("path.missed_by", { length: numbers.short(greatest), share: numbers.short((100 * greatest) / size) });
}

/**
 * @param {Found} found
 * @param {Words} words
 * @returns {string}
 */
export function verdictOf({ verdict }, words) {
  if (!verdict) return words.text("path.no_verdict");
  const { passage, order, turns, transmission, size_ratio: ratio } = verdict;
  return [
    words.text(`path.passage.${passage}`),
    ...(passage === "continuous" ? [words.text(`path.order.${order}`)] : []),
    words.text(turns ? "path.turns" : "path.rocks"),
    `μ ≥ ${words.numbers.angle(transmission, 2)}`,
    `${words.text("path.ratio")} ${words.numbers.upTo(ratio, 2)}`,
  ].join("; ");
}

/**
 * @param {Snapshot} snapshot
 * @returns {string[]} sentences on a special path, and on a path without a linkage
 */
export function saidOf({ summary: { special, traced }, words }) {
  return [...(special ? [words.text(`path.special.${special}`)] : []), ...(traced ? [] : [words.text("problem.no_tracing")])];
}

/** Columns of the file of linkages. */
const COLUMNS = Object.freeze([
  "curve", "type", "grashof", "passage", "order", "input_turns", "transmission_deg", "size_ratio", "greatest_distance", "root_mean_square",
  "a_x", "a_y", "b_x", "b_y", "c_x", "c_y", "d_x", "d_y", "p_x", "p_y",
]);

/**
 * @param {readonly Found[]} all
 * @returns {string} the linkages as CSV, with a line of names. D of a slider-crank is the direction of the guide
 */
export function csvOf(all) {
  const lines = all.map(({ curve, linkage, verdict, greatest, root_mean_square: mean }) => {
    const { grashof = null, passage = "", order = "", turns = "", transmission = null, size_ratio: ratio = "" } = verdict ?? {};
    const [type, [a, b, c, d, p]] = "four_bar" in linkage
      ? ["four_bar", [linkage.four_bar.pivots[0], ...linkage.four_bar.joints, linkage.four_bar.pivots[1], linkage.four_bar.point]]
      : ["slider_crank", [linkage.slider_crank.pivot, ...linkage.slider_crank.joints, linkage.slider_crank.guide, linkage.slider_crank.point]];
    return [curve ?? "", type, grashof ?? "", passage, order, turns, transmission === null ? "" : degrees(transmission), ratio, greatest, mean ?? "", ...[a, b, c, d, p].flat()];
  });
  return [COLUMNS, ...lines].map((cells) => `${cells.join(",")}\n`).join("");
}
