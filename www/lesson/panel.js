// A lesson step by step: a text, something to show, a question with a checked answer. Loaded when a lesson is opened.
import { make, write } from "assur/core/dom.js";
import { marked, withSubscripts } from "assur/core/subscripts.js";
import { Progress } from "assur/lesson/progress.js";
import { Tools } from "assur/lesson/tools.js";
import { withView } from "assur/state/state.js";

/**
 * @typedef {import("assur/state/model.js").AnySnapshot} Snapshot
 * @typedef {import("assur/state/state.js").State} State
 * @typedef {import("assur/core/words.js").Words} Words
 *
 * @typedef {"right" | "not_yet" | "unread" | "unanswered" | "none" | "stale"} Verdict
 * @typedef {{ verdict: Verdict, document: State["document"] }} Judged the document that the verdict was given of
 * @typedef {Readonly<{ title: string, text: string, choices: readonly string[] }>} Asked a question, with what may be chosen
 *
 * @typedef {Readonly<{ id: string, text: string, open: () => void }>} Shown a button, and what it opens instead of the document there is
 * @typedef {Readonly<{
 *   text: string, unit: string, options: readonly Readonly<{ value: string, text: string }>[] | null, hides: readonly string[],
 *   judge: (given: string, snapshot: Snapshot) => Verdict, hint: () => string, right: (snapshot: Snapshot) => string,
 *   reached?: (snapshot: Snapshot) => boolean,
 * }>} Question
 * `options`: of a choice, else a number is typed; `hides`: the read-outs that tell the answer, which the page withholds until it was given, or the
 * reader gives up; `reached`: nothing is typed, it is answered as soon as this holds.
 * @typedef {Readonly<{
 *   id: string, title: string, text: string, formula: string, shows: readonly Shown[], question: Question | null, errata: boolean,
 *   tools: import("assur/lesson/tools.js").Wanted,
 * }>} Told a step in words; steps are told apart by their ids, which progress is kept by
 * @typedef {{
 *   readonly id: string, readonly name: string, tell(words: Words): readonly Told[], openErrata?(words: Words): Promise<void>,
 *   frame?(panel: HTMLElement[], progress: Progress): HTMLElement[], answered?(): void,
 * }} Source
 * Where a lesson comes from: what it is called in links, by what name its progress is kept, its steps, and what stands around them and
 * is told when an answer is another.
 */

export class LessonPanel {
  #page;
  #source;
  /** @type {readonly Told[]} */
  #steps;
  #progress;
  /** @type {Words} */
  #words;
  /** @type {Snapshot | null} */
  #snapshot = null;
  /** @type {Map<string, Judged>} by steps */
  #judged = new Map();
  /** @type {readonly unknown[]} step and words that are shown */
  #shown = [];

  #back = make("button", { id: "lesson-back", class: "control icon", type: "button" }, ["‹"]);
  #on = make("button", { id: "lesson-on", class: "control icon", type: "button" }, ["›"]);
  #walked = make("p", { id: "lesson-progress", role: "status" });
  #title = make("h2", { id: "lesson-title", tabindex: "-1" });
  #text = make("div", { class: "lesson-text" });
  #shows = make("div", { class: "segments" });
  #errata = make("button", { id: "lesson-errata", class: "control add", type: "button", hidden: "" });
  #legend = make("legend", { id: "lesson-question" });
  #fields = make("div", { class: "choices" });
  #check = make("button", { id: "lesson-check", class: "control" });
  #reveal = make("button", { id: "lesson-reveal", class: "control", type: "button" });
  #form;
  #said = make("p", { id: "lesson-said", role: "status" });
  #tools = new Tools();
  /** @type {Set<string>} those of which the reader has asked to see the answer */
  #revealed = new Set();

  /**
   * @param {HTMLElement} place
   * @param {import("assur/app/page.js").Page} page
   * @param {Source} source
   * @param {Words} words of the page, and those of the lesson
   */
  constructor(place, page, source, words) {
    this.#page = page;
    this.#source = source;
    this.#words = words;
    this.#steps = source.tell(words);
    this.#progress = new Progress(source.name, this.#steps);
    const form = this.#form = make("form", { autocomplete: "off" }, [make("fieldset", {}, [this.#legend, this.#fields]), make("div", { class: "lesson-buttons" }, [this.#check, this.#reveal]), this.#said]);
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      this.#answer();
    });
    this.#back.addEventListener("click", () => this.#go(-1));
    this.#on.addEventListener("click", () => this.#go(1));
    this.#errata.addEventListener("click", () => source.openErrata?.(this.#words));
    this.#reveal.addEventListener("click", () => {
      this.#revealed.add(this.#step.id);
      this.#withhold();
      this.#check.focus();
    });
    const walk = make("div", { class: "lesson-walk" }, [this.#back, this.#walked, this.#on]);
    const panel = [walk, this.#title, this.#text, this.#shows, this.#tools.element, this.#errata, form];
    place.replaceChildren(...(source.frame?.(panel, this.#progress) ?? panel));
  }

  /** Gives back what the page has lent, and withholds nothing. */
  close() {
    this.#tools.close();
    this.#shown = [];
    this.#setWithheld([]);
  }

  /** @param {Words} words */
  speak(words) {
    this.#words = words;
    this.#steps = this.#source.tell(words);
  }

  /** @returns {Asked[]} */
  questions() {
    return this.#steps.flatMap(({ title, question }) => {
      if (!question) return [];
      return [{ title, text: question.text, choices: (question.options ?? []).map(({ text }) => text) }];
    });
  }

  /** Where a reader who opened it by a key goes on. */
  focus() {
    this.#title.focus();
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    this.#snapshot = snapshot;
    const number = this.#number(snapshot.state);
    const shown = [number, this.#words];
    if (shown.some((part, i) => part !== this.#shown[i])) {
      this.#shown = shown;
      this.#write(number);
    }
    if (snapshot.legible) this.#tools.render();
    // What was said of another mechanism no longer holds.
    const step = this.#steps[number - 1];
    const judged = this.#judged.get(step.id);
    if (judged && judged.document !== snapshot.state.document) {
      this.#judged.delete(step.id);
      this.#say();
    }
    if (step.question?.reached?.(snapshot) && !this.#progress.isSolved(step.id)) this.#answer();
  }

  /**
   * A link may hold a step that the lesson has no more: the last is open.
   * @param {State} state
   */
  #number({ view }) {
    return Math.min(view.lesson?.step ?? 1, this.#steps.length);
  }

  get #step() {
    return this.#steps[this.#number(this.#page.store.get()) - 1];
  }

  /** @param {number} by */
  #go(by) {
    this.#page.store.update((state) => {
      const { lesson } = state.view;
      // Pressed twice before it is drawn, a button may lead farther than there are steps.
      const step = Math.min(Math.max(this.#number(state) + by, 1), this.#steps.length);
      return lesson ? withView(state, { lesson: { ...lesson, step } }) : state;
    });
  }

  /** @param {number} number */
  #write(number) {
    const words = this.#words;
    const step = this.#steps[number - 1];
    const { title, text, formula, shows, question, errata } = step;
    this.#back.ariaLabel = this.#back.title = words.text("lesson.back");
    this.#on.ariaLabel = this.#on.title = words.text("lesson.on");
    // A button that leads no farther gives the focus to its twin, else it would be lost.
    const focused = document.activeElement;
    this.#back.disabled = number === 1;
    this.#on.disabled = number === this.#steps.length;
    if (focused === this.#back && this.#back.disabled) this.#on.focus();
    if (focused === this.#on && this.#on.disabled) this.#back.focus();

    write(this.#title, title);
    const paragraphs = text.split("\n").map((one) => make("p", {}, marked(one)));
    const lines = formula === "" ? [] : [make("p", { class: "formula" }, withSubscripts(formula))];
    this.#text.replaceChildren(...paragraphs, ...lines);
    this.#shows.replaceChildren(...shows.map(({ id, text: said, open }) => {
      const button = make("button", { id, class: "segment", type: "button" }, [said]);
      button.addEventListener("click", open);
      return button;
    }));
    write(this.#errata, words.text("lesson.errata"));
    this.#errata.hidden = !errata;
    this.#form.hidden = !question;
    this.#check.hidden = question?.reached !== undefined;
    write(this.#legend, question?.text ?? "");
    this.#fields.replaceChildren(...(question ? this.#inputs(question) : []));
    write(this.#check, words.text("lesson.check"));
    write(this.#reveal, words.text("lesson.reveal"));
    this.#tools.show(step.tools, () => this.#page.store.get().document);
    this.#withhold();
    this.#say();
  }

  /** Read-outs that tell the answer are withheld until it is given, unless the reader gives up. */
  #withhold() {
    const step = this.#step;
    const open = !this.#progress.isSolved(step.id) && !this.#revealed.has(step.id);
    const { hides } = step.question ?? { hides: [] };
    this.#setWithheld(open ? hides : []);
    this.#reveal.hidden = !open || hides.length === 0;
  }

  /** @param {readonly string[]} readouts that are not to be written */
  #setWithheld(readouts) {
    const { model } = this.#page;
    if (readouts.join() === [...model.withheld].join()) return;
    model.withheld = new Set(readouts);
    this.#page.redraw();
  }

  /**
   * @param {Question} question
   * @returns {HTMLElement[]} what the answer is given in
   */
  #inputs({ options, unit, reached }) {
    if (reached) return [];
    const step = this.#step;
    const given = this.#progress.given(step.id);
    const note = (/** @type {HTMLInputElement} */ input) => {
      this.#progress.give(step.id, input.value);
      this.#judged.delete(step.id);
      this.#say();
    };
    if (!options) {
      const input = make("input", {
        id: "lesson-answer", class: "control number", type: "text", inputmode: "decimal", spellcheck: "false",
        "aria-labelledby": "lesson-question", "aria-describedby": "lesson-said",
      });
      input.value = given;
      input.addEventListener("input", () => note(input));
      return [make("div", { class: "lesson-answer" }, [input, unit])];
    }
    return options.map(({ value, text }) => {
      const input = make("input", { id: `lesson-${value}`, type: "radio", name: "lesson-choice", value });
      input.checked = value === given;
      input.addEventListener("change", () => note(input));
      return make("label", { class: "choice" }, [input, make("span", {}, marked(text))]);
    });
  }

  #answer() {
    const { id, question } = this.#step;
    if (!this.#snapshot || !question) return;
    const verdict = question.judge(this.#progress.given(id), this.#snapshot);
    this.#judged.set(id, { verdict, document: this.#snapshot.state.document });
    if (verdict === "right") this.#progress.solve(id);
    this.#withhold();
    this.#say();
    this.#said.scrollIntoView({ block: "nearest" });
  }

  /** Writes progress and what is said of the answer. */
  #say() {
    const words = this.#words;
    const step = this.#step;
    const [number, count] = [this.#steps.indexOf(step) + 1, this.#steps.length].map((one) => words.numbers.exact(one));
    const { solved } = this.#progress;
    const done = solved > 0 ? `, ${words.counted("lesson.solved", solved)}` : "";
    write(this.#walked, words.text("lesson.progress", { number, count }) + done);
    const verdict = this.#judged.get(step.id)?.verdict ?? null;
    this.#said.dataset.verdict = verdict ?? "";
    write(this.#said, verdict ? [words.text(`lesson.${verdict}`), this.#reason(step, verdict)].join(" ") : "");
    this.#source.answered?.();
  }

  /**
   * @param {Told} step
   * @param {Verdict} verdict
   */
  #reason({ question }, verdict) {
    if (verdict === "not_yet") return question?.hint() ?? "";
    return verdict === "right" && this.#snapshot ? (question?.right(this.#snapshot) ?? "") : "";
  }
}
