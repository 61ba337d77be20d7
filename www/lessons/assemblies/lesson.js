// Steps of the lesson on the assemblies of a linkage: documents and questions; texts in words.*.json.
import { degrees } from "assur/core/angles.js";

/** @typedef {import("assur/state/details.js").MotionSummary} Summary */

/** View of every step: traces, the section with a picture of each assembly, and the other assemblies drawn. */
const OVERLAYS = Object.freeze(["traces", "all_assemblies", "others"]);

/** Control of every step: the section with the pictures and the map of the assemblies. */
const SECTION = Object.freeze(["all_assemblies"]);

/**
 * Answer for a group of revolute pairs, by class and number of links: its assemblies, real and complex. Fourteen holds
 * for the group of `class4-dwell`; other groups of Class IV with six links may have more.
 */
const COMPLEX = Object.freeze({ "II 2": "two", "III 4": "six", "IV 6": "fourteen" });

/** @type {import("assur/lesson/folder.js").Lesson<"linkage">} */
export const LESSON = Object.freeze({ kind: "linkage", steps: [
  {
    id: "dyad",
    formula: "(x_C − x_B)² + (y_C − y_B)² = l²_BC\n(x_C − x_D)² + (y_C − y_D)² = l²_DC",
    shows: [{ preset: "crank-rocker", at: home, overlays: OVERLAYS }],
    controls: SECTION,
    question: { integer: true, within: 0, answer: real },
  },
  {
    id: "triad",
    formula: "2 · 6 − 2 · 3 = 6",
    shows: [{ name: "triad", preset: "class3-platform", at: home, overlays: OVERLAYS }, { name: "dyad", preset: "crank-rocker", at: home, overlays: OVERLAYS }],
    controls: SECTION,
    readouts: ["formula"],
    question: { choices: ["two", "six", "fourteen"], answer: complex },
  },
  {
    id: "ten",
    formula: "14 = r + 2c",
    shows: [{ name: "arc", preset: "ten", at: home, overlays: OVERLAYS }, { name: "zero", preset: "class4-dwell", at: home, overlays: OVERLAYS }],
    controls: SECTION,
    question: { integer: true, within: 0, answer: real },
  },
  {
    id: "fold",
    formula: "Φ(q, φ₁) = 0\nJ = ∂Φ/∂q, det J = 0",
    shows: [{ preset: "short", at: home, play: true, overlays: OVERLAYS }],
    controls: SECTION,
    readouts: ["linkage-range", "linkage-dead"],
    question: { unit: "°", within: 0.05, answer: range },
  },
  {
    id: "circuits",
    formula: "l_min + l_max ≤ p + q",
    shows: [
      { name: "rockers", preset: "triple-rocker", at: home, play: true, overlays: OVERLAYS },
      { name: "crank", preset: "crank-rocker", at: home, play: true, overlays: OVERLAYS },
      { name: "by_rocker", preset: "double-rocker", drive: "left rocker", at: home, play: true, overlays: OVERLAYS },
    ],
    controls: SECTION,
    readouts: ["linkage-grashof", "linkage-dead"],
    question: { choices: ["joined", "whole", "pairs"], answer: circuits },
  },
  {
    id: "reach",
    formula: "12 = 4 + 2 · 4",
    shows: [{ name: "dwell", preset: "ten", at: home, overlays: OVERLAYS }, { name: "near", preset: "near", at: home, overlays: OVERLAYS }],
    controls: SECTION,
    question: { choices: ["none", "some"], answer: reached },
  },
] });

/**
 * @param {Summary} summary
 * @returns {number} the drawn input
 */
function home({ home: drawn }) {
  return drawn;
}

/**
 * @param {Summary} summary
 * @returns {number | undefined} number of real assemblies at the drawn input
 */
function real({ assembled }) {
  return assembled?.count;
}

/**
 * @param {Summary} summary
 * @returns {string | undefined} number of real and complex assemblies of the group; undefined if there are several
 */
function complex({ class: highest, counts: { links }, groups }) {
  const group = groups.length === 2 ? `${highest} ${links - 1}` : "";
  return /** @type {Record<string, string | undefined>} */ (COMPLEX)[group];
}

/**
 * @param {Summary} summary
 * @returns {number | undefined} range of the driver in degrees; undefined if the driver turns fully or has several ranges
 */
function range({ cycle: { full, arcs } }) {
  const [[from, to]] = arcs;
  return full || arcs.length > 1 ? undefined : degrees(to - from);
}

/**
 * Returns the choice that describes the circuits of a four-bar. The lengths of its links determine the number of
 * circuits; the choice of its driver determines the number of branches on a circuit.
 * @param {Summary} summary
 */
function circuits({ four_bars: [bar, ...more], cycle }) {
  if (!bar || more.length > 0 || bar.grashof === "change_point") return undefined;
  if (bar.grashof === "triple_rocker") return "joined";
  return cycle.full ? "whole" : "pairs";
}

/**
 * @param {Summary} summary
 * @returns {string} whether other branches can be reached; without dead points and change points the branch is a whole circuit
 */
function reached({ dead_points: dead, change_points: changes }) {
  return dead.length + changes.length === 0 ? "none" : "some";
}
