// Symbols of quantities, such as φ₃′, ω₅, ẋ.
import { called } from "assur/core/names.js";
import { STROKES, idOf, partsOf } from "assur/core/quantity.js";

const LETTERS = Object.freeze({
  angle: Object.freeze(["φ", "ω", "ε"]),
  load_angle: Object.freeze(["Δ", "Δ′", "Δ″"]),
  x: Object.freeze(["x", "ẋ", "ẍ"]),
  y: Object.freeze(["y", "ẏ", "ÿ"]),
  transmission: Object.freeze(["μ", "μ\u0307", "μ\u0308"]),
  distance: Object.freeze(["d", "d\u0307", "d\u0308"]),
  corner: Object.freeze(["θ", "θ\u0307", "θ\u0308"]),
  between: Object.freeze(["θ", "θ\u0307", "θ\u0308"]),
  pressure: Object.freeze(["α", "α\u0307", "α\u0308"]),
  reaction: Object.freeze(["R"]),
  reaction_x: Object.freeze(["Rx"]),
  reaction_y: Object.freeze(["Ry"]),
  reaction_moment: Object.freeze(["M"]),
  torque: Object.freeze(["M"]),
  force: Object.freeze(["F"]),
});

/** Last parts of the names of measures, which are quantities that the reader adds. */
export const MEASURES = Object.freeze(["distance", "corner", "between"]);

/** Quantities whose symbol includes their points or links. */
const OF_POINTS = Object.freeze(["transmission", "pressure", "reaction", "reaction_x", "reaction_y", "reaction_moment", ...MEASURES]);

/** Quantities that are lengths; all others are angles. */
const LENGTHS = Object.freeze(["x", "y", "distance", "radius", "centre_x", "centre_y"]);

/**
 * @param {string} what last part of the name of a quantity
 * @returns {boolean} whether it is a length
 */
export function isLength(what) {
  return LENGTHS.includes(what);
}

/** Wheels of a mixer. Their angles are ψ₄, ψ₅, because φ₅ is that of a diagonal (Smelyagin and Prikhodko, (3)). */
const WHEEL = /^wheel\d+$/;

/**
 * @typedef {{ name: string, number?: string | null }} Symbolised a quantity: its name, such as `rocker.angle`, and its link's number
 */

/**
 * Symbol of a quantity or its derivative without the names of its points or links, such as ω₅, ẋ, μ.
 * @param {Symbolised} quantity
 * @param {number} order
 * @param {boolean} physical whether derivatives are with respect to time
 */
export function letterOf({ name, number }, order, physical) {
  const { of, what } = partsOf(name);
  const letters = LETTERS[/** @type {keyof typeof LETTERS} */ (what)];
  // A lesson may still name a quantity of another kind of mechanism.
  if (!letters) return idOf(name, order);
  const index = number ? subscript(number) : "";
  if (physical && order > 0) return letters[order] + index;
  const letter = what === "angle" && number && WHEEL.test(of) ? "ψ" : letters[0];
  return letter + index + STROKES[order];
}

/**
 * Symbol of a quantity or its derivative, such as ω₅, ẋ. For an unnumbered angle, the link's or joint's name follows.
 * @param {Symbolised} quantity
 * @param {number} order
 * @param {boolean} physical whether derivatives are with respect to time
 * @param {import("assur/core/words.js").Words} words
 */
export function symbol({ name, number }, order, physical, words) {
  const { of, what } = partsOf(name);
  const named = OF_POINTS.includes(what) ? ` ${calledWhole(of, what, words)}` : /^(angle|torque|force)$/.test(what) && !number ? ` ${called(of, words)}` : "";
  return letterOf({ name, number }, order, physical) + named;
}

/**
 * @param {string} of names of points, or of links, with hyphens between them
 * @param {string} what last part of the name of the quantity
 * @param {import("assur/core/words.js").Words} words
 * @returns {string} the names in the reader's language, joined
 */
export function calledWhole(of, what, words) {
  return what === "between" ? of.split("-").map((link) => called(link, words)).join("-") : subscript(of);
}

/**
 * @param {string} text
 * @returns {string} the text with its digits as subscripts
 */
export function subscript(text) {
  return text.replace(/\d/g, (digit) => String.fromCharCode(0x2080 + Number(digit)));
}
