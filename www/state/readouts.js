// Read-outs: values at an input, by name.

/** @typedef {Readonly<Record<string, number>>} Readouts values by name, with ′ and ″ for the derivatives that the plots show */

/**
 * @param {readonly string[]} names
 * @param {Float64Array} values in the order of the names; none if derivatives are unbounded
 * @returns {Readouts | null} values by name; null if there are none
 */
export function byName(names, values) {
  if (values.length === 0) return null;
  /** @type {Record<string, number>} */
  const named = {};
  for (let i = 0; i < names.length; i++) named[names[i]] = values[i];
  return named;
}
