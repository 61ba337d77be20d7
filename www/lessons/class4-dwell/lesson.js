// The steps of the lesson on the Class IV mechanism with dwell: what each shows, and what is asked of the mechanism as it then is.
// Its words are in words.*.json of this folder, under the step's id.
import { degrees } from "assur/core/angles.js";

/** @typedef {import("assur/engine.js").MotionSummary} Summary */

const PRESET = "class4-dwell";
/** A length of FK, the regulator, that makes the dwell clearly shorter. */
const REGULATED = 4.112;

const CLASSES = Object.freeze({ II: "ii", III: "iii", IV: "iv" });

/** @type {import("assur/lesson/folder.js").Lesson<"linkage">} */
export const LESSON = Object.freeze({ kind: "linkage", steps: [
  {
    id: "structure",
    formula: "W = 3n − 2P₁",
    shows: [{ preset: PRESET, play: true, overlays: ["traces", "groups"] }],
    question: { whole: true, within: 0, answer: ({ counts }) => counts.lower, places: ({ counts: { links, mobility } }) => ({ links, mobility }) },
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
    shows: [{ preset: PRESET, drive: "CD", at: ({ home }) => home, overlays: ["traces", "groups"], plot: "AB.angle" }],
    readouts: ["formula"],
    question: { hides: ["class"], choices: ["ii", "iii", "iv"], answer: classOf },
  },
  {
    id: "dwell",
    formula: "max ψ − min ψ ≤ δ",
    shows: [{ preset: PRESET, play: true }],
    controls: ["band"],
    readouts: ["course-arc", "course-residual"],
    question: { unit: "°", within: 0.5, answer: dwell },
  },
  {
    id: "regulator",
    formula: (numbers) => `FK = ${numbers.exact(REGULATED)}`,
    shows: [{ preset: PRESET, set: { "FK.length": REGULATED }, play: true }],
    controls: ["FK.length", "H.x", "H.y", "D.x", "D.y"],
    readouts: ["course-arc", "course-stroke"],
    question: { unit: "°", within: 0.5, answer: dwell },
  },
  {
    id: "equations",
    formula: "(x_P − x_Q)² + (y_P − y_Q)² = l²_PQ\nx_PQ x′_PQ + y_PQ y′_PQ = 0\nx_PQ x″_PQ + y_PQ y″_PQ = −x′²_PQ − y′²_PQ",
    shows: [{ preset: PRESET, at: () => Math.PI / 3 }],
    errata: true,
    equations: true,
    // Of hinges there are as many equations as coordinates of moving points, less the mobility.
    question: {
      whole: true, within: 0, answer: ({ equations }) => equations.length,
      places: ({ equations, counts: { mobility } }) => ({ coordinates: equations.length + mobility, mobility }),
    },
  },
  {
    id: "derivatives",
    formula: "Φ(q, φ₁) = 0\nJ q′ = −∂Φ/∂φ₁",
    shows: [{ preset: PRESET, at: () => Math.PI / 3, overlays: ["traces", "vectors"] }],
    errata: true,
    readouts: ["CD.angle", "CD.angle′"],
    question: { hides: ["course-stroke", "linkage-swing"], unit: "°", within: 0.05, answer: stroke },
  },
] });

/** @param {Summary} summary */
function classOf({ class: highest }) {
  return /** @type {Record<string, string | undefined>} */ (CLASSES)[highest];
}

/**
 * @param {Summary} summary
 * @returns {number | undefined} how much of the crank's turn the dwell takes, degrees
 */
function dwell({ profile }) {
  return profile?.dwell ? degrees(profile.dwell.arc[1] - profile.dwell.arc[0]) : undefined;
}

/**
 * @param {Summary} summary
 * @returns {number | undefined} degrees
 */
function stroke({ profile }) {
  return profile && profile.stroke !== null ? degrees(profile.stroke) : undefined;
}
