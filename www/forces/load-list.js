// The list of loads: forces, torques and resistances, constant or by the input.
import { make } from "assur/core/dom.js";
import { called } from "assur/core/names.js";
import { parseNumber } from "assur/core/numbers.js";
import { card, writeReasons } from "assur/forces/card.js";
import { linkageOf, putList, without } from "assur/forces/change.js";
import { Fields, replaced } from "assur/forces/fields.js";

/**
 * @typedef {import("assur/state/state.js").LinkageDocument} Document
 * @typedef {NonNullable<Document["loads"]>[number]} Load
 * @typedef {NonNullable<Load["terms"]>[number]} Term
 * @typedef {import("assur/core/words.js").Words} Words
 * @typedef {"force" | "torque" | "drag" | "angular_drag"} Kind
 * @typedef {"value" | "terms" | "table"} Law
 */

/** Force, torque and coefficients of a new load, in the units of the document. */
const FORCE = 10;
const TORQUE = 1;
const COEFFICIENTS = Object.freeze(/** @type {const} */ ([1, 0]));
/** Direction of a new force, degrees. */
const DOWN = -90;

/** Greatest number of terms of a load: a field of a term is named by one number. */
export const TERMS = 1000;

const KINDS = Object.freeze(/** @type {const} */ (["force", "torque", "drag", "angular_drag"]));
const LAWS = Object.freeze(/** @type {const} */ (["value", "terms", "table"]));

/**
 * @param {Load} load
 * @returns {Kind}
 */
function kindOf({ point, resistance }) {
  if (resistance) return point ? "drag" : "angular_drag";
  return point ? "force" : "torque";
}

/**
 * @param {Load} load
 * @returns {Law}
 */
function lawOf({ terms, table }) {
  return terms ? "terms" : table ? "table" : "value";
}

/**
 * @param {Document} document
 * @param {string} link
 * @returns {string[]} the points and traced points of a link, or of the frame
 */
export function pointsOf({ links, frame, tracers = [] }, link) {
  const points = link === "frame" ? frame : (links.find(({ name }) => name === link)?.points ?? []);
  return [...points, ...tracers.filter((one) => one.link === link).map(({ name }) => name)];
}

export class Loads {
  name = /** @type {const} */ ("loads");
  element = make("div", { id: "loads" });
  #page;
  /** @type {Fields | null} */
  #fields = null;

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    this.#page = page;
  }

  /** @param {Document} document */
  shape({ loads = [] }) {
    return loads.map((load) => [kindOf(load), load.link, lawOf(load), load.terms?.length]);
  }

  /**
   * @param {Document} document
   * @param {Words} words
   */
  build(document, words) {
    const fields = new Fields(this.#page, words);
    this.#fields = fields;
    const cards = (document.loads ?? []).map((load, i) => this.#card(document, load, i, fields, words));
    replaced(this.element, [...cards, fields.button("load-add", "forces.loads.add", () => this.#add())]);
  }

  /**
   * @param {ReadonlySet<string>} wrong fields at fault
   * @param {(index: number) => string} reason why a load is refused; empty if it is not
   */
  show(wrong, reason) {
    this.#fields?.show(wrong);
    writeReasons(this.element, "load", linkageOf(this.#page).loads?.length ?? 0, reason);
  }

  #add() {
    const document = linkageOf(this.#page);
    const link = document.links.at(-1)?.name ?? "";
    const point = pointsOf(document, link).at(-1);
    this.#page.history.step(() => putList(this.#page, "loads", (loads) => [...loads, { link, point, value: FORCE, direction_deg: DOWN }]));
  }

  /**
   * @param {number} i
   * @param {Partial<Load>} change; an undefined field is removed
   */
  #put(i, change) {
    putList(this.#page, "loads", (loads) => loads.map((load, k) => (k === i ? without({ ...load, ...change }) : load)));
  }

  /**
   * @param {number} i
   * @param {Partial<Load>} change
   */
  #step(i, change) {
    this.#page.history.step(() => this.#put(i, change));
  }

  /**
   * @param {Document} document
   * @param {Load} load
   * @param {number} i
   * @param {Fields} fields
   * @param {Words} words
   */
  #card(document, load, i, fields, words) {
    const kind = kindOf(load);
    const now = () => /** @type {Load} */ (linkageOf(this.#page).loads?.[i] ?? load);
    const id = (/** @type {string} */ part) => `load-${i}-${part}`;
    const links = document.links.map(({ name }) => /** @type {const} */ ([name, called(name, words)]));
    const content = [
      fields.choice(id("kind"), "forces.loads.kind", KINDS.map((one) => [one, words.text(`forces.loads.${one}`)]), () => kindOf(now()), (value) => this.#turn(i, /** @type {Kind} */ (value))),
      fields.choice(id("link"), "forces.loads.link", links, () => now().link, (link) => this.#step(i, now().point ? { link, point: pointsOf(linkageOf(this.#page), link)[0] } : { link })),
    ];
    if (load.point) {
      const points = pointsOf(document, load.link).map((name) => /** @type {const} */ ([name, name]));
      content.push(fields.choice(id("point"), "forces.loads.point", points, () => now().point ?? "", (point) => this.#step(i, { point })));
    }
    if (load.resistance) {
      const coefficient = (/** @type {0 | 1} */ at) => fields.number(`loads[${i}].${at === 0 ? "k1" : "k2"}`, { n: words.numbers.exact(i + 1), symbol: `k_${at + 1}`, unit: `${kind === "drag" ? "drag" : "angular_drag"}${at === 1 ? "_square" : ""}` }, () => now().resistance?.[at] ?? 0, (value) => {
        const other = now().resistance?.[1 - at] ?? 0;
        this.#put(i, { resistance: at === 0 ? [value, other] : [other, value] });
      });
      content.push(coefficient(0), coefficient(1));
    } else {
      content.push(...this.#lawRows(load, i, kind, fields, words, now));
    }
    const title = `${words.text(`forces.loads.${kind}`)}: ${load.point ?? called(load.link, words)}`;
    const remove = () => this.#page.history.step(() => putList(this.#page, "loads", (loads) => loads.filter((_, k) => k !== i)));
    return card({ list: "load", i, title }, content, fields, remove);
  }

  /**
   * Changes the kind of a load.
   * @param {number} i
   * @param {Kind} kind
   */
  #turn(i, kind) {
    const document = linkageOf(this.#page);
    const { link, point } = document.loads?.[i] ?? { link: "" };
    const at = point ?? pointsOf(document, link)[0];
    const bare = { link, point: undefined, value: undefined, table: undefined, terms: undefined, direction_deg: undefined, turns: undefined, resistance: undefined };
    /** @type {Readonly<Record<Kind, Partial<Load>>>} */
    const usual = {
      force: { point: at, value: FORCE, direction_deg: DOWN },
      torque: { value: TORQUE },
      drag: { point: at, resistance: [...COEFFICIENTS] },
      angular_drag: { resistance: [...COEFFICIENTS] },
    };
    this.#step(i, { ...bare, ...usual[kind] });
  }

  /**
   * @param {Load} load
   * @param {number} i
   * @param {"force" | "torque" | "drag" | "angular_drag"} kind
   * @param {Fields} fields
   * @param {Words} words
   * @param {() => Load} now
   */
  #lawRows(load, i, kind, fields, words, now) {
    const unit = kind === "force" ? "newton" : "newton_metre";
    const symbol = kind === "force" ? "F" : "M";
    const law = lawOf(load);
    const n = words.numbers.exact(i + 1);
    const own = (/** @type {string} */ part) => `loads[${i}].${part}`;
    const rows = [fields.choice(`load-${i}-law`, "forces.loads.law", LAWS.map((one) => [one, words.text(`forces.law.${one}`)]), () => lawOf(now()), (value) => this.#relaw(i, /** @type {Law} */ (value)))];
    if (law === "value") rows.push(fields.number(own("value"), { symbol, unit, n }, () => now().value ?? 0, (value) => this.#put(i, { value })));
    if (law === "terms") {
      const terms = () => now().terms ?? [];
      const term = (/** @type {number} */ k, /** @type {"amplitude" | "order" | "phase_deg"} */ part, /** @type {string} */ letter, /** @type {import("assur/forces/fields.js").Unit} */ unit) =>
        fields.number(`terms[${i * TERMS + k}].${part}`, { symbol: letter, unit, n }, () => terms()[k]?.[part] ?? 0, (value) => this.#put(i, { terms: terms().map((one, at) => (at === k ? { ...one, [part]: value } : one)) }));
      (load.terms ?? []).forEach((_, k) => rows.push(term(k, "amplitude", `A_${k + 1}`, unit), term(k, "order", `k_${k + 1}`, "none"), term(k, "phase_deg", `α_${k + 1}`, "degree")));
      rows.push(make("div", { class: "forces-acts" }, [
        fields.button(`load-${i}-term`, "forces.law.add", () => this.#step(i, { terms: [...terms(), { amplitude: 1, order: terms().length }] })),
        fields.button(`load-${i}-term-less`, "forces.law.less", () => this.#step(i, { terms: terms().slice(0, Math.max(1, terms().length - 1)) })),
      ]));
    }
    if (law === "table") rows.push(this.#table(i, words, now));
    if (kind === "force") {
      rows.push(
        fields.number(own("direction"), { symbol: "α", unit: "degree", n }, () => now().direction_deg ?? 0, (direction_deg) => this.#put(i, { direction_deg })),
        fields.check(`load-${i}-turns`, "forces.loads.turns", () => !!now().turns, (turns) => this.#step(i, { turns: turns || undefined })),
      );
    }
    return rows;
  }

  /**
   * Changes the law of a load; its first value stays.
   * @param {number} i
   * @param {Law} law
   */
  #relaw(i, law) {
    const { value, terms, table } = linkageOf(this.#page).loads?.[i] ?? {};
    const first = value ?? terms?.[0]?.amplitude ?? table?.[0]?.[1] ?? 0;
    /** @type {Readonly<Record<Law, Partial<Load>>>} */
    const laws = { value: { value: first }, terms: { terms: [{ amplitude: first, order: 0 }] }, table: { table: [[0, first], [180, first]] } };
    this.#step(i, { value: undefined, terms: undefined, table: undefined, ...laws[law] });
  }

  /**
   * A text with the knots of a table: an input and a value on each line.
   * @param {number} i
   * @param {Words} words
   * @param {() => Load} now
   */
  #table(i, words, now) {
    const field = `loads[${i}].table`;
    const { drafts } = this.#page;
    const { numbers } = words;
    const text = make("textarea", { id: `load-${i}-table`, class: "control forces-table", rows: "4", spellcheck: "false" });
    text.value = (now().table ?? []).map((knot) => knot.map((one) => numbers.exact(one)).join("  ")).join("\n");
    text.addEventListener("input", () => {
      const lines = text.value.split("\n").filter((line) => line.trim() !== "");
      const knots = lines.map((line) => line.trim().split(/[\s;]+/).map(parseNumber));
      if (knots.length === 0 || knots.some((knot) => knot.length !== 2 || knot.includes(null))) return drafts.keep(field);
      drafts.drop(field);
      this.#put(i, { table: /** @type {[number, number][]} */ (knots) });
    });
    return make("label", { class: "forces-table-row" }, [make("span", {}, [words.text("forces.law.table_how")]), text]);
  }
}
