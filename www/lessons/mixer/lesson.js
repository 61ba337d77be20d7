// Steps of the lesson on the mixer: documents and questions; texts in words.*.json.
import { degrees } from "assur/core/angles.js";

/**
 * @typedef {import("assur/types/web.js").OutputSummary["limits"][number]} Limit
 * @typedef {import("assur/state/details.js").Summaries["mixer"]} Summary
 */

/** View for the comparison of two cases, with the crank upright. */
const COMPARED = Object.freeze({ at: () => Math.PI / 2, overlays: ["traces", "transmission"] });

/** @type {import("assur/lesson/folder.js").Lesson<"mixer">} */
export const LESSON = Object.freeze({ kind: "mixer", steps: [
  {
    id: "machine",
    formula: "W = 3n − 2P₁ − P₂",
    shows: [{ preset: "mixer-a", play: true }],
    question: { integer: true, within: 0, answer: ({ counts }) => counts.links, places: ({ counts }) => counts },
  },
  {
    id: "ratio",
    formula: "ψ₅ = u φ₃\n|u| = z₄ / z₅",
    shows: [{ preset: "mixer-a", at: () => Math.PI / 2 }],
    controls: ["z4", "wheels[0].z", "mesh"],
    readouts: ["rocker.angle′", "wheel5.angle′"],
    question: { hides: ["ratio"], within: 0.005, answer: ({ ratios }) => ratios[0] },
  },
  {
    id: "limits",
    formula: "cos ∠DAC =\n(AC² + l₄² − l₃²) / (2AC·l₄)\nAC = l₂ ± l₁",
    shows: [{ preset: "mixer-a", at: (summary) => limits(summary)?.near.input, overlays: ["traces", "loop_vectors"] }],
    readouts: ["rocker.angle", "rocker.angle′"],
    question: { unit: "°", round: true, within: 0.5, answer: (summary) => inDegrees(limits(summary)?.far.input) },
  },
  {
    id: "swing",
    formula: "Δψ₅ = |u| Δφ₃",
    shows: [{ preset: "mixer-c", at: (summary) => limits(summary)?.near.input }],
    controls: ["z4", "wheels[0].z"],
    readouts: ["rocker.angle", "wheel5.angle"],
    question: { hides: ["swing-wheel5"], unit: "°", within: 0.5, answer: ({ outputs: [, { swing }] }) => (swing.length === 1 ? inDegrees(swing[0]?.stroke) : undefined) },
  },
  {
    id: "speed",
    formula: "K = Δφ₁ / (360° − Δφ₁)",
    shows: [{ preset: "mixer-a", play: true, overlays: ["traces", "vectors"] }],
    readouts: ["rocker.angle", "rocker.angle′", "rocker.angle″"],
    question: { hides: ["time-ratio"], unit: "°", within: 0.5, answer: ({ outputs: [{ time_ratio: ratio }] }) => (ratio === null ? undefined : (360 * ratio) / (1 + ratio)) },
  },
  {
    id: "transmission",
    formula: "cos μ =\n|l₂² + l₃² − BD²| / (2l₂l₃)",
    shows: [{ name: "a", preset: "mixer-a", ...COMPARED }, { name: "b", preset: "mixer-b", ...COMPARED }],
    readouts: ["C.transmission", "rocker.angle″"],
    question: { choices: ["in_line", "on_frame", "dead_point"], answer: leastTransmission },
  },
  {
    id: "triangles",
    relations: ["002.(1)", "002.(2)", "002.(4)", "002.(5)", "002.(6)"],
    shows: [{ preset: "mixer-a", at: () => Math.PI / 3, overlays: ["loop_vectors"] }],
    question: { choices: ["diagonal", "coupler", "rocker"], answer: () => "diagonal" },
  },
  {
    id: "contour",
    relations: ["002.(7)", "002.(8)", "002.(9)", "002.(10)", "002.(11)", "002.(13)phi3", "002.(13)phi2"],
    shows: [{ preset: "mixer-a", at: () => Math.PI / 3, overlays: ["loop_vectors"] }],
    question: { choices: ["coupler", "rocker", "crank"], answer: () => "coupler" },
  },
  {
    id: "centres",
    relations: ["002.(14)", "002.(18)", "002.(19)", "002.(20)", "002.(22)", "002.(23)"],
    shows: [{ preset: "mixer-a", at: () => Math.PI / 3, overlays: ["traces", "centres"] }],
    question: { choices: ["to_a", "from_a", "across"], answer: () => "to_a" },
  },
  {
    id: "cases",
    formula: "Δψ₅ = |u| Δφ₃",
    shows: [{ name: "a", preset: "mixer-a", play: true }, { name: "b", preset: "mixer-b", play: true }, { name: "c", preset: "mixer-c", play: true }],
    question: { choices: ["a", "b", "c"], answer: () => "c" },
  },
] });

/**
 * @param {Summary} summary
 * @returns {{ near: Limit, far: Limit } | undefined} `near`: the limit position with the smaller φ₃; `far`: the other one
 */
function limits({ outputs: [{ limits: all }] }) {
  if (all.length !== 2) return undefined;
  const [near, far] = [...all].sort((a, b) => a.value - b.value);
  return { near, far };
}

/**
 * @param {Summary} summary
 * @returns {string | undefined} right choice for the pose of the least transmission angle; undefined if there is a change point
 */
function leastTransmission({ dead_points: dead, change_points: change }) {
  if (change.length > 0) return undefined;
  return dead.length > 0 ? "dead_point" : "on_frame";
}

/** @param {number | undefined} angle */
function inDegrees(angle) {
  return angle === undefined ? undefined : degrees(angle);
}
