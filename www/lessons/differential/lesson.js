// Steps of the lesson on the differential with magnetic couplings: documents and questions; texts in words.*.json.

/** @typedef {import("assur/state/details.js").Summaries["gear-train"]} Summary */

/** Names `ij` of the six ratios U_ij⁽ᵏ⁾ of members i and j, with member k held. */
const RATIOS = Object.freeze(["13", "31", "34", "43", "14", "41"]);

/** @type {import("assur/lesson/folder.js").Lesson<"gear-train">} */
export const LESSON = Object.freeze({ kind: "gear-train", steps: [
  {
    id: "parts",
    formula: "W = 3n − 2P₁ − P₂",
    shows: [{ name: "single", preset: "one_satellite", play: true }, { name: "three", preset: "driven", play: true }],
    question: { hides: ["train-w"], within: 0, answer: ({ mobility: { mobility, passive } }) => mobility + passive },
  },
  {
    id: "sum",
    formula: "ω₃ = (z₁ω₁ + z₄ω₄) / (z₁ + z₄)\nω₂ = ω₃ − (ω₁ − ω₃) z₁/z₂",
    shows: [{ name: "driven", preset: "driven", play: true }, { name: "alike", preset: "alike", play: true }],
    controls: ["drives"],
    readouts: ["train-sun", "train-ring", "train-carrier"],
    question: { hides: ["train-carrier", "carrier.angle′"], within: 0.1, answer: ({ speeds }) => speeds.carrier },
  },
  {
    id: "hold",
    formula: "ω₄ = cω₁: ω₃ = ω₁ (z₁ + cz₄) / (z₁ + z₄)",
    shows: [
      { name: "ring", preset: "ring_held", play: true }, { name: "sun", preset: "sun_held", play: true },
      { name: "carrier", preset: "carrier_held", play: true }, { name: "tied", preset: "tied", play: true },
    ],
    controls: ["drives"],
    readouts: ["train-sun", "train-ring", "train-carrier"],
    question: { hides: ["train-ratios"], within: 0.005, answer: ({ ratios }) => valueOf(ratios, "4/1(3)") },
  },
  {
    id: "superposition",
    relations: ["004.(4)", "004.(5)", "004.(6)", "004.(7)"],
    shows: [{ name: "sun", preset: "ring_held", play: true }, { name: "ring", preset: "ring_alone", play: true }, { name: "both", preset: "driven", play: true }],
    controls: ["wheels"],
    readouts: ["train-sun", "train-ring", "train-carrier"],
    question: { choices: ["falls", "same", "rises"], answer: () => "same" },
  },
  {
    id: "willis",
    formula: "(ω₁ − ω₃) / (ω₄ − ω₃) = −z₄/z₁",
    relations: ["004.omega2"],
    shows: [
      { name: "ground", preset: "driven", play: true }, { name: "carrier", preset: "seen_from_carrier", play: true },
      { name: "sun", preset: "seen_from_sun", play: true }, { name: "ring", preset: "seen_from_ring", play: true },
    ],
    controls: ["observer"],
    readouts: ["sun.angle′", "ring.angle′", "carrier.angle′"],
    question: { hides: ["train-ratios"], within: 0.01, answer: ({ ratios }) => valueOf(ratios, "1/4(3)") },
  },
  {
    id: "ratios",
    relations: ["004.(8)", "004.(9)", "004.(10)"],
    shows: [{ preset: "ring_held", play: true }],
    controls: ["ratios"],
    question: { hides: ["train-largest"], choices: RATIOS, answer: largest },
  },
  {
    id: "gaps",
    formula: "(d₁ + d₂) / 2 < a_w < (d₄ − d₂) / 2\nsin(π/k) > d₂ / (2a_w)",
    relations: ["004.(1)", "004.(2)"],
    shows: [{ name: "mend", preset: "not_to_be_built" }, { name: "contact", preset: "contact" }],
    controls: ["wheels", "conditions"],
    question: { within: 0, answer: pitchesEach },
  },
  {
    id: "teeth",
    formula: "c₁₂ = a_w − (d₁ + d₂)/2 − 2m\nc₂₄ = (d₄ − d₂)/2 − a_w − 2m",
    relations: ["004.open"],
    shows: [{ name: "small", preset: "driven" }, { name: "wide", preset: "wide_gap" }],
    controls: ["wheels"],
    question: { within: 0, answer: leastRingThatClears },
  },
  {
    id: "load",
    formula: "T₁ = T sin z₁Δ\nT₁ : T₄ : T₃ = z₁ : z₄ : −(z₁ + z₄)",
    shows: [{ name: "brief", preset: "overloaded", plot: "load", play: true }, { name: "light", preset: "loaded", plot: "load", play: true }],
    controls: ["load"],
    readouts: ["sun.load_angle", "ring.load_angle"],
    question: { hides: ["train-limit"], within: 0.1, answer: ({ limits }) => limits?.carrier },
  },
  {
    id: "energy",
    formula: "A_d = A_u + A_h + ΔE − A_f\nη = A_u / A_d",
    relations: ["004.field", "004.claim2"],
    shows: [{ preset: "rubbing", plot: "load", play: true }],
    controls: ["load"],
    question: { choices: ["drive", "field", "both"], answer: () => "drive" },
  },
  {
    id: "uses",
    formula: "ω₃ = (z₁ω₁ + z₄ω₄) / (z₁ + z₄)\nω₂ = ω₃ − (ω₁ − ω₃) z₁/z₂",
    shows: [
      { name: "mixer", preset: "mixer", play: true }, { name: "fan", preset: "fan", play: true }, { name: "brushes", preset: "brushes", play: true },
    ],
    controls: ["members"],
    question: { hides: ["train-satellite", "satellite.angle′"], within: 0.1, answer: ({ speeds }) => speeds.satellite },
  },
] });

/**
 * @param {Summary["ratios"]} ratios
 * @param {string} name such as `1/3(4)`: members 1 and 3, with member 4 held
 */
function valueOf(ratios, name) {
  return ratios.find((ratio) => ratio.name === name)?.value;
}

/**
 * @param {Summary} summary
 * @returns {string | undefined} indices `ij` of the largest positive ratio; the paper characterises a
 * differential by this ratio
 */
function largest({ ratios }) {
  const found = ratios.find((ratio) => ratio.largest);
  return found && `${found.of}${found.to}`;
}

/**
 * @param {Summary} summary
 * @returns {number | undefined} (z₁ + z₄)/k of a train with k satellites; infinity, which no answer matches, if the train cannot be assembled
 */
function pitchesEach({ builds, conditions }) {
  const assembly = conditions.find(({ kind }) => kind === "assembly");
  return builds && assembly ? assembly.left / assembly.right : Infinity;
}

/**
 * Largest z₄ − z₁ − 2z₂ at which teeth of sun 1, satellite 2 and ring 4 touch. With module m, the satellite's pitch
 * circle is m(z₄ − z₁ − 2z₂)/4 away from the pitch circles of sun and ring. Teeth of addendum m clear each other only
 * if this gap is more than 2m.
 */
const TEETH_OF_GAPS = 8;

/**
 * @param {Summary} summary
 * @returns {number | undefined} the least z₄ at which the tips of the teeth clear each other
 */
function leastRingThatClears({ conditions }) {
  const room = conditions.find(({ kind }) => kind === "room");
  return room && room.right + TEETH_OF_GAPS + 1;
}
