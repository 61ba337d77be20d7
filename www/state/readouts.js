// Read-outs: their values at an input, and the quantities to which they belong.

/** @typedef {import("assur/types/web.js").ReadoutId} ReadoutId */

/** Quantities and orders of all read-outs of a mechanism, and the points, links and quantities in them. */
export class Names {
  /** @type {ReadonlyMap<string, readonly number[]>} indices of the read-outs of a quantity, by order */
  #places;

  /** @param {readonly ReadoutId[]} all in the order of the engine's values */
  constructor(all) {
    /** @type {Map<string, number[]>} */
    const places = new Map();
    for (const [place, { quantity, order }] of all.entries()) {
      const orders = places.get(quantity) ?? [];
      orders[order] = place;
      places.set(quantity, orders);
    }
    const quantities = [...places.keys()];
    const of = (/** @type {string} */ end) => quantities.filter((name) => name.endsWith(end)).map((name) => name.slice(0, -end.length));
    this.#places = places;
    this.all = all;
    /** Points whose coordinates can be plotted. */
    this.points = of(".x");
    /** Links whose angles are read. */
    this.links = of(".angle");
    /** Quantities that are read with their first and second derivatives. */
    this.quantities = all.filter(({ order }) => order === 2).map(({ quantity }) => quantity);
  }

  /**
   * @param {string} quantity
   * @param {number} order
   * @returns {number | undefined} index of the read-out; undefined if the mechanism has none
   */
  place(quantity, order) {
    return this.#places.get(quantity)?.[order];
  }

  /**
   * @param {readonly ReadoutId[]} all
   * @returns {Names} these names; the same object if nothing changes
   */
  updated(all) {
    const same = all.length === this.all.length && all.every(({ quantity, order }, i) => quantity === this.all[i].quantity && order === this.all[i].order);
    return same ? this : new Names(all);
  }
}

/** Values of all read-outs at an input. */
export class Readouts {
  /**
   * @param {Names} names
   * @param {Float64Array} values in the order of the names
   */
  constructor(names, values) {
    this.names = names;
    this.values = values;
  }

  /**
   * @param {Names} names
   * @param {Float64Array} values empty if derivatives are unbounded
   * @returns {Readouts | null} null if there are no values
   */
  static of(names, values) {
    return values.length > 0 ? new Readouts(names, values) : null;
  }

  /**
   * @param {string} quantity
   * @param {number} [order] of the derivative, with respect to the variable that the plots use
   * @returns {number | undefined} undefined if the mechanism has no such read-out
   */
  value(quantity, order = 0) {
    const place = this.names.place(quantity, order);
    return place === undefined ? undefined : this.values[place];
  }
}
