// What a reader has answered in a lesson. Kept in the browser's own store under the lesson's name: a link tells nobody.
import { keep, kept } from "assur/state/storage.js";

export class Progress {
  #name;
  #steps;
  /** @type {Map<string, string>} what was answered, by step */
  #given = new Map();
  /** @type {Set<string>} */
  #solved = new Set();

  /**
   * @param {string} lesson
   * @param {readonly { id: string }[]} steps that it has now: what was kept of others is dropped
   */
  constructor(lesson, steps) {
    this.#name = `lesson.${lesson}`;
    this.#steps = steps;
    const { given, solved } = read(kept(this.#name));
    for (const { id } of steps) {
      const text = given[id];
      if (typeof text === "string") this.#given.set(id, text);
      if (solved.includes(id)) this.#solved.add(id);
    }
  }

  /** @param {string} step */
  isSolved(step) {
    return this.#solved.has(step);
  }

  /** The first step that was not answered rightly; −1 where all were. */
  get next() {
    return this.#steps.findIndex(({ id }) => !this.#solved.has(id));
  }

  /** How many steps were answered rightly. */
  get solved() {
    return this.#solved.size;
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

  /** @param {string} step */
  solve(step) {
    this.#solved.add(step);
    this.#keep();
  }

  #keep() {
    keep(this.#name, JSON.stringify({ given: Object.fromEntries(this.#given), solved: [...this.#solved] }));
  }
}

/**
 * @param {string | null} text from the store, which anyone may have written
 * @returns {{ given: Readonly<Record<string, unknown>>, solved: readonly unknown[] }} nothing where it has not the form
 */
function read(text) {
  try {
    const { given, solved } = JSON.parse(text ?? "{}");
    return { given: Object(given), solved: Array.isArray(solved) ? solved : [] };
  } catch {
    return { given: {}, solved: [] };
  }
}
