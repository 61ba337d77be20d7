// Quantities as lessons name them (`rocker.angle`, `C.x′`, `W`, `rocker.angle:swing`): names and units.
import { called } from "assur/core/names.js";
import { partsOf, readingOf } from "assur/core/quantity.js";
import { calledWhole, isLength, symbol } from "assur/core/symbols.js";
import { measured, unitOfRate } from "assur/core/units.js";

/**
 * @typedef {import("assur/core/words.js").Words} Words
 * @typedef {NonNullable<NonNullable<import("assur/state/state.js").Written["steps"][number]["question"]>["number"]>} Asked
 */

/** Name of the mobility as a quantity. */
export const W = "W";

/**
 * @param {string} quantity
 * @returns {boolean} whether the quantity is an angle, which a lesson gives in degrees
 */
export function isAngle(quantity) {
  return /\.(angle|load_angle|corner|between|transmission|pressure)(:swing|:worst)?$/.test(quantity);
}

/**
 * @param {string} quantity
 * @returns {boolean} whether values that differ by 360° are the same answer
 */
export function isRound(quantity) {
  return quantity.endsWith(".angle");
}

/**
 * @param {Asked | null | undefined} asked
 * @returns {string} unit of an answer that is a number, as far as it is known without the mechanism
 */
export function unitOf(asked) {
  const { quantity, unit } = asked ?? {};
  return unit || (isAngle(quantity ?? "") || quantity === "input" ? "°" : "");
}

/**
 * @param {Asked | null | undefined} asked
 * @param {Readonly<{ coordinate: import("assur/state/coordinate.js").Coordinate | null, state: import("assur/state/state.js").State }> | null} seen the mechanism in the question
 * @param {Words} words words with the unit of the mechanism's lengths
 * @returns {string} unit of an answer, including that of a length or a rate
 */
export function unitIn(asked, seen, words) {
  if (!seen?.coordinate || !asked?.quantity || asked.unit) return unitOf(asked);
  return unitOfQuantity(asked.quantity, seen.coordinate.moves, seen.state.view.axes === "physical", words);
}

/**
 * @param {string} quantity
 * @param {"angle" | "length" | "time"} moves
 * @param {boolean} physical whether derivatives are with respect to time
 * @param {Words} words
 */
function unitOfQuantity(quantity, moves, physical, words) {
  if (quantity === "input") return { angle: "°", length: words.unit, time: words.text("unit.s") }[moves];
  const { name, what, order, property } = read(quantity);
  const kind = isLength(what) ? "length" : isAngle(name) ? "angle" : null;
  if (kind === null || property === "time_ratio") return "";
  if (kind === "angle" && order === 0) return "°";
  const unit = unitOfRate({ kind, order, physical: physical || moves === "time" }, moves, words);
  return unit === "1" ? "" : unit;
}

/**
 * @param {string} quantity
 * @returns parts of the name. `name`: the quantity without strokes and suffix; `of`, `what`: its point or link and its last part; `order`: order of the
 * derivative; `property`: property of the whole motion
 */
function read(quantity) {
  const [reading, property] = quantity.split(":");
  const { quantity: name, order } = readingOf(reading);
  return { name, ...partsOf(name), order, property };
}

/**
 * @param {Asked | null | undefined} asked
 * @returns {readonly string[]} quantities that are withheld while a question asks for a number: the one asked for, except the input, which is never hidden
 */
export function secrets(asked) {
  return asked?.quantity && asked.quantity !== "input" ? [asked.quantity] : [];
}

/**
 * @param {Asked | null | undefined} asked
 * @returns {number} tolerance of an answer; 0 for a mobility, which is a whole number
 */
export function toleranceOf(asked) {
  return asked && asked.quantity !== W ? asked.within : 0;
}

/**
 * @param {string} question
 * @param {number | undefined} within
 * @param {string} unit
 * @param {Words} words
 * @returns {string} the question with the tolerance of its answer before the final punctuation mark
 */
export function withTolerance(question, within, unit, words) {
  if (!within) return question;
  const tolerance = words.text("lesson.within", { value: measured(words.numbers.upTo(within, 6), unit) });
  return question.replace(/[?.!]?$/, (mark) => ` ${tolerance}${mark}`);
}

/**
 * @param {string} quantity
 * @param {Pick<import("assur/state/model.js").AnySnapshot, "summary" | "coordinate" | "state">} of
 * @param {Words} words
 * @returns {string} the quantity's name for the reader
 */
export function quantityName(quantity, { summary, coordinate, state }, words) {
  if (quantity === "input") return coordinate.symbol;
  if (quantity === W) return W;
  const { name, of, what, order, property } = read(quantity);
  const number = summary.moves !== null && what === "angle" ? summary.numbers[of] : undefined;
  const short = symbol({ name, number }, order, state.view.axes === "physical", words);
  const whose = what.endsWith("angle") ? called(of, words) : calledWhole(of, what, words);
  const said = short.endsWith(whose) ? short : `${short} (${whose})`;
  if (property === undefined) return said;
  // The range is called the swing of an angle and the stroke of a length.
  return words.text(property === "swing" && !isAngle(name) ? "write.whole.stroke" : `write.whole.${property}`, { quantity: said });
}
