// Steps of the lesson on synthesis from given positions: documents and questions; texts in words.*.json.
import { degrees } from "assur/core/angles.js";

/** @typedef {import("assur/types/web.js").SynthesisSummary} Summary */

/** Choices for the shortest link, in the order of the lengths l₁, l₂, l₃, l₀. */
const LINKS = Object.freeze(["coupler", "output", "input", "frame"]);

/** Example of the paper. `frame`: l₀. `positions`: φ₂ and φ₃ of each position, in degrees. */
const EXAMPLE = Object.freeze({ frame: 10.4, positions: [[240, 45], [253, 60]] });

/** Difference below which numbers count as equal. */
const SAME = 1e-9;

/** @type {import("assur/lesson/folder.js").Lesson<"synthesis">} */
export const LESSON = Object.freeze({ kind: "synthesis", steps: [
  {
    id: "directions",
    formula: "l₁e₁ + l₂e₂ + l₃e₃ = l₀e₀",
    shows: [{ preset: "family", at: first }],
    controls: ["positions"],
    question: { unit: "°", round: true, within: 0.5, answer: ({ wanted: [one, other] }) => degrees(other.output - one.output) },
  },
  {
    id: "functional",
    formula: "J = |z₁e₁ + z₂e₂ + z₃e₃ − e₀|²",
    relations: ["000.(3)", "000.lemma", "000.(5)", "000.rank"],
    shows: [{ preset: "printed", at: first }],
    question: { choices: ["no", "single", "pair"], answer: () => "single" },
  },
  {
    id: "one",
    formula: "z₂ = P₂ + Q₂z₁, z₃ = P₃ + Q₃z₁",
    relations: ["000.notation", "000.(16)", "000.(12)"],
    shows: [{ preset: "printed", at: first }],
    question: { choices: ["parallel", "frame", "never"], answer: () => "parallel" },
  },
  {
    id: "ranges",
    formula: "P₂ + Q₂z₁ > 0, P₃ + Q₃z₁ > 0",
    relations: ["000.(21)", "000.(23)"],
    shows: [{ preset: "printed", at: first }],
    controls: ["conditions"],
    question: { hides: ["conditions-truth"], within: 0.02, answer: ({ wanted: [{ interval }] }) => interval?.[1] ?? undefined },
  },
  {
    id: "choose",
    formula: "(14): P₂Q₂ ≤ 0\n(25): P₃Q₃ ≤ 0",
    shows: [{ preset: "choose", at: first }],
    controls: ["positions", "conditions", "trial", "equation"],
    readouts: ["synthesis-gap"],
    question: { unit: "°", round: true, within: 0.5, answer: ({ wanted: [one] }) => degrees(one.input) },
  },
  {
    id: "theorem",
    formula: "P₂ + Q₂z₁ > 0, P₃ + Q₃z₁ > 0",
    relations: ["000.truth"],
    shows: [{ preset: "theorem", at: first }],
    controls: ["conditions"],
    question: { hides: ["conditions-truth"], choices: ["some", "none"], answer: ({ wanted: [{ interval }] }) => (interval ? "some" : "none") },
  },
  {
    id: "direct",
    relations: ["000.(31)", "000.(34)", "000.T5"],
    shows: [{ preset: "direct", at: first }],
    controls: ["conditions"],
    question: { choices: ["sufficient", "necessary", "both"], answer: () => "necessary" },
  },
  {
    id: "family",
    formula: "Δcos φ₂ / z₃ + Δcos φ₃ / z₂ = Δcos(φ₂ − φ₃)",
    shows: [{ name: "example", preset: "family", at: first }, { name: "load", preset: "load", at: first }],
    controls: ["positions", "family"],
    readouts: ["synthesis-grashof", "synthesis-ratio"],
    question: { within: 0.05, answer: grashofFrom },
  },
  {
    id: "printed",
    formula: "ΣJ = Σ|z₁e₁ + z₂e₂ + z₃e₃ − e₀|²",
    shows: [{ preset: "printed", at: first }],
    controls: ["equation", "trial"],
    readouts: ["synthesis-grashof", "synthesis-gap"],
    question: { within: 0.005, answer: ({ wanted: [, { open }] }) => open },
  },
  {
    id: "continuity",
    shows: [{ preset: "continuity", at: first }],
    readouts: ["synthesis-grashof"],
    question: { choices: ["same", "apart"], answer: ({ drawn: { verdict } }) => (verdict ? (verdict.passage === "continuous" ? "same" : "apart") : undefined) },
  },
  {
    id: "three",
    formula: "cos(φ₂ − φ₃) = Z + cos φ₂ / z₃ + cos φ₃ / z₂",
    shows: [{ preset: "three", play: true }],
    controls: ["solutions"],
    readouts: ["synthesis-passage", "synthesis-order"],
    question: { choices: LINKS, answer: shortest },
  },
  {
    id: "many",
    formula: "Σ w (|r| − z₁)² → min\nr = e₀ − z₂e₂ − z₃e₃",
    shows: [{ preset: "many", at: first }],
    controls: ["family", "solutions"],
    readouts: ["synthesis-gap"],
    question: { integer: true, within: 0, answer: ({ solutions, from }) => (from === "found" ? solutions.length : undefined) },
  },
  {
    id: "motion",
    formula: "φ(φ₁), φ′, φ″",
    kind: /** @type {const} */ ("linkage"),
    shows: [{ preset: "sent", play: true }],
    readouts: ["rocker.angle", "rocker.angle′"],
    question: {
      hides: ["linkage-swing"], unit: "°", within: 0.5,
      answer: (/** @type {import("assur/state/details.js").Summaries["linkage"]} */ { outputs: [rocker] }) => {
        const stroke = rocker?.swing[0]?.stroke;
        return stroke === undefined ? undefined : degrees(stroke);
      },
    },
  },
] });

/**
 * @param {Summary} summary
 * @returns {number | undefined} the input angle in the first position
 */
function first({ wanted: [one] }) {
  return one?.input;
}

/**
 * @param {Summary} summary
 * @returns {number | undefined} the least l₂ at which the Grashof type changes in the family of the paper's example; undefined for any
 * other document
 */
function grashofFrom({ family, wanted, frame }) {
  const near = (/** @type {number} */ one, /** @type {number} */ other) => Math.abs(one - other) < SAME;
  /** @type {(position: Summary["wanted"][number], k: number) => boolean} */
  const given = ({ output, input }, k) => EXAMPLE.positions[k].every((angle, i) => near(angle, degrees([output, input][i])));
  if (!near(frame, EXAMPLE.frame) || wanted.length !== EXAMPLE.positions.length || !wanted.every(given)) return undefined;
  const changes = family?.changes.map(([, output]) => output) ?? [];
  return changes.length > 0 ? Math.min(...changes) : undefined;
}

/** @param {Summary} summary */
function shortest({ drawn: { lengths }, frame }) {
  const all = [...lengths, frame];
  return LINKS[all.indexOf(Math.min(...all))];
}
