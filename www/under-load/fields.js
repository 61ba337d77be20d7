// Motor, initial rate and flywheel of the document, as fields.
import { NumberBox, numberField } from "assur/controls/number-box.js";
import { sentence } from "assur/controls/problems.js";
import { make, write } from "assur/core/dom.js";
import { html, render } from "assur/core/html.js";
import { parseNumber } from "assur/core/numbers.js";
import { edited } from "assur/state/state.js";

/**
 * @typedef {import("assur/core/problem.js").Problem} Problem
 * @typedef {import("assur/core/words.js").Words} Words
 * @typedef {import("assur/state/state.js").LinkageDocument} LinkageDocument
 * @typedef {NonNullable<LinkageDocument["motor"]>} Motor
 * @typedef {Exclude<keyof Motor, "table">} Part number of a motor
 * @typedef {"torque" | "rate" | "inertia" | "none"} Unit
 */

/** Motors, each with the numbers that it has when it is chosen. */
const MOTORS = Object.freeze(/** @type {const} */ ({
  none: null,
  constant: { torque: 10 },
  linear: { stall: 20, no_load: 20 },
  kloss: { pull_out: 20, slip: 0.2, synchronous: 20 },
  table: { table: [[0, 20], [20, 0]] },
}));
const SORTS = Object.freeze(/** @type {const} */ (["none", "constant", "linear", "kloss", "table"]));

/** @type {readonly (readonly [Part, Unit, string])[]} numbers of motors with their units and the keys of their names */
const PARTS = Object.freeze(/** @type {const} */ ([
  ["torque", "torque", "field.motor.torque"],
  ["stall", "torque", "field.motor.stall"],
  ["no_load", "rate", "field.motor.no_load"],
  ["pull_out", "torque", "field.motor.pull_out"],
  ["slip", "none", "field.motor.slip"],
  ["synchronous", "rate", "field.motor.synchronous"],
]));

const TABLE = "motor.table";

/**
 * @param {Motor | null | undefined} motor
 * @returns {keyof typeof MOTORS}
 */
function sortOf(motor) {
  if (!motor) return "none";
  return SORTS.find((sort) => Object.keys(MOTORS[sort] ?? {}).some((name) => motor[/** @type {keyof Motor} */ (name)] != null)) ?? "none";
}

/**
 * @param {string} text pairs of numbers, with semicolons between the pairs
 * @returns {[number, number][] | null}
 */
export function pairsOf(text) {
  const rows = text.split(/[;\n]/).map((row) => row.trim()).filter((row) => row !== "");
  const pairs = rows.map((row) => row.split(/\s+/).map((one) => parseNumber(one)));
  const sound = pairs.length > 0 && pairs.every((pair) => pair.length === 2 && !pair.includes(null));
  return sound ? /** @type {[number, number][]} */ (pairs) : null;
}

export class Fields {
  #page;
  #sort = make("select", { id: "motor-sort", class: "control" });
  /** @type {{ element: HTMLElement, unit: HTMLElement, why: HTMLElement, box: NumberBox, field: string, sort: Unit, value: (document: LinkageDocument) => number | null | undefined }[]} */
  #rows;
  #table;
  #tableRow;
  #lang = "";

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    this.#page = page;
    const motor = (/** @type {Part} */ part) => (/** @type {number} */ value) => this.#set(({ motor: now }) => ({ motor: { ...now, [part]: value } }));
    this.#rows = PARTS.map(([part, unit, key]) => this.#row(`motor.${part}`, key, unit, motor(part), (document) => document.motor?.[part]));
    this.#rows.push(this.#row("initial_rate", "field.initial_rate", "rate", (value) => this.#set(() => ({ initial_rate: value === 0 ? undefined : value })), (document) => document.initial_rate ?? 0));
    this.#rows.push(this.#row("flywheel", "field.flywheel", "inertia", (value) => this.#set(() => ({ flywheel: value === 0 ? undefined : value })), (document) => document.flywheel ?? 0));
    this.#sort.addEventListener("change", () => this.#choose(/** @type {keyof typeof MOTORS} */ (this.#sort.value)));
    this.#table = make("input", { id: "field-motor.table", class: "control long", type: "text", autocomplete: "off", spellcheck: "false", "data-t-label": "field.motor.table" });
    this.#table.addEventListener("input", () => {
      const table = pairsOf(this.#table.value);
      if (!table) page.drafts.keep(TABLE);
      else {
        page.drafts.drop(TABLE);
        this.#set(() => ({ motor: { table } }));
      }
    });
    this.#tableRow = make("div", { class: "load-field" }, [make("label", { for: this.#table.id, "data-t": "field.motor.table" }), this.#table]);
    const sort = make("div", { class: "load-field" }, [make("label", { for: this.#sort.id, "data-t": "under_load.motor" }), this.#sort]);
    this.element = make("div", { class: "load-fields" }, [sort, ...this.#rows.slice(0, PARTS.length).map(({ element }) => element), this.#tableRow, ...this.#rows.slice(PARTS.length).map(({ element }) => element)]);
  }

  /**
   * @param {LinkageDocument} document
   * @param {readonly Problem[]} problems of the engine with the forces
   * @param {boolean} turns whether a crank is driven
   * @param {Words} words
   */
  render(document, problems, turns, words) {
    if (this.#lang !== words.lang) {
      this.#lang = words.lang;
      render(SORTS.map((sort) => html`<option value=${sort}>${words.text(`under_load.motor.${sort}`)}</option>`), this.#sort);
    }
    const { motor } = document;
    const sort = sortOf(motor);
    if (this.#sort.value !== sort) this.#sort.value = sort;
    for (const { element, unit, why, box, field, sort: of, value: read } of this.#rows) {
      const value = read(document);
      element.hidden = value == null || (field === "flywheel" && !turns && value === 0);
      if (value == null) continue;
      const own = problems.filter(({ path, code }) => path === field.split(".")[0] || (field === "flywheel" && code === "flywheel_no_crank"));
      box.show(value, { brief: words.numbers.brief(value), full: words.numbers.exact(value) }, own.length > 0);
      write(unit, unitOf(of, turns, words));
      write(why, own.map((problem) => sentence(problem, words, document)).join(" "));
    }
    this.#tableRow.hidden = sort !== "table";
    const written = (motor?.table ?? []).map((pair) => pair.map((one) => words.numbers.exact(one)).join(" ")).join("; ");
    const bad = this.#page.drafts.has(TABLE);
    if (globalThis.document.activeElement !== this.#table && !bad) this.#table.value = written;
    this.#table.setAttribute("aria-invalid", String(bad || (sort === "table" && problems.some(({ path }) => path === "motor"))));
  }

  /**
   * @param {string} field
   * @param {string} key
   * @param {Unit} sort
   * @param {(value: number) => void} set
   * @param {(document: LinkageDocument) => number | null | undefined} value
   */
  #row(field, key, sort, set, value) {
    const input = numberField({ id: `field-${field}`, "data-t-label": key });
    const unit = make("span", { class: "load-unit" });
    const why = make("p", { class: "load-why", role: "alert" });
    const element = make("div", { class: "load-field", "data-field": field }, [make("label", { for: input.id, "data-t": key }), make("span", {}, [input, " ", unit]), why]);
    return { element, unit, why, field, sort, value, box: new NumberBox(input, field, this.#page.drafts, set) };
  }

  /** @param {keyof typeof MOTORS} sort */
  #choose(sort) {
    this.#page.drafts.dropAll([...PARTS.map(([part]) => `motor.${part}`), TABLE]);
    const motor = MOTORS[sort];
    this.#set(() => ({ motor: motor ? /** @type {Motor} */ (motor) : undefined }));
  }

  /** @param {(document: LinkageDocument) => Partial<LinkageDocument>} change */
  #set(change) {
    this.#page.store.update((state) => edited(state, "linkage", change));
  }
}

/**
 * @param {Unit} sort
 * @param {boolean} turns
 * @param {Words} words
 * @returns {string} unit; without a unit of lengths there are no units but those of angle and time
 */
export function unitOf(sort, turns, words) {
  if (sort === "rate") return turns ? words.text("unit.rad_per_s") : `${words.unit}/${words.text("unit.s")}`;
  if (sort === "none" || words.unit === "") return "";
  if (sort === "inertia") return words.text("under_load.unit.inertia");
  return words.text(turns ? "unit.newton_metre" : "unit.newton");
}
