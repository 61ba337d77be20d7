// A reader's answers in a lesson, kept in the browser's storage under the lesson's name. Links do not contain answers.
import { keepLesson, kept } from "assur/state/storage.js";

export class Progress {
  #name;
  #steps;
  /** @type {Map<string, string>} answers by step */
  #given = new Map();
  /** @type {Set<string>} steps that the reader has answered correctly */
  #solved = new Set();
  /** @type {Set<string>} steps whose answer was shown to the reader */
  #shown = new Set();
  /** @type {Map<string, number>} number of judged answers by step */
  #tries = new Map();
  /** @type {Map<string, string>} digest of each step's mechanism when the page was left, by step */
  #mechanisms = new Map();

  /**
   * @param {string} lesson
   * @param {readonly { id: string }[]} steps current steps of the lesson; the stored answers to any other step are dropped
   */
  constructor(lesson, steps) {
    this.#name = lesson;
    this.#steps = steps;
    const { given, solved, shown, tries, mechanisms } = read(kept(`lesson.${lesson}`));
    for (const { id } of steps) {
      const text = given[id];
      if (typeof text === "string") this.#given.set(id, text);
      if (solved.includes(id)) this.#solved.add(id);
      if (shown.includes(id)) this.#shown.add(id);
      const count = tries[id];
      const mechanism = mechanisms[id];
      if (typeof mechanism === "string") this.#mechanisms.set(id, mechanism);
      if (typeof count === "number" && Number.isSafeInteger(count) && count > 0) this.#tries.set(id, count);
    }
  }

  /** @param {string} step */
  isSolved(step) {
    return this.#solved.has(step);
  }

  /** @param {string} step */
  isShown(step) {
    return this.#shown.has(step);
  }

  /**
   * @param {string} step
   * @returns {number} number of judged answers, up to and including the right one
   */
  tries(step) {
    return this.#tries.get(step) ?? 0;
  }

  /**
   * @param {string} step
   * @returns {string} digest of the step's mechanism when the page was left, empty if none is stored
   */
  mechanism(step) {
    return this.#mechanisms.get(step) ?? "";
  }

  /**
   * Stores a step's mechanism when the page is left. Other stored progress stays: another tab may have written it.
   * @param {string} step
   * @param {string} digest of the step's mechanism
   */
  leave(step, digest) {
    if (digest === this.mechanism(step)) return;
    this.#mechanisms.set(step, digest);
    const { mechanisms, ...rest } = read(kept(`lesson.${this.#name}`));
    keepLesson(this.#name, JSON.stringify({ ...rest, mechanisms: { ...mechanisms, [step]: digest } }));
  }

  /** Index of the first step that is neither solved nor shown, −1 if there is none. */
  get next() {
    return this.#steps.findIndex(({ id }) => !this.#solved.has(id) && !this.#shown.has(id));
  }

  /** Number of steps that the reader answered correctly without being shown the answer. */
  get solved() {
    return this.#solved.size;
  }

  /** Number of steps whose answer was shown. */
  get shown() {
    return this.#shown.size;
  }

  /** @param {string} step */
  given(step) {
    return this.#given.get(step) ?? "";
  }

  /**
   * @param {string} step
   * @param {string} text
   */
  give(step, text) {
    this.#given.set(step, text);
    this.#keep();
  }

  /**
   * Counts a judged answer, unless the step is already solved or its answer was shown.
   * @param {string} step
   * @param {boolean} right
   */
  countTry(step, right) {
    if (this.#solved.has(step) || this.#shown.has(step)) return;
    this.#tries.set(step, this.tries(step) + 1);
    if (right) this.#solved.add(step);
    this.#keep();
  }

  /** @param {string} step step whose answer the reader asks to see */
  show(step) {
    if (this.#solved.has(step)) return;
    this.#shown.add(step);
    this.#keep();
  }

  /** Removes the answers, for a reader who begins the lesson anew. */
  forget() {
    for (const part of [this.#given, this.#solved, this.#shown, this.#tries]) part.clear();
    this.#keep();
  }

  #keep() {
    const [given, tries, mechanisms] = [this.#given, this.#tries, this.#mechanisms].map((map) => Object.fromEntries(/** @type {Map<string, string | number>} */ (map)));
    keepLesson(this.#name, JSON.stringify({ given, solved: [...this.#solved], shown: [...this.#shown], tries, mechanisms }));
  }
}

/**
 * @param {string | null} text text from the storage, perhaps not written by this page
 * @returns {Readonly<Record<"given" | "tries" | "mechanisms", Readonly<Record<string, unknown>>> & Record<"solved" | "shown", readonly unknown[]>>} progress in the
 * text; lists that are not arrays are returned empty, as is everything if the text is not JSON
 */
function read(text) {
  const list = (/** @type {unknown} */ value) => (Array.isArray(value) ? value : []);
  try {
    const { given, solved, shown, tries, mechanisms } = JSON.parse(text ?? "{}");
    return { given: Object(given), tries: Object(tries), mechanisms: Object(mechanisms), solved: list(solved), shown: list(shown) };
  } catch {
    return { given: {}, tries: {}, mechanisms: {}, solved: [], shown: [] };
  }
}
