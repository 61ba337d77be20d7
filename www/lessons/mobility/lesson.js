// Steps of the lesson on mobility by sections: documents and questions; texts in words.*.json.

/** @typedef {import("assur/state/details.js").Summaries["scheme"]} Summary */

/** Choices: the mobility by count is lower than, equal to, or higher than the mobility by rank. */
const COUNTS = Object.freeze(["low", "right", "high"]);

/** @type {import("assur/lesson/folder.js").Lesson<"scheme">} */
export const LESSON = Object.freeze({ kind: "scheme", steps: [
  {
    id: "arm",
    formula: "W = Σ i·Pᵢ",
    shows: [{ name: "spherical", preset: "mobility-1a" }, { name: "revolute", preset: "mobility-1b" }],
    controls: ["pairs"],
    question: { hides: ["scheme-w", "scheme-rank"], within: 0, answer: ({ mobility }) => mobility },
  },
  {
    id: "four_bar",
    formula: "W = W₀ − ΣS, S = 3 − i",
    relations: ["001.(1)"],
    shows: [{ preset: "mobility-2a" }],
    controls: ["method"],
    question: { hides: ["scheme-w", "scheme-rank"], within: 0, answer: ({ mobility }) => mobility },
  },
  {
    id: "redundant",
    formula: "q = ΣS + W − W₀, S = 6 − i\nq = Σ(6 − i)Pᵢ − 6n + W",
    shows: [{ preset: "mobility-2a" }],
    controls: ["geometry"],
    question: { hides: ["scheme-q"], within: 0, answer: ({ space }) => space?.redundant },
  },
  {
    id: "tilted",
    formula: "W = W₀ − ΣS, S = 6 − i",
    shows: [{ preset: "tilted" }],
    controls: ["geometry"],
    question: { hides: ["scheme-w"], within: 0, answer: ({ counts }) => counts.spatial },
  },
  {
    id: "contours",
    formula: "W = W₀ − ΣS\nW = Σ i·Pᵢ − Σλₖ",
    shows: [{ preset: "mobility-2c" }],
    controls: ["method"],
    // The answer is the number of cuts needed to open all contours.
    question: { integer: true, within: 0, answer: ({ counts }) => pairs(counts) - counts.links, places: ({ counts }) => ({ pairs: pairs(counts), links: counts.links }) },
  },
  {
    id: "moving",
    relations: ["001.(6)"],
    shows: [{ preset: "moving" }],
    controls: ["method"],
    question: { hides: ["scheme-q"], within: 0, answer: ({ redundant_by_plane: redundant }) => redundant ?? undefined },
  },
  {
    id: "spatial",
    formula: "W = W₀ − ΣS, S = 6 − i",
    relations: ["001.(2)"],
    shows: [{ preset: "mobility-3" }],
    controls: ["look", "method"],
    question: { hides: ["scheme-w", "scheme-rank"], within: 0, answer: ({ mobility }) => mobility },
  },
  {
    id: "layout",
    formula: "q = W − 6n + Σ(6 − i)Pᵢ",
    shows: [{ name: "ours", preset: "mobility-3" }, { name: "parallel", preset: "layout" }],
    controls: ["geometry", "look"],
    question: { hides: ["scheme-q"], within: 0, answer: ({ space }) => space?.redundant },
  },
  {
    id: "referee",
    formula: "W = 3n − r, W = 6n − r",
    shows: [
      { name: "parallelogram", preset: "parallelogram" }, { name: "roller", preset: "roller" }, { name: "sarrus", preset: "sarrus" },
      { name: "bennett", preset: "bennett" }, { name: "rssr", preset: "rssr" }, { name: "hooke", preset: "hooke" },
    ],
    controls: ["geometry", "look"],
    readouts: ["scheme-w", "scheme-rank"],
    question: { choices: COUNTS, answer: counted },
  },
  {
    id: "moves",
    kind: /** @type {const} */ ("linkage"),
    formula: "q = W − (3n − 2P₁)",
    shows: [{ name: "cranks", preset: "coupled-cranks", play: true }, { name: "doubled", preset: "doubled", play: true }],
    readouts: ["linkage-w"],
    question: { hides: ["redundant", "formula"], within: 0, answer: (/** @type {import("assur/state/details.js").Summaries["linkage"]} */ { counts }) => counts.mobility - counts.by_count },
  },
  {
    id: "mending",
    formula: "q = Σ(6 − i)Pᵢ − 6n + W",
    shows: [{ preset: "mobility-2a" }],
    controls: ["replace"],
    readouts: ["scheme-q"],
    question: { integer: true, within: 0, answer: ({ mended }) => mended?.list[0]?.length },
  },
  {
    id: "practice",
    formula: "P₁ = Σ(k − 1)",
    shows: [{ preset: "press" }],
    controls: ["practice"],
    question: { hides: ["scheme-pairs"], within: 0, answer: ({ counts }) => pairs(counts) },
  },
] });

/**
 * @param {Summary["counts"]} counts
 * @returns {number} number of pairs; a hinge of k links counts as k − 1
 */
function pairs({ pairs: all }) {
  return all.reduce((sum, { count }) => sum + count, 0);
}

/**
 * @param {Summary} summary
 * @returns {string | undefined} whether the mobility by count is too low, right or too high compared with the mobility
 * by rank (in the plane for a planar scheme, otherwise in space); undefined if there is no rank
 */
function counted({ planar, plane, space, mobility }) {
  const judged = planar ? plane : space;
  return judged ? COUNTS[1 + Math.sign(mobility - judged.mobility)] : undefined;
}
