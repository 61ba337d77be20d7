// Comparison with the values shown last: what is unchanged is not written again.

export class Seen {
  /** @type {readonly unknown[]} */
  #parts = [];

  /**
   * @param {...unknown} parts all values that the view depends on
   * @returns {boolean} whether they equal those of the last call; they are kept for the next
   */
  same(...parts) {
    const before = this.#parts;
    this.#parts = parts;
    return parts.length === before.length && parts.every((part, i) => part === before[i]);
  }
}
