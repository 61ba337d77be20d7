// What was shown last, so that nothing is written anew that is the same.

export class Seen {
  /** @type {readonly unknown[]} */
  #parts = [];

  /**
   * @param {...unknown} parts all that what is shown is made of
   * @returns {boolean} whether they are those of the last time; they are kept for the next
   */
  same(...parts) {
    const before = this.#parts;
    this.#parts = parts;
    return parts.length === before.length && parts.every((part, i) => part === before[i]);
  }
}
