// What a reader has answered in a lesson. Kept in the browser's own store under the lesson's name: a link tells nobody.
import { keepLesson, kept } from "assur/state/storage.js";

export class Progress {
  #name;
  #steps;
  /** @type {Map<string, string>} what was answered, by step */
  #given = new Map();
  /** @type {Set<string>} steps that were answered rightly */
  #solved = new Set();
  /** @type {Set<string>} steps of which the reader had the answer shown */
  #shown = new Set();
  /** @type {Map<string, number>} how many answers were judged, by step */
  #tries = new Map();
  /** @type {Map<string, string>} digests of steps' mechanisms as they were when the page was left, by step */
  #mechanisms = new Map();

  /**
   * @param {string} lesson
   * @param {readonly { id: string }[]} steps that it has now: what was kept of others is dropped
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
   * @returns {number} how many of its answers were judged, up to the right one
   */
  tries(step) {
    return this.#tries.get(step) ?? 0;
  }

  /**
   * @param {string} step
   * @returns {string} digest of its mechanism as it was when the page was left, empty if it was not shown then
   */
  mechanism(step) {
    return this.#mechanisms.get(step) ?? "";
  }

  /**
   * Keeps the mechanism of a step when the page is left, and nothing else: another tab may have written since.
   * @param {string} step
   * @param {string} digest of its mechanism
   */
  leave(step, digest) {
    if (digest === this.mechanism(step)) return;
    this.#mechanisms.set(step, digest);
    const { mechanisms, ...rest } = read(kept(`lesson.${this.#name}`));
    keepLesson(this.#name, JSON.stringify({ ...rest, mechanisms: { ...mechanisms, [step]: digest } }));
  }

  /** The index of the first step that is still open, −1 if there is none. */
  get next() {
    return this.#steps.findIndex(({ id }) => !this.#solved.has(id) && !this.#shown.has(id));
  }

  /** How many steps were answered rightly before their answer was shown. */
  get solved() {
    return this.#solved.size;
  }

  /** How many steps had their answer shown. */
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
   * Counts an answer that was judged; once the step is solved or shown, no more are counted.
   * @param {string} step
   * @param {boolean} right
   */
  countTry(step, right) {
    if (this.#solved.has(step) || this.#shown.has(step)) return;
    this.#tries.set(step, this.tries(step) + 1);
    if (right) this.#solved.add(step);
    this.#keep();
  }

  /** @param {string} step that the reader gives up */
  show(step) {
    if (this.#solved.has(step)) return;
    this.#shown.add(step);
    this.#keep();
  }

  #keep() {
    const [given, tries, mechanisms] = [this.#given, this.#tries, this.#mechanisms].map((map) => Object.fromEntries(/** @type {Map<string, string | number>} */ (map)));
    keepLesson(this.#name, JSON.stringify({ given, solved: [...this.#solved], shown: [...this.#shown], tries, mechanisms }));
  }
}

/**
 * @param {string | null} text from the store, which anyone may have written
 * @returns {Readonly<Record<"given" | "tries" | "mechanisms", Readonly<Record<string, unknown>>> & Record<"solved" | "shown", readonly unknown[]>>} nothing where it has not
 * the form
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
