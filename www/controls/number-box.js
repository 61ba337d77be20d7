// A text field for a number. The field accepts a decimal comma, and keeps a typed text that is not a valid number.
import { make } from "assur/core/dom.js";
import { parseNumber } from "assur/core/numbers.js";

/**
 * @typedef {Readonly<{ brief: string, full: string }>} Written
 * A written value. `brief`: with few digits, for display. `full`: with all its digits, for editing.
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
  /** Whether the text is as the reader typed it. */
  #typed = false;
  /** @type {number | null} value in the state after the typed text was read */
  #meant = null;
  /** @type {Written} */
  #written = { brief: "", full: "" };

  /**
   * @param {HTMLInputElement} input
   * @param {string} field
   * @param {import("assur/state/drafts.js").Drafts} drafts
   * @param {(value: number) => number | void} set sets the number, and returns the value in the state if the two differ
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

  /** @param {string} text of a refused value, which the field shows nevertheless */
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
