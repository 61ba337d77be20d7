// What things are measured in, beside their numbers.

/**
 * The unit of a derivative.
 * @param {string} of what is derived, in this unit; nothing where it has none
 * @param {string} by what it is derived by
 * @param {number} order
 */
export function derived(of, by, order) {
  if (by === "") return of;
  const [top, power] = of === by ? ["", order - 1] : [of, order];
  if (power === 0) return "1";
  return `${top || "1"}/${by}${power > 1 ? "²" : ""}`;
}

/**
 * @param {Readonly<{ kind: string, order: number, physical: boolean }>} quantity an angle or a length, or a derivative of one, by time where it is physical
 * @param {"angle" | "length" | "time"} moves by which derivatives are otherwise
 * @param {import("assur/core/words.js").Words} words
 * @returns {string} its unit; an angle in radians
 */
export function unitOfRate({ kind, order, physical }, moves, words) {
  const angle = words.text("unit.rad");
  const input = moves === "angle" ? angle : words.unit;
  const by = physical ? words.text("unit.s") : input;
  const of = kind === "angle" ? angle : words.unit;
  // A turn of a crank is no unit to a length: the analogue of a velocity is a length.
  const bare = order === 0 || (of !== angle && by === angle);
  return bare ? of : derived(of, by, order);
}

/**
 * @param {string} number
 * @param {string} unit
 * @returns {string} one after the other, as they are printed, on one line
 */
export function measured(number, unit) {
  return unit === "" || unit.startsWith("°") ? number + unit : `${number}\u00a0${unit}`;
}
