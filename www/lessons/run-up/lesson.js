// Steps of the lesson on motion under load: documents and questions; texts in words.*.json.
import { degrees } from "assur/core/angles.js";

const SHOWN = Object.freeze(["traces", "under_load"]);
const PRESS = Object.freeze({ preset: "press", at: home, overlays: SHOWN });

/** @type {import("assur/lesson/folder.js").Lesson<"linkage">} */
export const LESSON = Object.freeze({ kind: "linkage", steps: [
  {
    id: "reduced",
    formula: "J_r = Σ(m C′² + J φ′²)",
    shows: [PRESS],
    question: { unit: "°", within: 2, answer: ({ steady }) => steady ? degrees(heaviest(steady.diagram)) : undefined },
  },
  {
    id: "energy",
    formula: "E = ½ J_r ω²\ndE/dφ = M_r",
    shows: [PRESS],
    question: { choices: ["falls", "stays", "rises"], answer: () => "falls" },
  },
  {
    id: "work",
    formula: "M_m = A/2π",
    shows: [PRESS],
    question: { unit: "newton_metre", within: 0.5, answer: ({ steady }) => steady?.torque },
  },
  {
    id: "motor",
    formula: "M = M₀(1 − ω/ω₀)",
    shows: [PRESS],
    question: { unit: "rad_per_s", within: 0.2, answer: ({ steady }) => steady?.rate },
  },
  {
    id: "run",
    shows: [PRESS],
    question: { choices: ["constant", "periodic", "grows"], answer: () => "periodic" },
  },
  {
    id: "delta",
    formula: "δ = (ω_max − ω_min)/ω_m",
    shows: [PRESS],
    question: { within: 0.03, answer: ({ steady }) => steady?.given.cycle?.delta },
  },
  {
    id: "wittenbauer",
    formula: "J_f = ab/(δ ω_m²)",
    shows: [PRESS],
    question: { within: 0.1, answer: ({ steady }) => steady?.wittenbauer.flywheel },
  },
  {
    id: "check",
    shows: [{ preset: "flywheel", at: home, overlays: SHOWN }],
    question: { within: 0.002, answer: ({ steady }) => steady?.given.cycle?.delta },
  },
] });

/** @param {{ home: number }} summary */
function home({ home: drawn }) {
  return drawn;
}

/**
 * @param {readonly (readonly [number, number, number])[]} diagram inputs, reduced moments of inertia and energies
 * @returns {number} the input between 0 and π at which the reduced moment of inertia is greatest: the vertex of the parabola through
 * the greatest of the points and its neighbours
 */
function heaviest(diagram) {
  const half = diagram.filter(([input]) => input <= Math.PI);
  const at = half.reduce((most, [, inertia], k) => (inertia > half[most][1] ? k : most), 0);
  const [[from, left], [input, top], [to, right]] = [half[at - 1] ?? half[at], half[at], half[at + 1] ?? half[at]];
  const bend = left - 2 * top + right;
  return bend === 0 ? input : input + ((to - from) / 4) * (left - right) / bend;
}
