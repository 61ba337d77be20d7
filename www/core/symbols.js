// How quantities are spelled: φ₃′, ω₅, ẋ.
import { called } from "assur/core/names.js";

const STROKES = Object.freeze(["", "′", "″"]);
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
});

/** What is measured, by the ends of its names. */
export const MEASURES = Object.freeze(["distance", "corner", "between"]);

/** What is said with the points or links that it is of. */
const OF_POINTS = Object.freeze(["transmission", "pressure", ...MEASURES]);

/** What is a length: all else is an angle. */
const LENGTHS = Object.freeze(["x", "y", "distance", "radius", "centre_x", "centre_y"]);

/**
 * @param {string} what a quantity is
 * @returns {boolean} whether it is a length
 */
export function isLength(what) {
  return LENGTHS.includes(what);
}

/** The wheels of a mixer, by their names. Their angles are ψ₄, ψ₅: φ₅ is the diagonal of its contour (Smelyagin and Prikhodko, (3)). */
const WHEEL = /^wheel\d+$/;

/**
 * @param {string} of a link
 * @param {string | null | undefined} number its own
 * @returns {string} the letter of its angle
 */
export function letterOfAngle(of, number) {
  return number && WHEEL.test(of) ? "ψ" : "φ";
}

/**
 * The symbol of a quantity or of its derivative, as φ₃′, ω₅, ẋ; without a number an angle goes by its link or its joint.
 * @param {{ name: string, number?: string | null }} quantity by its name, as `rocker.angle`, `C2.x`
 * @param {number} order
 * @param {boolean} physical whether derivatives are by time
 * @param {import("assur/core/words.js").Words} words
 */
export function symbol({ name, number }, order, physical, words) {
  const dot = name.lastIndexOf(".");
  const [of, what] = [name.slice(0, dot), name.slice(dot + 1)];
  const letters = LETTERS[/** @type {keyof typeof LETTERS} */ (what)];
  // A quantity of another kind of mechanism, as a lesson may still name one.
  if (!letters) return name + STROKES[order];
  const index = number ? subscript(number) : "";
  const letter = what === "angle" ? letterOfAngle(of, number) : letters[0];
  const named = OF_POINTS.includes(what) ? ` ${calledWhole(of, what, words)}` : what === "angle" && !number ? ` ${called(of, words)}` : "";
  return (physical && order > 0 ? letters[order] + index : letter + index + STROKES[order]) + named;
}

/**
 * @param {string} of names of points, or of links, with hyphens between them
 * @param {string} what it is that is of them
 * @param {import("assur/core/words.js").Words} words
 * @returns {string} what they are called together
 */
export function calledWhole(of, what, words) {
  return what === "between" ? of.split("-").map((link) => called(link, words)).join("-") : subscript(of);
}

/**
 * @param {string} name of a quantity
 * @param {number} order of its derivative
 * @returns {string} by what its read-out goes in ids, and as lessons name those that they withhold: `rocker.angle″`, `C.x′`; a name alone could be
 * that of a link and of a point, or of another read-out
 */
export function readoutOf(name, order) {
  return name + STROKES[order];
}

/**
 * @param {string} text
 * @returns {string} the same with its digits written low
 */
export function subscript(text) {
  return text.replace(/\d/g, (digit) => String.fromCharCode(0x2080 + Number(digit)));
}
