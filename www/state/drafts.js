// What stands in number fields and is no number yet: kept as typed, until it becomes one.

/** The field of where the driver is, whatever it is counted in. */
export const INPUT = "input";

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

  /** @param {readonly string[]} fields; a list is dropped with all that is in it */
  dropAll(fields) {
    for (const field of this.fields()) {
      if (fields.includes(field) || fields.includes(partOf(field))) this.drop(field);
    }
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

/**
 * @param {string} field such as `wheels[2].z`
 * @returns {string} the part of the document that holds it: `wheels`
 */
export function partOf(field) {
  return field.split("[", 1)[0];
}
