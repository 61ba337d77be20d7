// What stands in number fields and is no number yet: kept as typed, until it becomes one.

export class Drafts {
  /** @type {Map<string, string>} */
  #texts = new Map();
  #changed;

  /** @param {() => void} changed */
  constructor(changed) {
    this.#changed = changed;
  }

  /**
   * @param {string} field
   * @param {string} text
   */
  keep(field, text) {
    this.#texts.set(field, text);
    this.#changed();
  }

  /** @param {string} field */
  drop(field) {
    if (this.#texts.delete(field)) this.#changed();
  }

  /** @param {readonly string[]} fields */
  dropAll(fields) {
    for (const field of fields) this.drop(field);
  }

  /** @param {string} field */
  has(field) {
    return this.#texts.has(field);
  }

  /** @returns {string[]} */
  fields() {
    return [...this.#texts.keys()];
  }
}
