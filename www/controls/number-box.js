// A text field for a number: takes a decimal comma, and keeps typed text while it is no valid number.
import { make } from "assur/core/dom.js";
import { parseNumber } from "assur/core/numbers.js";

/**
 * @typedef {Readonly<{ brief: string, full: string }>} Written
 * A value in its brief form, and with all its digits for editing.
 */

/**
 * @param {Parameters<typeof make>[1]} attributes
 * @returns {HTMLInputElement} field for a number
 */
export function numberField(attributes) {
  return make("input", { class: "control number", type: "text", inputmode: "decimal", autocomplete: "off", spellcheck: "false", ...attributes });
}

export class NumberBox {
  #input;
  #field;
  #drafts;
  /** Whether a person typed the text, which has not been rewritten since. */
  #typed = false;
  /** @type {number | null} value that resulted from the typed text */
  #meant = null;
  /** @type {Written} */
  #written = { brief: "", full: "" };

  /**
   * @param {HTMLInputElement} input
   * @param {string} field
   * @param {import("assur/state/drafts.js").Drafts} drafts
   * @param {(value: number) => number | void} set takes the number and returns the value in the state if it differs
   */
  constructor(input, field, drafts, set) {
    this.#input = input;
    this.#field = field;
    this.#drafts = drafts;
    input.addEventListener("input", () => {
      this.#typed = true;
      const value = parseNumber(input.value);
      if (value === null) drafts.keep(field);
      else drafts.drop(field);
      this.#meant = value === null ? null : (set(value) ?? value);
    });
    for (const end of ["change", "blur"]) {
      input.addEventListener(end, () => {
        if (!drafts.has(field)) this.#writeOut();
      });
    }
    input.addEventListener("keydown", (event) => {
      if (event.key !== "Escape") return;
      drafts.drop(field);
      this.#writeOut();
    });
    input.addEventListener("focus", () => {
      if (!drafts.has(field)) this.#writeOut();
      input.select();
    });
  }

  /**
   * @param {number} value
   * @param {Written} written
   * @param {boolean} invalid
   */
  show(value, written, invalid) {
    this.#written = written;
    const input = this.#input;
    const focused = document.activeElement === input;
    const being = focused && this.#typed && this.#meant === value;
    if (!this.#drafts.has(this.#field) && !being) this.#writeOut();
    const wrong = invalid || this.#drafts.has(this.#field);
    if (wrong !== (input.getAttribute("aria-invalid") === "true")) {
      input.setAttribute("aria-invalid", String(wrong));
      if (wrong) input.setAttribute("aria-describedby", "problem");
      else input.removeAttribute("aria-describedby");
    }
  }

  /** @param {string} text of a refused value, to be shown all the same */
  hold(text) {
    this.#input.value = text;
  }

  /** Whether the field has the focus and nothing has been typed yet. */
  get busy() {
    return document.activeElement === this.#input && !this.#typed;
  }

  #writeOut() {
    this.#typed = false;
    const text = document.activeElement === this.#input ? this.#written.full : this.#written.brief;
    if (this.#input.value !== text) this.#input.value = text;
  }
}
