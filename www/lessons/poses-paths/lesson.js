// Steps of the lesson on poses of a body and paths of a point: documents and questions; texts in words.*.json.
import { degrees } from "assur/core/angles.js";

/** @typedef {import("assur/state/details.js").Summaries["poses"]} Summary */

/** Distance from the body's origin within which a hinge is at it, in the unit of lengths. */
const AT_ORIGIN = 1e-6;

/** Least transmission angle that the linkage of the last step may have between the poses, in degrees. */
const TRANSMISSION = 40;

/** Number of real coupler curves through the nine points of the published example. */
const REAL_CURVES = 21;

/** @type {import("assur/lesson/folder.js").Lesson<"poses">} */
export const LESSON = Object.freeze({ kind: "poses", steps: [
  {
    id: "poles",
    formula: "|B₁ − A| = |B₂ − A|",
    shows: [{ preset: "two", at: home }],
    controls: ["hinges"],
    question: { integer: true, within: 0, answer: ({ freedoms }) => freedoms },
  },
  {
    id: "points",
    formula: "|W₁ − C| = |W₂ − C| = |W₃ − C|",
    shows: [{ preset: "three", at: home }],
    controls: ["hinges"],
    question: { unit: "mm", within: 0.1, answer: fromOrigin },
  },
  {
    id: "curves",
    formula: "|W_j − C| = |W₁ − C|, j = 2, 3, 4",
    shows: [{ preset: "four", at: home }],
    controls: ["pairs"],
    question: { integer: true, within: 0, answer: ({ dyads }) => dyads.filter(({ code }) => code === "PR").length },
  },
  {
    id: "five",
    formula: "3 · 3 − 2 − 3 = 4",
    shows: [{ name: "four", preset: "five", at: home }, { name: "two", preset: "higher", at: home }],
    controls: ["pairs"],
    question: { integer: true, within: 0, answer: ({ pairs }) => pairs.length },
  },
  {
    id: "defects",
    shows: [{ name: "first", preset: "renumbered", at: home }, { name: "second", preset: "circuit", at: home }, { name: "third", preset: "five", at: home }, { name: "fourth", preset: "branch", at: home }],
    controls: ["pairs"],
    question: { hides: ["poses-passage", "poses-order", "poses-transmission"], choices: ["none", "order", "branch", "circuit"], answer: defect },
  },
  {
    id: "design",
    shows: [{ name: "task", preset: "task", at: home }, { name: "ours", preset: "ours", at: home }],
    controls: ["hinges", "pairs"],
    question: { unit: "°", within: 0.5, answer: transmission },
  },
  {
    id: "nine",
    kind: /** @type {const} */ ("point-path"),
    formula: "2 + 2 + 3 + 2 = 9",
    shows: [{ preset: "path-nine", at: home }],
    controls: ["nine"],
    question: { integer: true, within: 0, answer: () => REAL_CURVES },
  },
  {
    id: "cognates",
    kind: /** @type {const} */ ("point-path"),
    formula: "C₀ = A + w(D − A), w = (P − B)/(C − B)",
    shows: [{ preset: "cognates", at: home }],
    controls: ["traced"],
    question: { unit: "mm", within: 0.1, answer: shortestSide },
  },
] });

/**
 * @param {Summary | import("assur/state/details.js").Summaries["point-path"]} summary
 * @returns {number | undefined} the drawn input, that of the first pose; undefined without a linkage
 */
function home(summary) {
  return summary.moves === null ? undefined : summary.home;
}

/**
 * @param {Summary} summary
 * @returns {number | undefined} length of the link that is hinged at the body's origin; undefined if there is none
 */
function fromOrigin({ dyads }) {
  const link = dyads.find(({ own }) => own && Math.hypot(...own) < AT_ORIGIN);
  return link?.centre && link.point ? Math.hypot(link.point[0] - link.centre[0], link.point[1] - link.centre[1]) : undefined;
}

/**
 * @param {Summary} summary
 * @returns {Summary["pairs"][number] | undefined} the shown pair
 */
function shown({ pairs, number }) {
  return number === null ? undefined : pairs[number - 1];
}

/**
 * @param {Summary} summary
 * @returns {string | undefined} defect of the shown linkage
 */
function defect(summary) {
  const { passage, order } = shown(summary)?.verdict ?? {};
  if (passage === "continuous") return order === "mixed" ? "order" : "none";
  return passage && { across_dead_point: "branch", other_circuit: "circuit", through_change_point: undefined, unreached: undefined }[passage];
}

/**
 * @param {Summary} summary
 * @returns {number} minimum transmission angle of the shown linkage in degrees; infinite if it is not as the step asks
 */
function transmission(summary) {
  const pair = shown(summary);
  const { mechanism, turns, transmission: least } = pair?.verdict ?? {};
  const angle = degrees(least ?? 0);
  return pair?.sound && mechanism === "four_bar" && turns && angle >= TRANSMISSION ? angle : Infinity;
}

/**
 * @param {import("assur/state/details.js").Summaries["point-path"]} summary
 * @returns {number | undefined} shortest side of the triangle of the fixed pivots of the cognates; undefined if there is no such triangle
 */
function shortestSide({ traced, cognates: [cognate] }) {
  if (!traced || !cognate || !("four_bar" in traced.linkage) || !("four_bar" in cognate)) return undefined;
  const pivots = [...traced.linkage.four_bar.pivots, cognate.four_bar.pivots[1]];
  return Math.min(...pivots.map(([x, y], k) => Math.hypot(x - pivots[(k + 1) % 3][0], y - pivots[(k + 1) % 3][1])));
}
