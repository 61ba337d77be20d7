// Practice with a generated mechanism: every step of the method is asked for and checked.
import { NumberBox, numberField } from "assur/controls/number-box.js";
import { section } from "assur/controls/section.js";
import { make, write } from "assur/core/dom.js";
import { Seen } from "assur/core/seen.js";
import { symbolOf } from "assur/kinds/scheme/sums.js";
import { edited } from "assur/state/state.js";

/**
 * @typedef {import("assur/kinds/scheme/opening.js").Snapshot} Snapshot
 * @typedef {Snapshot["summary"]} Summary
 * @typedef {import("assur/core/words.js").Words} Words
 * @typedef {{ id: string, said: (words: Words) => string, answer: (summary: Summary) => number, opened: boolean }} Question
 * `said`: the text. `answer`: the right answer. `opened`: whether the question can be answered only after every contour is cut open.
 */

/** Number of different tasks, few enough for short task numbers. */
const TASKS = 100000;

/** @type {readonly Question[]} */
const FIRST = Object.freeze([{ id: "links", said: (words) => words.text("practice.links"), answer: ({ counts }) => counts.links, opened: false }]);

/** @type {readonly Question[]} */
const THEN = Object.freeze([
  { id: "open", said: (words) => words.text("practice.open"), answer: ({ sections }) => sections?.open ?? NaN, opened: true },
  { id: "removed", said: (words) => words.text("practice.removed"), answer: ({ sections }) => sections?.removed ?? NaN, opened: true },
  { id: "w", said: (words) => words.text("practice.w"), answer: ({ mobility }) => mobility, opened: false },
  { id: "q", said: (words) => words.text("practice.q"), answer: ({ redundant }) => redundant, opened: false },
]);

export class PracticeView {
  #page;
  #new = make("button", { id: "practice-new", class: "control add", type: "button", "data-t": "practice.new", onclick: () => this.#task() });
  #end = make("button", { id: "practice-end", class: "control add", type: "button", "data-t": "practice.end" });
  #said = make("p", { id: "practice-said" });
  #rows = make("div", { id: "practice-rows" });
  /** Language, task and classes of pairs for which the questions were built, as JSON. */
  #asked = "";
  /** @type {number | null} task to which the answers belong */
  #answered = null;
  /** @type {Map<string, number>} answers by the id of the question */
  #answers = new Map();
  /** @type {{ question: Question, box: NumberBox, verdict: HTMLElement, input: HTMLInputElement }[]} */
  #questions = [];
  /** @type {Snapshot | null} */
  #snapshot = null;
  #shown = new Seen();

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    this.#page = page;
    this.#end.addEventListener("click", () => page.store.update((state) => edited(state, "scheme", () => ({ task: null }))));
    section("scheme", "practice.heading", "practice", [this.#said, this.#rows, make("div", { class: "buttons" }, [this.#new, this.#end])]);
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    const { state: { document }, summary, words, stale } = snapshot;
    if (this.#shown.same(document, summary, words, stale)) return;
    this.#snapshot = snapshot;
    const task = document.task ?? null;
    this.#end.hidden = this.#said.hidden = this.#rows.hidden = task === null;
    if (task === null || stale) return;
    const classes = summary.counts.pairs.map(({ freedoms }) => freedoms);
    const asked = JSON.stringify([words.lang, task, classes]);
    if (asked !== this.#asked) {
      if (task !== this.#answered) this.#answers.clear();
      this.#answered = task;
      this.#asked = asked;
      this.#build(classes, words);
    }
    this.#judge();
  }

  /** Opens a random task other than the present one. */
  #task() {
    const { engine, store } = this.#page;
    const { document } = store.get();
    const before = "task" in document ? document.task : null;
    let number = Math.floor(Math.random() * TASKS);
    if (number === before) number = (number + 1) % TASKS;
    const { kind, document: task } = engine.functions.task(number);
    this.#page.choose(kind, task);
  }

  /**
   * @param {readonly number[]} classes of the pairs in the scheme
   * @param {Words} words
   */
  #build(classes, words) {
    /** @type {Question[]} */
    const counted = classes.map((freedoms) => ({
      id: `pairs-${freedoms}`,
      said: () => words.counted("practice.pairs", freedoms, { symbol: symbolOf(freedoms) }),
      answer: ({ counts }) => counts.pairs.find((one) => one.freedoms === freedoms)?.count ?? 0,
      opened: false,
    }));
    this.#questions = [...FIRST, ...counted, ...THEN].map((question) => {
      const field = `practice.${question.id}`;
      const input = numberField({ id: `practice-${question.id}`, inputmode: "numeric" });
      const box = new NumberBox(input, field, this.#page.drafts, (value) => {
        this.#answers.set(question.id, value);
        this.#judge();
      });
      input.addEventListener("input", () => {
        if (input.value.trim() !== "") return;
        this.#page.drafts.drop(field);
        this.#answers.delete(question.id);
        this.#judge();
      });
      return { question, input, box, verdict: make("span", { class: "verdict", "aria-live": "polite" }) };
    });
    this.#rows.replaceChildren(...this.#questions.map(({ question, input, verdict }) => (
      make("div", { class: "practice-row" }, [make("label", { for: input.id }, [question.said(words)]), input, verdict])
    )));
  }

  #judge() {
    const snapshot = this.#snapshot;
    if (!snapshot) return;
    const { summary, words } = snapshot;
    let right = 0;
    for (const { question, box, verdict, input } of this.#questions) {
      const value = this.#answers.get(question.id);
      const written = value === undefined ? "" : words.numbers.exact(value);
      box.show(value ?? NaN, { brief: written, full: written }, false);
      const early = question.opened && !summary.sections;
      const good = value !== undefined && !early && value === question.answer(summary);
      right += good ? 1 : 0;
      const found = value === undefined ? "" : early ? "first" : good ? "right" : "wrong";
      write(verdict, found ? words.text(`practice.${found}`) : "");
      input.dataset.verdict = found;
    }
    write(this.#said, words.text(right === this.#questions.length ? "practice.done" : "practice.said"));
  }
}
