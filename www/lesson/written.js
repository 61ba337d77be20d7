// A lecturer's lesson in the panel, with a field for the reader's name above it and the code of the result below it.
import { make, write } from "assur/core/dom.js";
import { download } from "assur/core/download.js";
import { attempt } from "assur/core/problem.js";
import { measured } from "assur/core/units.js";
import { hash, nameKey } from "assur/lesson/chance.js";
import { toCode } from "assur/lesson/code.js";
import { judged } from "assur/lesson/folder.js";
import { OWN, originOf } from "assur/lesson/offer.js";
import { isRound, secrets, toleranceOf, unitOf, withTolerance } from "assur/lesson/quantity.js";
import { READERS } from "assur/lesson/steps.js";
import "assur/lesson/style.js";
import { RESTING, answerOf, shownBy, taskOf, valueOf } from "assur/lesson/tasks.js";
import { REACHED, WRITTEN_HERE, digestOf, verdictOf } from "assur/lesson/verdict.js";
import { keepLesson, kept } from "assur/state/storage.js";
import { usualView } from "assur/state/state.js";

/**
 * @typedef {import("assur/core/words.js").Words} Words
 * @typedef {import("assur/lesson/panel.js").Question} Question
 * @typedef {import("assur/lesson/progress.js").Progress} Progress
 * @typedef {import("assur/state/state.js").Written} Written
 * @typedef {NonNullable<Written["steps"][number]["question"]>} Asked
 */

/** Limits in characters. `MAX_NAME`: length of a name. `MAX_ANSWER`: length of an answer in a code. */
const MAX_NAME = 80;
const MAX_ANSWER = 60;

/**
 * Opens a step's document with the reader's own numbers.
 * @param {Written} lesson
 * @param {number} index
 * @param {string} name name of the reader; if it is empty, the lecturer's numbers are used
 * @param {import("assur/app/page.js").Page} page
 * @param {Partial<import("assur/state/state.js").View>} [further] further fields of the view
 */
export function openShown(lesson, index, name, page, further = {}) {
  const found = shownBy(lesson, index);
  if (!found) return;
  const { kind, document, view } = found.shows;
  const task = taskOf(lesson, index, name, page.engine);
  // Fields of the view that belong to the reader, such as the language, are kept.
  const look = Object.entries(usualView({ ...RESTING, ...view })).filter(([key]) => !READERS.includes(key));
  page.choose(kind, task?.state.document ?? document, [], () => ({ ...Object.fromEntries(look), ...further }));
}

export class WrittenLesson {
  id = OWN;
  #lesson;
  #page;
  #words;
  #digest;
  #reader;
  /** @type {Progress | null} */
  #progress = null;
  /** @type {Map<number, number | null>} right answers computed so far for the reader, by step */
  #exact = new Map();
  #code = make("input", { id: "lesson-code", class: "control", type: "text", readonly: "" });
  #result = make("div", { class: "lesson-result" });

  /**
   * @param {Written} lesson
   * @param {import("assur/app/page.js").Page} page
   * @param {Words} words
   */
  constructor(lesson, page, words) {
    this.#lesson = lesson;
    this.#page = page;
    this.#words = words;
    this.#digest = digestOf(lesson, page.engine);
    this.#reader = (kept(`lesson.${OWN}.${this.#digest}`) ?? "").slice(0, MAX_NAME);
  }

  /** Name under which the reader's progress in this lesson is kept. */
  get name() {
    return `${OWN}.${this.#digest}.${hash(nameKey(this.#reader)).toString(36)}`;
  }

  /**
   * @param {Words} words
   * @returns {readonly import("assur/lesson/panel.js").Told[]}
   */
  tell(words) {
    this.#words = words;
    return this.#lesson.steps.map(({ title, text, formula = "", question }, index) => ({
      id: String(index + 1),
      title,
      text,
      formula,
      shows: this.#shows(index),
      from: shownBy(this.#lesson, index)?.index ?? null,
      question: question ? this.#question(question, index) : null,
      tools: {},
    }));
  }

  /**
   * @param {number} index of a step
   * @param {import("assur/state/state.js").State} state
   * @returns {boolean} whether the state's mechanism has the kind and the catalogue origin of the step's document
   */
  #isShown(index, state) {
    const shows = shownBy(this.#lesson, index)?.shows;
    return !shows || (shows.kind === state.kind && originOf(shows) === originOf(state));
  }

  /** @param {number} index */
  #shows(index) {
    const open = (/** @type {Partial<import("assur/state/state.js").View>} */ view = {}) => openShown(this.#lesson, index, this.#reader, this.#page, view);
    return shownBy(this.#lesson, index) ? [{ id: "lesson-show", text: this.#words.text("lesson.show"), open }] : [];
  }

  /**
   * @param {number} index of a step whose answer is a number
   * @returns {number | null} the right answer; null if there is none
   */
  #answer(index) {
    if (!this.#exact.has(index)) {
      const { value, problems } = attempt(() => answerOf(this.#lesson, index, this.#reader, this.#page.engine));
      // A failure is not stored, so that the engine is asked again.
      if (problems.length > 0) return null;
      this.#exact.set(index, value ?? null);
    }
    return this.#exact.get(index) ?? null;
  }

  /**
   * @param {Asked} asked
   * @param {number} index
   * @returns {Question}
   */
  #question(asked, index) {
    const { text, hint = "", number, choice, reach } = asked;
    const words = this.#words;
    const unit = unitOf(number);
    /** @type {Partial<Question>} */
    const reached = reach ? {
      reached: ({ stale, state, ...here }) => {
        // A value passed in motion is no answer, nor is a value of another mechanism.
        const value = stale || state.view.playing || !this.#isShown(index, state) ? null : valueOf(reach.quantity, here);
        return value !== null && judged(String(value), reach.value, reach.within, isRound(reach.quantity)) === "right";
      },
    } : {};
    return {
      text: withTolerance(text, toleranceOf(number), unit, words),
      unit,
      hides: number?.shown ? [] : secrets(number),
      options: choice ? choice.options.map((option, i) => ({ value: String(i), text: option })) : null,
      judge: (given) => (reach ? "right" : verdictOf(asked, given, () => this.#answer(index))),
      hint: () => hint,
      right: () => {
        const exact = number ? this.#answer(index) : null;
        return exact === null ? "" : words.text("written.exactly", { value: measured(words.numbers.upTo(exact, 4), unit) });
      },
      answer: () => {
        if (choice) return choice.options[choice.answer] ?? null;
        const exact = number ? this.#answer(index) : null;
        return exact === null ? null : measured(words.numbers.upTo(exact, 4), unit);
      },
      ofPage: false,
      ...reached,
    };
  }

  /**
   * @param {HTMLElement[]} step
   * @param {Progress} progress
   * @param {() => Progress} renew loads and returns the progress of the reader whose name was just entered
   */
  frame(step, progress, renew) {
    this.#progress = progress;
    const { title, author, steps } = this.#lesson;
    const words = this.#words;
    const head = make("header", { class: "lesson-head" }, [make("b", { id: "lesson-name" }, [title]), ...(author ? [" ", make("span", {}, [author])] : [])]);
    const rewrite = make("button", { id: "lesson-write", class: "control add", type: "button", onclick: () => this.#page.lesson.write(true) }, [words.text("written.write")]);
    // The form for lecturers contains the answers: only the lesson's author gets a button for it; others use the menu.
    const own = kept(WRITTEN_HERE) === this.#digest ? [rewrite] : [];
    if (!steps.some(({ question }) => question)) return [head, ...step, ...own];
    const reader = make("input", { id: "lesson-reader", class: "control", type: "text", maxlength: String(MAX_NAME), autocomplete: "off", spellcheck: "false" });
    reader.value = this.#reader;
    const varied = steps.some(({ shows }) => shows?.vary?.length);
    const note = make("p", { class: "lesson-note" });
    const tell = () => write(note, this.#words.text(this.#reader.trim() ? "written.own" : "written.name_first"));
    tell();
    reader.addEventListener("change", () => {
      keepLesson(`${OWN}.${this.#digest}`, reader.value);
      this.#reader = reader.value;
      this.#exact.clear();
      this.#progress = renew();
      tell();
      this.answered();
    });
    const copy = make("button", { id: "lesson-copy", class: "control", type: "button" }, [words.text("written.copy")]);
    copy.addEventListener("click", async () => {
      this.#code.select();
      await navigator.clipboard?.writeText(this.#code.value).then(() => this.#page.notices.tell(["result"]), () => {});
    });
    const save = make("button", { id: "lesson-save", class: "control", type: "button" }, [words.text("written.save")]);
    save.addEventListener("click", () => download(new Blob([`${this.#code.value}\n`], { type: "text/plain" }), "assur-result.txt"));
    this.#result.replaceChildren(
      make("label", { for: "lesson-code" }, [words.text("written.code")]), this.#code,
      make("div", { class: "lesson-buttons" }, [copy, save]),
    );
    const whose = make("div", { class: "lesson-whose" }, [make("label", { for: "lesson-reader" }, [words.text("written.reader")]), reader, ...(varied ? [note] : [])]);
    return [head, whose, ...step, this.#result, ...own];
  }

  /** Writes the result code of the current answers. */
  answered() {
    const progress = this.#progress;
    if (!progress) return;
    const answers = this.#lesson.steps.map(({ question }, i) => {
      const id = String(i + 1);
      if (!question) return null;
      const given = question.reach ? (progress.isSolved(id) ? REACHED : "") : progress.given(id).slice(0, MAX_ANSWER);
      return { given, tries: progress.tries(id), shown: progress.isShown(id) };
    });
    this.#result.hidden = this.#reader.trim() === "" || !answers.some((answer) => answer && (answer.given || answer.shown));
    if (this.#result.hidden) return;
    const code = toCode({ lesson: this.#digest, name: this.#reader.trim(), answers });
    if (this.#code.value !== code) this.#code.value = code;
  }
}
