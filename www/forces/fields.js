// Fields of the fold with masses and loads: rows for numbers, lists of choices, buttons. Each number writes itself again from the document.
import { NumberRow } from "assur/controls/number-row.js";
import { make } from "assur/core/dom.js";

/**
 * @typedef {import("assur/core/words.js").Words} Words
 * @typedef {readonly (readonly [value: string, text: string])[]} Options
 */

/** Units with words of their own; that of a moment of inertia and of a centre of mass depends on the unit of lengths. */
const UNITS = Object.freeze(/** @type {const} */ (["kg", "watt", "free_fall", "density", "stiffness", "torsion", "damping", "torsion_damping", "drag", "drag_square", "angular_drag", "angular_drag_square"]));

/** @typedef {typeof UNITS[number] | "newton" | "newton_metre" | "length" | "area" | "inertia" | "degree" | "none"} Unit */

/**
 * @param {Unit} unit
 * @param {Words} words
 * @returns {string} the unit; empty in a document without a unit of lengths, except for angles
 */
export function unitText(unit, words) {
  if (unit === "degree") return "°";
  if (unit === "none" || words.unit === "") return "";
  if (unit === "length") return words.unit;
  if (unit === "area") return `${words.unit}²`;
  if (unit === "inertia") return `${words.text("forces.unit.kg")}·${words.unit}²`;
  if (unit === "newton" || unit === "newton_metre") return words.text(`unit.${unit}`);
  return words.text(`forces.unit.${unit}`);
}

export class Fields {
  #page;
  #words;
  /** @type {((wrong: ReadonlySet<string>) => void)[]} functions that write the numbers and choices again */
  #shows = [];

  /**
   * @param {import("assur/app/page.js").Page} page
   * @param {Words} words
   */
  constructor(page, words) {
    this.#page = page;
    this.#words = words;
  }

  /** @param {ReadonlySet<string>} wrong fields at fault */
  show(wrong) {
    for (const show of this.#shows) show(wrong);
  }

  /**
   * @param {string} field of the document
   * @param {{ symbol: string, unit: Unit, n?: string }} kind `n`: name of the part that has the number. The keys of the
   * words are the field without its index
   * @param {() => number} value
   * @param {(value: number) => number | void} set
   * @returns {HTMLElement} the row of a number
   */
  number(field, { symbol, unit, n = "" }, value, set) {
    const text = unitText(unit, this.#words);
    const id = field.replace(/\W+/g, "-");
    const row = new NumberRow({ field, id, key: field.replace(/\[\d+\]/, ""), symbol, n, name: text ? `, ${text}` : "", role: "ink" }, this.#page.drafts, set);
    this.#words.fill(row.element);
    this.#shows.push((wrong) => row.show(value(), this.#words, wrong.has(field)));
    return row.element;
  }

  /**
   * @param {string} id
   * @param {string} key of its name
   * @param {Options} options
   * @param {() => string} value
   * @param {(value: string) => void} set
   * @param {Readonly<Record<string, string>>} [values] of its name
   * @returns {HTMLElement} a list of choices with its name
   */
  choice(id, key, options, value, set, values = {}) {
    const select = make("select", { id, class: "control" }, options.map(([value, text]) => make("option", { value }, [text])));
    select.addEventListener("change", () => set(select.value));
    this.#shows.push(() => {
      select.value = value();
    });
    return make("label", { class: "units" }, [make("span", {}, [this.#words.text(key, values)]), select]);
  }

  /**
   * @param {string} id
   * @param {string} key of its name
   * @param {() => boolean} value
   * @param {(value: boolean) => void} set
   * @returns {HTMLElement} a switch with its name
   */
  check(id, key, value, set) {
    const input = make("input", { id, type: "checkbox" });
    input.addEventListener("change", () => set(input.checked));
    this.#shows.push(() => {
      input.checked = value();
    });
    return make("label", { class: "check" }, [input, " ", make("span", {}, [this.#words.text(key)])]);
  }

  /**
   * @param {string} id
   * @param {string} key of its name
   * @param {() => void} act
   * @param {Readonly<Record<string, string>>} [values] of the name
   * @returns {HTMLElement}
   */
  button(id, key, act, values = {}) {
    return make("button", { id, type: "button", class: "control", onclick: act }, [this.#words.text(key, values)]);
  }
}

/**
 * Replaces the content of an element, and gives the focus back to the element that had it.
 * @param {HTMLElement} container
 * @param {readonly Node[]} content
 */
export function replaced(container, content) {
  const focused = container.contains(document.activeElement) ? (document.activeElement?.id ?? "") : "";
  const open = new Set([...container.querySelectorAll("details[open]")].map(({ id }) => id));
  container.replaceChildren(...content);
  for (const details of container.querySelectorAll("details")) if (open.has(details.id)) details.open = true;
  if (focused) document.getElementById(focused)?.focus();
}
