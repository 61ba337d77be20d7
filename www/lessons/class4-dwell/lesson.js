// Steps of the lesson on the Class IV mechanism with dwell: documents and questions; texts in words.*.json.
import { degrees } from "assur/core/angles.js";
import { Differences } from "assur/lessons/class4-dwell/differences.js";
import { System } from "assur/lessons/class4-dwell/system.js";

/** @typedef {import("assur/state/details.js").MotionSummary} Summary */

const PRESET = "class4-dwell";
/** Length of the regulating link FK at which the dwell is clearly shorter than in the preset. */
const REGULATED = 4.112;

const SIXTY = Object.freeze({ at: () => Math.PI / 3 });

const CLASSES = Object.freeze({ II: "ii", III: "iii", IV: "iv" });

/** @type {import("assur/lesson/folder.js").Lesson<"linkage">} */
export const LESSON = Object.freeze({ kind: "linkage", steps: [
  {
    id: "structure",
    formula: "W = 3n − 2P₁",
    shows: [{ preset: PRESET, play: true, overlays: ["traces", "groups"] }],
    question: { integer: true, within: 0, answer: ({ counts }) => counts.lower, places: ({ counts: { links, mobility } }) => ({ links, mobility }) },
  },
  {
    id: "groups",
    formula: "3n − 2P₁ = 0",
    shows: [{ preset: PRESET, at: () => 0, overlays: ["traces", "groups"] }],
    question: { hides: ["class", "formula"], choices: ["ii", "iii", "iv"], answer: classOf },
  },
  {
    id: "driver",
    formula: "3n − 2P₁ = 0",
    shows: [{ preset: PRESET, drive: "CD", at: ({ cycle: { arcs: [[start, end]] } }) => (start + end) / 2, overlays: ["traces", "groups"], plot: "AB.angle" }],
    readouts: ["formula"],
    question: { hides: ["class"], choices: ["ii", "iii", "iv"], answer: classOf },
  },
  {
    id: "dwell",
    formula: "max ψ − min ψ ≤ δ",
    shows: [{ preset: PRESET, play: true }],
    controls: ["band"],
    readouts: ["course-arc", "course-residual"],
    question: { hides: ["course-arc"], unit: "°", within: 2, answer: dwell },
  },
  {
    id: "cyclogram",
    formula: "Δφ_r + Δφ_d + Δφ_b = 360°",
    shows: [{ preset: PRESET, at: () => 0 }],
    lends: ["cyclogram-figure"],
    controls: ["band"],
    readouts: ["course-arc", "course-stroke"],
    question: { unit: "°", within: 0.5, answer: moving },
  },
  {
    id: "regulator",
    formula: (numbers) => `FK = ${numbers.exact(REGULATED)}`,
    shows: [{ preset: PRESET, set: { "FK.length": REGULATED }, play: true }],
    lends: ["cyclogram-figure"],
    controls: ["FK.length", "H.x", "H.y", "D.x", "D.y"],
    readouts: ["course-arc", "course-stroke"],
    question: { hides: ["course-arc"], unit: "°", within: 0.5, answer: dwell },
  },
  {
    id: "equations",
    formula: "(x_P − x_Q)² + (y_P − y_Q)² = l²_PQ\nx_PQ x′_PQ + y_PQ y′_PQ = 0\nx_PQ x″_PQ + y_PQ y″_PQ = −x′²_PQ − y′²_PQ",
    shows: [{ preset: PRESET, ...SIXTY }],
    lends: ["equations"],
    // With revolute pairs only, the number of equations is the number of coordinates of moving points less the mobility.
    question: {
      integer: true, within: 0, answer: ({ equations }) => equations.length,
      places: ({ equations, counts: { mobility } }) => ({ coordinates: equations.length + mobility, mobility }),
    },
  },
  {
    id: "ratios",
    relations: ["003.L", "003.(3)", "003.(4)", "003.(5)"],
    shows: [{ preset: PRESET, ...SIXTY, overlays: ["traces", "loop_vectors"] }],
    question: { choices: ["both", "turn", "stretch"], answer: () => "both" },
  },
  {
    id: "derivatives",
    formula: "J q′ = −∂Φ/∂φ₁",
    relations: ["003.psi1", "003.psi2"],
    shows: [{ preset: PRESET, ...SIXTY, overlays: ["traces", "vectors"] }],
    figure: (engine) => new System(engine),
    readouts: ["CD.angle", "CD.angle′", "CD.angle″"],
    question: { hides: ["course-stroke", "linkage-swing"], unit: "°", within: 0.05, answer: stroke },
  },
  {
    id: "differences",
    formula: "ψ′ ≈ (ψ₊ − ψ₋) / 2h\nψ″ ≈ (ψ₊ − 2ψ + ψ₋) / h²",
    shows: [{ preset: PRESET, ...SIXTY }],
    figure: (engine) => new Differences(engine),
    question: { choices: ["large", "middle", "small"], answer: () => "middle" },
  },
  {
    id: "through_e",
    formula: "Δ = y_EG − x_EG y_EB / x_EB",
    relations: ["003.vE", "003.vF"],
    shows: [{ preset: PRESET, ...SIXTY, overlays: ["traces", "vectors"] }],
    question: { choices: ["in_line", "square", "equal"], answer: () => "in_line" },
  },
  {
    id: "through_c",
    formula: "Λ = y_LC − y_CD x_LC / x_CD",
    relations: ["003.c21", "003.vK"],
    shows: [{ preset: PRESET, ...SIXTY, overlays: ["traces", "vectors"] }],
    question: { choices: ["along", "across", "level"], answer: () => "across" },
  },
  {
    id: "meeting",
    formula: "b₃ x′_G + b₂ y′_G = 0\nb₁ x′_G + b₄ y′_G = b₅\nb₂ = (1 − |f_L|²) y_GH\nb₃ = (1 − |f_L|²) x_GH",
    relations: ["003.b1", "003.b2", "003.b4", "003.b5", "003.det1"],
    shows: [{ preset: PRESET, ...SIXTY }],
    question: { choices: ["hg", "fk", "cd"], answer: () => "fk" },
  },
  {
    id: "squares",
    formula: "x_PQ x″_PQ + y_PQ y″_PQ = −d",
    relations: ["003.d1", "003.d3", "003.d4", "003.d6"],
    shows: [{ preset: PRESET, at: () => Math.PI }],
    question: { choices: ["nothing", "constant", "largest"], answer: () => "nothing" },
  },
  {
    id: "accelerations",
    formula: "b₃ x″_G + b₂ y″_G = d₄ − d₃\nb₁ x″_G + b₄ y″_G = −d₁₈",
    relations: ["003.aE", "003.aF", "003.aC", "003.aK", "003.aL"],
    shows: [{ preset: PRESET, ...SIXTY, overlays: ["traces", "vectors"] }],
    question: { choices: ["bc", "d", "all"], answer: () => "bc" },
  },
  {
    id: "divisors",
    relations: ["003.chain"],
    shows: [{ name: "drawn", preset: PRESET, ...SIXTY }, { name: "equal", preset: "equal", overlays: ["traces", "loop_vectors"] }],
    question: { choices: ["x_eb", "lambda", "ratio"], answer: () => "ratio" },
  },
] });

/** @param {Summary} summary */
function classOf({ class: highest }) {
  return /** @type {Record<string, string | undefined>} */ (CLASSES)[highest];
}

/**
 * @param {Summary} summary
 * @returns {number | undefined} rotation of the crank during the dwell, in degrees
 */
function dwell({ profile }) {
  return profile?.dwell ? degrees(profile.dwell.arc[1] - profile.dwell.arc[0]) : undefined;
}

/**
 * @param {Summary} summary
 * @returns {number | undefined} rotation of the crank during rise and return of the output, in degrees
 */
function moving({ profile }) {
  const moved = profile?.phases.filter(({ kind }) => kind !== "dwell") ?? [];
  return moved.length === 0 ? undefined : degrees(moved.reduce((sum, { arc: [from, to] }) => sum + to - from, 0));
}

/**
 * @param {Summary} summary
 * @returns {number | undefined} stroke of the output in degrees
 */
function stroke({ profile }) {
  return profile && profile.stroke !== null ? degrees(profile.stroke) : undefined;
}
