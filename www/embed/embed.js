// The page within another one, as the parameters of its address say (docs/embedding.md): `?embed=stage&edit=no#jansen`. Loaded
// where there is `embed` among them; else the address has no parameters.
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

/** What a parameter may be. */
const VALUES = Object.freeze(/** @type {Record<string, readonly string[] | RegExp>} */ ({
  embed: ["stage", "plots", "lesson", "page"],
  lesson: LESSONS.map(({ id }) => id),
  step: /^[1-9]\d?$/,
  edit: SWITCH,
  bar: SWITCH,
  play: SWITCH,
  lang: LANGUAGES,
}));

/** Commands that change nothing but where the mechanism stands, and those that change the mechanism as well. */
const MOVING = Object.freeze(["play", "back", "forward", "back10", "forward10", "start", "end", "faster", "slower", "reverse", "close"]);
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
    // Steps of lessons ask for changes, and show mechanisms of their own.
    if (given.edit === "no" && (given.embed === "lesson" || given.lesson)) {
      problems.push({ code: "embed_value", name: "edit", value: "no" });
      delete given.edit;
    }
    this.#given = { embed: "stage", ...given };
    this.#problems = problems;
    const { embed, edit = "yes", bar = "yes" } = this.#given;
    for (const [name, value] of Object.entries({ embed, edit, bar })) setData(document.documentElement, name, String(value));
  }

  /** Whether anything may change the mechanism. */
  get edits() {
    return this.#given.edit !== "no";
  }

  /**
   * @param {Habits} habits of the reader
   * @returns {Habits} as the address wants them
   */
  habits({ calm, lang }) {
    return { calm: calm || this.#given.play === "no", lang: this.#given.lang ?? lang, embedding: this };
  }

  /**
   * @param {import("assur/app/opening.js").Opening} opening
   * @param {boolean} calm no motion unasked
   * @returns {Promise<import("assur/app/opening.js").Opening>} the same as the parameters say, with what they cannot say
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
   * @returns {Readonly<Record<string, () => void>>} those that the frame has do something
   */
  commands(commands) {
    const there = new Set([...MOVING, ...(this.edits ? EDITING : [])]);
    const whole = this.#given.embed === "page" && this.edits;
    return Object.fromEntries(Object.entries(commands).map(([name, act]) => [name, whole || there.has(name) ? act : () => {}]));
  }

  /**
   * @param {State} next
   * @param {State} now
   * @returns {State} what a change may come to: where nothing is edited, no other document, and no tools for drawing
   */
  limit(next, now) {
    return this.edits || (next.document === now.document && !next.view.drawing) ? next : now;
  }

  /**
   * A lesson without a mechanism in the address shows that of its step.
   * @param {import("assur/app/page.js").Page} page
   */
  async begin(page) {
    const entry = LESSONS.find(({ id }) => id === this.#given.lesson);
    if (!entry || addressed(location.href) !== "") return;
    const { begin } = await import("assur/lesson/begin.js");
    await begin(page, entry, Number(this.#given.step ?? 1));
  }
}
