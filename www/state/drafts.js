// Problems by field: content that is not a number, or a refused request. A problem is kept until its field is valid.

/** Name of the number field for the input, whatever the unit. */
export const INPUT = "input";

/** @typedef {import("assur/core/problem.js").Problem} Problem */

export class Drafts {
  /** @type {Map<string, readonly Problem[]>} */
  #problems = new Map();
  #changed;

  /** @param {() => void} changed */
  constructor(changed) {
    this.#changed = changed;
  }

  /**
   * @param {string} field
   * @param {readonly Problem[]} [problems] reasons for the refusal
   */
  keep(field, problems = [{ code: "not_a_number", field }]) {
    this.#problems.set(field, problems);
    this.#changed();
  }

  /** @param {string} field */
  drop(field) {
    if (this.#problems.delete(field)) this.#changed();
  }

  /** @param {readonly string[]} fields names of fields; a list is dropped with all its entries */
  dropAll(fields) {
    for (const field of this.fields()) {
      if (fields.includes(field) || fields.includes(partOf(field))) this.drop(field);
    }
  }

  /** @returns {readonly Problem[]} */
  get problems() {
    return [...this.#problems.values()].flat();
  }

  /** @param {string} field */
  has(field) {
    return this.#problems.has(field);
  }

  /** @returns {string[]} */
  fields() {
    return [...this.#problems.keys()];
  }
}

/**
 * @param {string} field such as `wheels[2].z`
 * @returns {string} the part of the document that contains the field: `wheels`
 */
export function partOf(field) {
  return field.split("[", 1)[0];
}
