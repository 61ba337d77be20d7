// Units of quantities, written beside their numbers.

/**
 * The unit of a derivative.
 * @param {string} of unit of the quantity, empty if it has none
 * @param {string} by unit of the variable of differentiation
 * @param {number} order
 */
export function derived(of, by, order) {
  if (by === "") return of;
  const [top, power] = of === by ? ["", order - 1] : [of, order];
  if (power === 0) return "1";
  return `${top || "1"}/${by}${power > 1 ? "²" : ""}`;
}

/**
 * @param {Readonly<{ kind: string, order: number, physical: boolean }>} quantity an angle or a length, or its
 * derivative: with respect to time if `physical`
 * @param {"angle" | "length" | "time"} moves kind of the input, with respect to which all other derivatives are taken
 * @param {import("assur/core/words.js").Words} words
 * @returns {string} unit of the quantity, if angles are in radians
 */
export function unitOfRate({ kind, order, physical }, moves, words) {
  const angle = words.text("unit.rad");
  const input = moves === "angle" ? angle : words.unit;
  const by = physical ? words.text("unit.s") : input;
  const of = kind === "angle" ? angle : words.unit;
  // Derivatives of a length with respect to an angle have the unit of the length: the analogue of velocity is a length.
  const bare = order === 0 || (of !== angle && by === angle);
  return bare ? of : derived(of, by, order);
}

/**
 * @param {string} number
 * @param {string} unit
 * @returns {string} the number with its unit as printed, without a line break between them
 */
export function measured(number, unit) {
  return unit === "" || unit.startsWith("°") ? number + unit : `${number}\u00a0${unit}`;
}
