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
 * @param {string} number
 * @param {string} unit
 * @returns {string} one after the other, as they are printed, on one line
 */
export function measured(number, unit) {
  return unit === "" || unit.startsWith("°") ? number + unit : `${number}\u00a0${unit}`;
}
