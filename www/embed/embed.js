// The page within another page, set up by parameters of its address (docs/embedding.md), as in
// `?embed=stage&edit=no#jansen`. Without `embed`, this module is not loaded and the other parameters have no effect.
import { addStyle, setData } from "assur/core/dom.js";
import { LANGUAGES } from "assur/core/words.js";
import { LESSONS } from "assur/lessons/index.js";
import { addressed } from "assur/state/address.js";
import { withView } from "assur/state/state.js";

/**
 * @typedef {import("assur/app/opening.js").Habits} Habits
 * @typedef {import("assur/core/problem.js").Problem} Problem
 * @typedef {import("assur/state/state.js").State} State
 */

const SWITCH = Object.freeze(["yes", "no"]);

/** Allowed values of the parameters. */
const VALUES = Object.freeze(/** @type {Record<string, readonly string[] | RegExp>} */ ({
  embed: ["stage", "plots", "lesson", "page"],
  lesson: LESSONS.map(({ id }) => id),
  step: /^[1-9]\d?$/,
  edit: SWITCH,
  bar: SWITCH,
  play: SWITCH,
  lang: LANGUAGES,
}));

/** Commands available in a frame: `MOVING` always, `EDITING` if the mechanism may be changed. A frame with the whole page and editing has all. */
const MOVING = Object.freeze(["play", "back", "forward", "back10", "forward10", "start", "end", "faster", "slower", "reverse", "all", "close"]);
const EDITING = Object.freeze(["assembly1", "assembly2", "trace", "undo", "redo"]);

export class Embedding {
  /** @type {Readonly<Record<string, string | undefined>>} */
  #given;
  /** @type {readonly Problem[]} */
  #problems;

  /** @param {string} search parameters of the address */
  constructor(search) {
    /** @type {Record<string, string>} */
    const given = {};
    /** @type {Problem[]} */
    const problems = [];
    for (const [name, value] of new URLSearchParams(search)) {
      const values = Object.hasOwn(VALUES, name) ? VALUES[name] : null;
      if (!values) problems.push({ code: "embed_parameter", name });
      else if (values instanceof RegExp ? values.test(value) : values.includes(value)) given[name] = value;
      else problems.push({ code: "embed_value", name, value });
    }
    // A lesson needs editing: its steps ask for changes, and open documents of their own.
    if (given.edit === "no" && (given.embed === "lesson" || given.lesson)) {
      problems.push({ code: "embed_value", name: "edit", value: "no" });
      delete given.edit;
    }
    this.#given = { embed: "stage", ...given };
    this.#problems = problems;
    const { embed, edit = "yes", bar = "yes" } = this.#given;
    for (const [name, value] of Object.entries({ embed, edit, bar })) setData(document.documentElement, name, String(value));
  }

  /** Whether the mechanism may be changed. */
  get edits() {
    return this.#given.edit !== "no";
  }

  /**
   * @param {Habits} habits of the reader
   * @returns {Habits} the habits changed by the parameters
   */
  habits({ calm, lang }) {
    return { calm: calm || this.#given.play === "no", lang: this.#given.lang ?? lang, embedding: this };
  }

  /**
   * @param {import("assur/app/opening.js").Opening} opening
   * @param {boolean} calm whether no motion may start by itself
   * @returns {Promise<import("assur/app/opening.js").Opening>} the opening changed by the parameters, with a failure for invalid parameters
   */
  async opened({ state, failures }, calm) {
    await addStyle("embed/style.css");
    const { lang, play, lesson: id, step } = this.#given;
    const lesson = id ? { id, step: Number(step ?? 1) } : state.view.lesson;
    const view = { lang: lang ?? state.view.lang, playing: (play === "yes" && !calm) || state.view.playing, lesson };
    const own = this.#problems.length > 0 ? [{ kind: /** @type {const} */ ("embed"), problems: this.#problems }] : [];
    return { state: withView(state, view), failures: [...failures, ...own] };
  }

  /**
   * @param {Readonly<Record<string, () => void>>} commands of the keys
   * @returns {Readonly<Record<string, () => void>>} the commands; those that are not available in the frame do nothing
   */
  commands(commands) {
    const there = new Set([...MOVING, ...(this.edits ? EDITING : [])]);
    const allAvailable = this.#given.embed === "page" && this.edits;
    return Object.fromEntries(Object.entries(commands).map(([name, act]) => [name, allAvailable || there.has(name) ? act : () => {}]));
  }

  /**
   * @param {State} next
   * @param {State} now
   * @returns {State} the next state; the present one if editing is not allowed and the next state changes the
   * document or shows the drawing tools
   */
  limit(next, now) {
    return this.edits || (next.document === now.document && !next.view.drawing) ? next : now;
  }

  /**
   * Opens the document of a lesson's step, unless the address holds a document.
   * @param {import("assur/app/page.js").Page} page
   */
  async begin(page) {
    const entry = LESSONS.find(({ id }) => id === this.#given.lesson);
    if (!entry || addressed(location.href) !== "") return;
    const { begin } = await import("assur/lesson/begin.js");
    await begin(page, entry, Number(this.#given.step ?? 1));
  }
}
