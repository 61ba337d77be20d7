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

/** Names of read-outs, and the names of the points, links and quantities in them. */
export class Names {
  /** @param {readonly string[]} all */
  constructor(all) {
    const of = (/** @type {string} */ end) => all.filter((name) => name.endsWith(end)).map((name) => name.slice(0, -end.length));
    this.all = all;
    /** Points whose coordinates can be plotted. */
    this.points = of(".x");
    /** Links whose angles are read. */
    this.links = of(".angle");
    /** Quantities read with their derivatives. */
    this.quantities = of("″");
  }

  /**
   * @param {readonly string[]} all
   * @returns {Names} these names; the same object if nothing changes
   */
  updated(all) {
    return all.join() === this.all.join() ? this : new Names(all);
  }
}
