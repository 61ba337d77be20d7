// Items of a lesson's paper: formulas, their values for the current mechanism, whether they hold, correct formulas.
import { degrees } from "assur/core/angles.js";
import { make, write } from "assur/core/dom.js";
import { html, render } from "assur/core/html.js";
import { attempt } from "assur/core/problem.js";
import { Seen } from "assur/core/seen.js";
import { withSubscripts } from "assur/core/subscripts.js";

/**
 * @typedef {import("assur/core/words.js").Words} Words
 * @typedef {import("assur/state/model.js").AnySnapshot} Snapshot
 * @typedef {import("assur/types/web.js").RelationHere} Relation
 * @typedef {Readonly<{ item: string, step: string, verdict: string, printed: readonly string[], instead: readonly string[], shown: boolean }>} Item
 * An item of `paper.json`. `item`: its id. `step`: id of the step that it belongs to. `verdict`: whether it holds.
 * `printed`, `instead`: formulas as printed, and correct formulas; the build has converted both to MathML.
 * `shown`: true if its numbers do not give the answer away.
 * @typedef {Readonly<{ items: readonly Item[], main: ReadonlyMap<string, readonly string[]> }>} Printed
 * A paper. `items`: all its items. `main`: ids of the items that are shown below the text of a step, by the step's id.
 * @typedef {{ item: string, shown: boolean, container: HTMLElement }} Numbers
 * `item`: id of an item; `shown`: as in the item; `container`: element for its numbers.
 */

/** Difference up to which values count as equal, relative to 1 + |value|. */
const SAME = 1e-9;
const DECIMALS = 4;
const IN_DEGREES = 2;

/** Verdicts on items that do not hold as printed. */
const WRONG = Object.freeze(["misprint", "false"]);

export class Paper {
  #engine;
  #items;
  #main;
  /** @type {Words | null} */
  #words = null;
  /** Id of the shown step. */
  #step = "";
  /** @type {Numbers[]} elements for the numbers of the shown step's items */
  #numbers = [];
  #written = new Seen();

  /** Formulas shown below the text of the step, in their correct form. */
  main = make("div", { class: "printed" });
  #summary = make("summary", { id: "lesson-paper-name" });
  #rows = make("div", { class: "printed" });
  /** All items of the step as printed, with verdicts. At the end of the lesson also the wrong items of all steps. */
  fold = make("details", { id: "lesson-paper" }, [this.#summary, this.#rows]);

  /**
   * @param {Pick<import("assur/engine.js").Engine, "simulator">} engine
   * @param {Printed} printed
   */
  constructor(engine, { items, main }) {
    this.#engine = engine;
    this.#items = items;
    this.#main = main;
  }

  /**
   * @param {string} step id of the shown step, or of the end of the lesson
   * @param {boolean} closes whether `step` is the end of the lesson
   * @param {Words} words words of the page and of the paper
   */
  show(step, closes, words) {
    this.#words = words;
    const items = this.#items.filter((item) => item.step === step);
    const main = this.#main.get(step) ?? [];
    this.#numbers = [];
    this.#written = new Seen();
    this.#step = step;
    this.main.replaceChildren(...items.filter(({ item }) => main.includes(item)).map((item) => this.#row(asItHolds(item))));
    const wrong = closes ? this.#items.filter((item) => item.step !== step && WRONG.includes(item.verdict)) : [];
    /** @type {HTMLElement[][]} */
    const [rows, errata] = [items, wrong].map((some) => some.map((item) => this.#row(item, verdict(item, words))));
    if (errata.length > 0) rows.push(make("details", { id: "lesson-errata" }, [make("summary", { id: "lesson-errata-name" }, [words.text("lesson.errata")]), make("div", { class: "printed" }, errata)]));
    this.#rows.replaceChildren(...rows);
    write(this.#summary, words.text(closes ? "lesson.paper.about" : "lesson.paper.fold"));
    this.fold.open = closes;
    this.fold.hidden = items.length === 0;
  }

  /**
   * @param {string} step the id of a step
   * @param {Words} words words of the page and of the paper
   * @returns {HTMLElement[]} the step's items for a printed page: for the shown step, the content of its fold; for any
   * other step, only the formulas of the paper and whether they hold, because reasons and numbers may answer the question
   */
  onPaper(step, words) {
    if (step === this.#step) return [/** @type {HTMLElement} */ (this.#rows.cloneNode(true))];
    const items = this.#items.filter((item) => item.step === step && item.printed.length > 0);
    const rows = items.map((item) => make("div", { "data-item": item.item }, [...head(item), ...holds(item, words)]));
    return rows.length > 0 ? [make("div", { class: "printed" }, rows)] : [];
  }

  /** @param {Snapshot} snapshot */
  render({ summary, input, stale, problems, withheld }) {
    if (this.#numbers.length === 0 || this.#written.same(summary, input, stale, problems.length, withheld)) return;
    // While read-outs are withheld, only numbers that do not give the answer away are shown.
    const told = stale ? [] : known(this.#numbers, withheld);
    const asked = told.length === 0 ? null : attempt(() => this.#engine.simulator.relations(input)).value;
    const words = this.#words;
    if (!words) return;
    for (const one of this.#numbers) {
      const { item, container } = one;
      const relations = told.includes(one) ? (asked ?? []).filter((relation) => relation.item === item) : [];
      render(relations.map((relation) => html`<p>${withSubscripts(compared(relation, words))}</p>`), container);
    }
  }

  /**
   * @param {Item} item
   * @param {readonly Node[]} [further] elements after the formulas and numbers
   */
  #row(item, further = []) {
    const numbers = make("div", { class: "paper-numbers" });
    this.#numbers.push({ item: item.item, shown: item.shown, container: numbers });
    return make("div", { "data-item": item.item }, [...head(item), numbers, ...further]);
  }
}

/**
 * @template {{ shown: boolean }} T
 * @param {readonly T[]} items
 * @param {ReadonlySet<string>} withheld read-outs that give the answer away
 * @returns {readonly T[]} the items whose numbers may be shown: before the answer, only those that do not give it away
 */
export function known(items, withheld) {
  return withheld.size === 0 ? items : items.filter(({ shown }) => shown);
}

/**
 * @param {Item} item
 * @returns {Item} the item with its correct formulas, if there are any, in place of the printed ones
 */
function asItHolds(item) {
  return item.instead.length > 0 ? { ...item, printed: item.instead } : item;
}

/**
 * @param {Item} item
 * @returns {Node[]} the item's number in the paper and its formulas as printed
 */
function head({ item, printed }) {
  const label = labelled(item);
  return [...(label === "" ? [] : [make("b", {}, [label])]), ...printed.map(math)];
}

/**
 * @param {string} item id of an item: number of the paper, a dot, the item, such as `002.(3)l5`
 * @returns {string} number of the equation in brackets, such as `(3)`; empty if the item is not an equation
 */
export function labelled(item) {
  const [, label = ""] = /^\d+\.(\(\d+\))/.exec(item) ?? [];
  return label;
}

/**
 * @param {Item} item
 * @param {Words} words
 * @returns {Node[]} the comment on the item, if there is one; then whether the item holds, and the correct formulas
 */
function verdict(item, words) {
  const key = keyOf(item.item);
  const said = words.has(key) ? [make("p", {}, withSubscripts(words.text(key)))] : [];
  return [...said, ...holds(item, words)];
}

/**
 * @param {Item} item
 * @param {Words} words
 * @returns {Node[]} whether the item holds, and the correct formulas
 */
function holds({ verdict: held, printed, instead }, words) {
  // If the paper prints no formula, the one shown is not the paper's, and needs no verdict.
  if (held === "right" && printed.length === 0 && instead.length > 0) return instead.map(math);
  const said = [`lesson.printed.${held}`, ...(instead.length > 0 ? [`lesson.instead.${held}`] : [])].filter((key) => words.has(key));
  return [make("p", { class: "paper-verdict", "data-verdict": held }, [said.map((key) => words.text(key)).join(" ")]), ...instead.map(math)];
}

/**
 * @param {string} item
 * @returns {string} key of the comment on the item, and prefix of the keys of the item's own texts for its numbers
 */
function keyOf(item) {
  return `paper.${item.slice(item.indexOf(".") + 1)}`;
}

/**
 * @param {Relation} relation
 * @param {Words} words
 * @returns {string} the correct value; if the printed relation gives another value, also that and the difference; if it gives none, a note
 */
export function compared({ item, name, angle, turned, count, value, printed }, words) {
  const said = (/** @type {string} */ common) => {
    const own = `${keyOf(item)}${common.slice(common.lastIndexOf("."))}`;
    return words.has(own) ? own : common;
  };
  const number = (/** @type {number} */ one) => {
    if (count) return words.numbers.exact(one);
    return angle ? `${words.numbers.fixed(degrees(one), IN_DEGREES)}°` : words.numbers.fixed(one, DECIMALS);
  };
  if (printed === null) return words.text(said("lesson.paper.undefined"), { name, value: number(value) });
  const off = printed - value;
  const apart = angle && !turned ? off - 2 * Math.PI * Math.round(off / (2 * Math.PI)) : off;
  if (Math.abs(apart) <= SAME * (1 + Math.abs(value))) return `${name} = ${number(value)}`;
  return words.text(said("lesson.paper.differs"), { name, value: number(value), printed: number(printed), off: number(apart) });
}

/** @param {string} text an element of MathML, made by the build */
function math(text) {
  const [element] = new DOMParser().parseFromString(text, "text/html").body.children;
  return document.adoptNode(element);
}
