// Comparison with the values shown last, so that a view with unchanged values is not written again.

export class Seen {
  /** @type {readonly unknown[]} */
  #parts = [];

  /**
   * @param {...unknown} parts all values that the view depends on
   * @returns {boolean} whether all values equal those of the last call
   */
  same(...parts) {
    const before = this.#parts;
    this.#parts = parts;
    return parts.length === before.length && parts.every((part, i) => part === before[i]);
  }
}
