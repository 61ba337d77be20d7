// Steps of the lesson on forces in the mixer: documents and questions; texts in words.*.json.

/** Angular velocity of the crank in every step, rad/s. */
const OMEGA = 6;
const ALL = Object.freeze(["traces", "forces"]);
const PLAN = Object.freeze(["traces", "forces", "force_plan"]);

/** @type {import("assur/lesson/folder.js").Lesson<"linkage">} */
export const LESSON = Object.freeze({ kind: "linkage", steps: [
  {
    id: "inertia",
    formula: "Φ = −m a\nMΦ = −J ε",
    shows: [{ preset: "inertia", at: home, omega: OMEGA, overlays: [...ALL, "centres"], plot: "C2" }],
    question: { unit: "newton", within: 0.5, answer: ({ forces }) => forces?.applied.find(({ kind, link }) => kind === "inertia" && link === "coupler")?.value },
  },
  {
    id: "order",
    formula: "3n − 2p = 0",
    shows: [{ preset: "inertia", at: home, omega: OMEGA, overlays: [...ALL, "groups"] }],
    readouts: ["formula"],
    question: { choices: ["dyad", "crank", "all"], answer: () => "dyad" },
  },
  {
    id: "tangential",
    formula: "ΣM_C = 0",
    shows: [{ preset: "weights", at: home, omega: OMEGA, overlays: PLAN }],
    question: { unit: "newton", within: 0.3, answer: ({ plan: [first] }) => first?.terms.find(({ known }) => !known)?.size },
  },
  {
    id: "polygon",
    formula: "R₁₂ⁿ + R₁₂ᵗ + G₂ + Φ₂ + G₃ + Φ₃ + R₀₃ᵗ + R₀₃ⁿ = 0",
    shows: [{ preset: "weights", at: home, omega: OMEGA, overlays: PLAN }],
    question: { unit: "newton", within: 0.5, answer: ({ forces }) => forces?.reactions.find(({ pair }) => pair === "B")?.value ?? undefined },
  },
  {
    id: "crank",
    formula: "ΣM_A = 0",
    shows: [{ preset: "weights", at: home, omega: OMEGA, overlays: PLAN }],
    question: { unit: "newton_metre", within: 0.3, answer: ({ forces }) => forces?.drives[0].value ?? undefined },
  },
  {
    id: "lever",
    formula: "T + Σ M_p(F) = 0",
    shows: [{ preset: "weights", at: home, omega: OMEGA, overlays: ["traces", "force_plan"] }],
    question: { choices: ["reactions", "weights", "inertia"], answer: () => "reactions" },
  },
  {
    id: "drag",
    formula: "M₅ = −k ω₅|ω₅|",
    shows: [{ preset: "drag", at: home, omega: OMEGA, overlays: ALL }],
    question: { choices: ["two", "four", "eight"], answer: () => "four" },
  },
  {
    id: "cases",
    formula: "P = T ω₁",
    shows: [
      { name: "a", preset: "loaded", at: home, omega: OMEGA, overlays: ALL },
      { name: "b", preset: "loaded_b", at: home, omega: OMEGA, overlays: ALL },
      { name: "c", preset: "loaded_c", at: home, omega: OMEGA, overlays: ALL },
    ],
    question: { choices: ["a", "b", "c"], answer: () => "c" },
  },
] });

/** @param {{ home: number }} summary */
function home({ home: drawn }) {
  return drawn;
}
