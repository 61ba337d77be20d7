// Notices on shared URLs, files and parts of the page. A failure stays until the reader closes it, a success only some seconds.
import { lossOf, sentence } from "assur/controls/problems.js";
import { byId } from "assur/core/dom.js";
import { html, render } from "assur/core/html.js";

/**
 * @typedef {import("assur/app/opening.js").Failure} Failure
 * @typedef {"copied" | "copied_without" | "result"} Done what was copied: a URL, a URL without the picture, a result
 * @typedef {import("assur/core/words.js").Words} Words
 */

/** @type {readonly Failure[]} a part of the page did not load */
export const LOST = Object.freeze([{ kind: "part", problems: [{ code: "not_arrived" }] }]);

/** @type {readonly Failure[]} a part of the page failed while running */
export const BROKE = Object.freeze([{ kind: "part", problems: [{ code: "part_broke" }] }]);

/** @type {readonly Failure[]} the plots could not be drawn */
export const NO_PLOTS = Object.freeze([{ kind: "part", problems: [{ code: "no_plots" }] }]);

/** @type {readonly Failure[]} the state is too long for a URL */
export const LONG = Object.freeze([{ kind: "link", problems: [{ code: "link_too_long" }] }]);

/** @type {readonly Failure[]} the URL is so long that messaging programs may cut it off */
export const CUT = Object.freeze([{ kind: "link", problems: [{ code: "link_may_be_cut" }] }]);

/** @type {Readonly<Record<"picture" | "state" | "lesson" | "tab", readonly Failure[]>>} the browser did not store the picture behind the drawing, the state, or the answers to a lesson; or it now stores the state of another tab */
export const UNKEPT = Object.freeze({
  picture: [{ kind: "picture", problems: [{ code: "picture_unkept" }] }],
  state: [{ kind: "store", problems: [{ code: "state_unkept" }] }],
  lesson: [{ kind: "store", problems: [{ code: "lesson_unkept" }] }],
  tab: [{ kind: "store", problems: [{ code: "other_tab" }] }],
});

/** Time for which a notice of success is shown, in milliseconds. A notice of a failure stays until it is closed. */
const DONE_PERIOD = 10_000;

export class Notices {
  #container = byId("notice", HTMLElement);
  #text = byId("notice-text", HTMLElement);
  #changed;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #leaving;
  /** @type {readonly (Failure | Done)[]} */
  #told = [];
  /** @type {readonly unknown[]} shown notices and their language */
  #shown = [];

  /** @param {() => void} changed */
  constructor(changed) {
    this.#changed = changed;
    byId("notice-close", HTMLButtonElement).addEventListener("click", () => this.clear());
  }

  /** @param {readonly (Failure | Done)[]} told */
  tell(told) {
    this.#told = told;
    clearTimeout(this.#leaving);
    if (told.length > 0 && told.every(isDone)) this.#leaving = setTimeout(() => this.clear(), DONE_PERIOD);
    this.#changed();
  }

  clear() {
    this.tell([]);
  }

  /** @param {{ words: Words }} snapshot */
  render({ words }) {
    if (this.#shown[0] === this.#told && this.#shown[1] === words) return;
    this.#shown = [this.#told, words];
    const lines = this.#told.map((one) => lineOf(one, words));
    this.#container.hidden = lines.length === 0;
    this.#container.classList.toggle("good", this.#told.every((one) => isDone(one) || one.kind === "import"));
    render(lines.map((line) => html`<p>${line}</p>`), this.#text);
  }
}

/**
 * @param {Failure | Done} one
 * @param {Words} words
 * @returns {string} the sentence that is shown
 */
export function lineOf(one, words) {
  if (isDone(one)) return words.text(`notice.${one}`);
  const say = one.kind === "import" ? lossOf : sentence;
  const why = one.problems.map((problem) => say(problem, words)).join(" ");
  return words.text(`notice.${one.kind}`, { why, name: one.name ?? "" });
}

/**
 * @param {Failure | Done} one
 * @returns {one is Done}
 */
function isDone(one) {
  return typeof one === "string";
}
