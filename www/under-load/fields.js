// Motor, initial rate and flywheel of the document, as fields.
import { NumberBox, numberField } from "assur/controls/number-box.js";
import { sentence } from "assur/controls/problems.js";
import { make, write } from "assur/core/dom.js";
import { called } from "assur/core/names.js";
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
/** Sorts of drives; a driver that keeps its rate has no motor. */
const SORTS = Object.freeze(/** @type {const} */ (["none", "constant", "linear", "kloss", "table", "kept"]));
/** @typedef {typeof SORTS[number]} Sort */
/** @typedef {LinkageDocument["drivers"][number]} Driver */

/** @type {readonly (readonly [Part, Unit, string])[]} numbers of motors with their units and the keys of their names */
const PARTS = Object.freeze(/** @type {const} */ ([
  ["torque", "torque", "field.motor.torque"],
  ["stall", "torque", "field.motor.stall"],
  ["no_load", "rate", "field.motor.no_load"],
  ["pull_out", "torque", "field.motor.pull_out"],
  ["slip", "none", "field.motor.slip"],
  ["synchronous", "rate", "field.motor.synchronous"],
]));

/**
 * @param {Motor | null | undefined} motor
 * @param {Driver | undefined} driver
 * @returns {Sort}
 */
function sortOf(motor, driver) {
  if (!motor) return driver?.keeps_rate ? "kept" : "none";
  const has = (/** @type {Sort} */ sort) => sort !== "kept" && Object.keys(MOTORS[sort] ?? {}).some((name) => motor[/** @type {keyof Motor} */ (name)] != null);
  return SORTS.find(has) ?? "none";
}

/**
 * @param {LinkageDocument} document
 * @param {number} index of a driver
 * @returns {string} name of the driven link
 */
export function drivenLink({ drivers, slides }, index) {
  const driver = drivers[index];
  return driver?.crank ?? slides?.[driver?.slide ?? 0]?.link ?? "";
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

/** Motor and initial rate of a driver; those of the first one, and its flywheel, are fields of the document itself. */
export class Fields {
  #page;
  #driver;
  #prefix;
  #heading = make("h3", {});
  #sort;
  /** @type {{ element: HTMLElement, unit: HTMLElement, why: HTMLElement, box: NumberBox, field: string, sort: Unit, value: (document: LinkageDocument) => number | null | undefined }[]} */
  #rows;
  #table;
  #tableRow;
  /** Language and sorts in which the options are written. */
  #written = "";

  /**
   * @param {import("assur/app/page.js").Page} page
   * @param {number} driver its index
   */
  constructor(page, driver) {
    this.#page = page;
    this.#driver = driver;
    this.#prefix = driver === 0 ? "" : `drivers[${driver}].`;
    this.#sort = make("select", { id: driver === 0 ? "motor-sort" : `motor-sort-${driver}`, class: "control" });
    const motor = (/** @type {Part} */ part) => (/** @type {number} */ value) => this.#set(({ motor: now }) => ({ motor: { ...now, [part]: value } }));
    this.#rows = PARTS.map(([part, unit, key]) => this.#row(`motor.${part}`, key, unit, motor(part), (document) => this.#own(document).motor?.[part]));
    this.#rows.push(this.#row("initial_rate", "field.initial_rate", "rate", (value) => this.#set(() => ({ initial_rate: value === 0 && driver === 0 ? undefined : value })), (document) => this.#initialRate(document)));
    if (driver === 0) this.#rows.push(this.#row("flywheel", "field.flywheel", "inertia", (value) => this.#page.store.update((state) => edited(state, "linkage", () => ({ flywheel: value === 0 ? undefined : value }))), (document) => document.flywheel ?? 0));
    this.#sort.addEventListener("change", () => this.#choose(/** @type {Sort} */ (this.#sort.value)));
    this.#table = make("input", { id: `field-${this.#prefix}motor.table`, class: "control long", type: "text", autocomplete: "off", spellcheck: "false", "data-t-label": "field.motor.table" });
    this.#table.addEventListener("input", () => {
      const table = pairsOf(this.#table.value);
      if (!table) page.drafts.keep(this.#tableField);
      else {
        page.drafts.drop(this.#tableField);
        this.#set(() => ({ motor: { table } }));
      }
    });
    this.#tableRow = make("div", { class: "load-field" }, [make("label", { for: this.#table.id, "data-t": "field.motor.table" }), this.#table]);
    const sort = make("div", { class: "load-field" }, [make("label", { for: this.#sort.id, "data-t": "under_load.motor" }), this.#sort]);
    this.element = make("div", { class: "load-fields" }, [this.#heading, sort, ...this.#rows.slice(0, PARTS.length).map(({ element }) => element), this.#tableRow, ...this.#rows.slice(PARTS.length).map(({ element }) => element)]);
  }

  /**
   * @param {LinkageDocument} document
   * @param {readonly Problem[]} problems of the engine with the forces
   * @param {Words} words
   */
  render(document, problems, words) {
    const several = document.drivers.length > 1;
    const driver = document.drivers[this.#driver];
    const turns = driver?.crank != null;
    const { motor } = this.#own(document);
    const sort = sortOf(motor, driver);
    const keeps = several || sort === "kept";
    const written = `${words.lang} ${keeps}`;
    if (this.#written !== written) {
      this.#written = written;
      const sorts = SORTS.filter((one) => keeps || one !== "kept");
      render(sorts.map((sort) => html`<option value=${sort}>${words.text(`under_load.motor.${sort}`)}</option>`), this.#sort);
    }
    this.#heading.hidden = !several;
    write(this.#heading, several ? words.text("under_load.driver", { name: called(drivenLink(document, this.#driver), words) }) : "");
    if (this.#sort.value !== sort) this.#sort.value = sort;
    for (const { element, unit, why, box, field, sort: of, value: read } of this.#rows) {
      const value = read(document);
      element.hidden = value == null || (field === "flywheel" && !turns && value === 0);
      if (value == null) continue;
      const part = field.startsWith(`${this.#prefix}motor.`) ? `${this.#prefix}motor` : field;
      const own = problems.filter(({ path, code }) => path === part || (field === "flywheel" && code === "flywheel_no_crank"));
      box.show(value, { brief: words.numbers.brief(value), full: words.numbers.exact(value) }, own.length > 0);
      write(unit, unitOf(of, turns, words));
      write(why, own.map((problem) => sentence(problem, words, document)).join(" "));
    }
    this.#tableRow.hidden = sort !== "table";
    const table = (motor?.table ?? []).map((pair) => pair.map((one) => words.numbers.exact(one)).join(" ")).join("; ");
    const bad = this.#page.drafts.has(this.#tableField);
    if (globalThis.document.activeElement !== this.#table && !bad) this.#table.value = table;
    this.#table.setAttribute("aria-invalid", String(bad || (sort === "table" && problems.some(({ path }) => path === `${this.#prefix}motor`))));
  }

  /**
   * @param {string} name of the field
   * @param {string} key
   * @param {Unit} sort
   * @param {(value: number) => void} set
   * @param {(document: LinkageDocument) => number | null | undefined} value
   */
  #row(name, key, sort, set, value) {
    const field = this.#prefix + name;
    const input = numberField({ id: `field-${field}`, "data-t-label": key });
    const unit = make("span", { class: "load-unit" });
    const why = make("p", { class: "load-why", role: "alert" });
    const element = make("div", { class: "load-field", "data-field": field }, [make("label", { for: input.id, "data-t": key }), make("span", {}, [input, " ", unit]), why]);
    return { element, unit, why, field, sort, value, box: new NumberBox(input, field, this.#page.drafts, set) };
  }

  /** @param {Sort} sort */
  #choose(sort) {
    this.#page.drafts.dropAll([...PARTS.map(([part]) => `${this.#prefix}motor.${part}`), this.#tableField]);
    const motor = sort === "kept" ? null : MOTORS[sort];
    this.#set(() => ({ motor: motor ? /** @type {Motor} */ (motor) : undefined }), sort === "kept" || undefined);
  }

  get #tableField() {
    return `${this.#prefix}motor.table`;
  }

  /**
   * @param {LinkageDocument} document
   * @returns {{ motor?: Motor | null, initial_rate?: number | null }} what has the motor of the driver
   */
  #own(document) {
    return this.#driver === 0 ? document : document.drivers[this.#driver] ?? {};
  }

  /** @param {LinkageDocument} document */
  #initialRate(document) {
    const first = document.initial_rate ?? 0;
    const driver = document.drivers[this.#driver];
    return this.#driver === 0 ? first : driver?.initial_rate ?? first * (driver?.rate ?? 1);
  }

  /**
   * @param {(own: { motor?: Motor | null, initial_rate?: number | null }) => { motor?: Motor, initial_rate?: number }} change
   * @param {(boolean | undefined)[]} keeps whether the driver keeps its rate; left out, that does not change
   */
  #set(change, ...keeps) {
    this.#page.store.update((state) => edited(state, "linkage", (document) => {
      const changed = change(this.#own(document));
      const ofDriver = { ...(this.#driver === 0 ? {} : changed), ...(keeps.length > 0 ? { keeps_rate: keeps[0] } : {}) };
      const drivers = document.drivers.map((driver, k) => (k === this.#driver ? { ...driver, ...ofDriver } : driver));
      return { ...(this.#driver === 0 ? changed : {}), ...(Object.keys(ofDriver).length > 0 ? { drivers } : {}) };
    }));
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
