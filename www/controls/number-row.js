// A number of the document, as a row in the rail: symbol and name, a slider for some numbers, and a number field.
import { NumberBox, numberField } from "assur/controls/number-box.js";
import { make } from "assur/core/dom.js";
import { withSubscripts } from "assur/core/subscripts.js";

/**
 * @typedef {Readonly<{ min: number, max: number, step: number }>} SliderRange
 * @typedef {Readonly<{
 *   field: string,
 *   id?: string,
 *   key?: string,
 *   n?: string,
 *   name?: string,
 *   symbol: string,
 *   role: string,
 *   slider?: SliderRange,
 *   unit?: string,
 *   decimals?: number,
 *   counted?: string,
 * }>} RowKind
 * `field`: name of the number in the document. `id`: part of the elements' ids; `key`: part of the words' keys; both
 * are the field by default. `n`: replaces {n} in the accessible labels of the field and its slider. `name`: replaces
 * {n} in the visible text beside the symbol; `n` by default. `symbol`: letters after a _ become a subscript.
 * `decimals`: greatest number of decimals shown while the number is not edited; by default, six significant digits are
 * shown. `counted`: key of the words for the value of a slider that counts things.
 */

export class NumberRow {
  #kind;
  #drafts;
  #box;
  /** @type {HTMLInputElement | null} */
  #slider = null;
  /** @type {SliderRange | undefined} */
  #range;
  /** @type {(value: number) => string} writes a value in its brief form */
  #brief = String;

  /**
   * @param {RowKind} kind
   * @param {import("assur/state/drafts.js").Drafts} drafts
   * @param {(value: number) => void} set
   */
  constructor(kind, drafts, set) {
    const { field, id = field, key = field, n = "", name: shownName = n, symbol, role, slider } = kind;
    this.#kind = kind;
    this.#drafts = drafts;
    this.field = field;
    const input = numberField({ id: `field-${id}`, "data-t-label": `field.${key}`, "data-n": n });
    this.#box = new NumberBox(input, field, drafts, set);
    const name = make("label", { class: "name", for: input.id }, [
      make("b", {}, withSubscripts(symbol)),
      // A symbol with the name as its subscript needs no words beside it.
      ...(symbol.endsWith(`_${shownName}`) ? [] : [" ", make("span", { "data-t": `name.${key}`, "data-n": shownName })]),
    ]);
    this.element = make("div", { class: "row", "data-field": field, style: `--accent: var(--role-${role})` }, [name, input]);
    this.#range = slider;
    if (slider) {
      this.#slider = makeSlider(id, key, n, slider);
      this.#slider.addEventListener("input", () => {
        const value = Number(this.#slider?.value);
        drafts.drop(field);
        set(value);
        if (drafts.has(field)) this.#box.hold(this.#brief(value));
      });
      this.element.classList.add("with-slider");
      input.before(this.#slider);
    }
  }

  /**
   * Sets another range of the slider, which takes effect when a value is shown next.
   * @param {number} min
   * @param {number} max
   */
  fit(min, max) {
    if (this.#range) this.#range = { ...this.#range, min, max };
  }

  /**
   * @param {number} value
   * @param {import("assur/core/words.js").Words} words
   * @param {boolean} invalid
   */
  show(value, words, invalid) {
    const { numbers } = words;
    const { unit = "", decimals, counted } = this.#kind;
    const range = this.#range;
    this.#brief = (value) => (decimals === undefined ? numbers.brief(value) : numbers.upTo(value, decimals)) + unit;
    this.#box.show(value, { brief: this.#brief(value), full: numbers.exact(value) + unit }, invalid);
    if (!range || !this.#slider) return;
    // After a refused value, the slider stays where the reader put it.
    if (this.#drafts.has(this.field)) return;
    // A value beyond the range of the slider widens the range.
    const [min, max] = [Math.min(range.min, value), Math.max(range.max, value)];
    if (Number(this.#slider.min) !== min) this.#slider.min = String(min);
    if (Number(this.#slider.max) !== max) this.#slider.max = String(max);
    if (Number(this.#slider.value) !== value) this.#slider.value = String(value);
    if (counted) this.#slider.setAttribute("aria-valuetext", words.counted(counted, value));
    this.#slider.style.setProperty("--fill", String((value - min) / (max - min)));
  }
}

/**
 * @param {string} id
 * @param {string} key
 * @param {string} n
 * @param {SliderRange} range
 */
function makeSlider(id, key, n, { min, max, step }) {
  return make("input", {
    id: `slider-${id}`,
    type: "range",
    min: String(min),
    max: String(max),
    step: String(step),
    "data-t-label": `slider.${key}`,
    "data-n": n,
  });
}
