// A control for a field of the document that has only a few possible values.
import { make } from "assur/core/dom.js";

export class Choice {
  #select;

  /**
   * @param {string} field
   * @param {readonly string[]} values
   * @param {(value: string) => string} key gives the key of a value's name
   * @param {(value: string) => void} choose
   * @param {string} [label] key of the field's name
   */
  constructor(field, values, key, choose, label = `field.${field}`) {
    this.#select = make("select", { id: `field-${field}`, class: "control", "data-t-label": label },
      values.map((value) => make("option", { value, "data-t": key(value) })));
    this.#select.addEventListener("change", () => choose(this.#select.value));
    this.element = make("label", { class: "row train-choice", "data-field": field }, [make("span", { class: "name", "data-t": label }), this.#select]);
  }

  /** @param {string} value */
  show(value) {
    if (this.#select.value !== value) this.#select.value = value;
  }
}
