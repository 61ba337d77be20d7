// A lesson step by step: a text, something to show, a question with a checked answer. Loaded when a lesson is opened.
import { degrees } from "assur/core/angles.js";
import { make, write } from "assur/core/dom.js";
import { parseNumber } from "assur/core/numbers.js";
import { withSubscripts } from "assur/core/subscripts.js";
import { SWITCHES, withDocument, withView } from "assur/state/state.js";

/**
 * @typedef {import("assur/state/state.js").Kind} Kind
 * @typedef {import("assur/state/model.js").Snapshot} Snapshot
 * @typedef {import("assur/state/state.js").State} State
 * @typedef {import("assur/core/numbers.js").Numbers} Numbers
 * @typedef {import("assur/core/words.js").Words} Words
 */

/**
 * @template {Kind} K
 * @typedef {import("assur/state/state.js").Presets[K]} Preset
 */

/**
 * @template {Kind} K
 * @typedef {import("assur/engine.js").Summaries[K]} Summary
 */

/**
 * @template {Kind} K
 * @typedef {Readonly<{
 *   name?: string, preset: string, change?: (document: Preset<K>) => Preset<K>, play?: boolean, overlays?: readonly string[],
 *   at?: (summary: Summary<K>) => number | undefined,
 * }>} Show
 * What a button sets: a preset, or a change of it, the crank's angle in it or its motion, and what is laid over the drawing. The words of the
 * button are `ID.show.NAME`, or "Show it".
 */

/**
 * @template {Kind} K
 * @typedef {Readonly<{
 *   answer: (summary: Summary<K>) => number | string | undefined,
 *   within?: number, unit?: string, round?: boolean, whole?: boolean, choices?: readonly string[],
 *   places?: (summary: Summary<K>) => Readonly<Record<string, number>>,
 * }>} Question
 * `answer`: what the engine says of the mechanism as it is; undefined where it says nothing. One of the `choices`, or a number
 * to be met `within` a tolerance; `round`: 360° more or less is the same; `whole`: it counts, and `ID.right` has plural forms.
 */

/**
 * @template {Kind} K
 * @typedef {Readonly<{
 *   id: string, formula: string | ((numbers: Numbers) => string), shows: readonly Show<K>[], question: Question<K>, errata?: string,
 * }>} Step
 * `formula`: one with a number in it is written with the reader's decimal sign; `errata`: the lesson whose paper's misprints concern the step.
 */

/**
 * @template {Kind} K
 * @typedef {Readonly<{
 *   store: import("assur/state/store.js").Store<State>,
 *   model: import("assur/state/model.js").Model,
 *   history: import("assur/state/history.js").History,
 *   presets: readonly Readonly<{ id: string, document: Preset<K> }>[],
 * }>} Parts
 */

/**
 * @typedef {"right" | "not_yet" | "unread" | "unanswered" | "none" | "stale"} Verdict
 * @typedef {{ given: string, verdict: Verdict | null, document: State["document"] | null }} Answer
 */

/** @template {Kind} K of mechanism the lesson is about */
export class LessonPanel {
  #steps;
  #parts;
  /** @type {Words} */
  #words;
  /** @type {Snapshot | null} */
  #snapshot = null;
  /** @type {Map<Step<K>, Answer>} what was answered, and the mechanism it was said of */
  #answers = new Map();
  /** @type {Set<Step<K>>} */
  #solved = new Set();
  /** @type {readonly unknown[]} step and words that are shown */
  #shown = [];

  #back = make("button", { id: "lesson-back", class: "control icon", type: "button" }, ["‹"]);
  #on = make("button", { id: "lesson-on", class: "control icon", type: "button" }, ["›"]);
  #progress = make("p", { id: "lesson-progress", role: "status" });
  #title = make("h2", { id: "lesson-title", tabindex: "-1" });
  #text = make("div", { class: "lesson-text" });
  #shows = make("div", { class: "segments" });
  #errata = make("button", { id: "lesson-errata", class: "control add", type: "button" });
  #legend = make("legend", { id: "lesson-question" });
  #fields = make("div", { class: "choices" });
  #check = make("button", { id: "lesson-check", class: "control" });
  #said = make("p", { id: "lesson-said", role: "status" });

  /**
   * @param {HTMLElement} place
   * @param {readonly Step<K>[]} steps
   * @param {Parts<K>} parts
   * @param {Words} words those of the panel and of the lesson
   */
  constructor(place, steps, parts, words) {
    this.#steps = steps;
    this.#parts = parts;
    this.#words = words;
    const form = make("form", { autocomplete: "off" }, [make("fieldset", {}, [this.#legend, this.#fields]), this.#check, this.#said]);
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      this.#answer();
    });
    this.#back.addEventListener("click", () => this.#go(-1));
    this.#on.addEventListener("click", () => this.#go(1));
    this.#errata.addEventListener("click", async () => {
      const { openErrata } = await import("assur/lesson/errata.js");
      await openErrata(this.#step.errata ?? "", this.#words.lang);
    });
    const walk = make("div", { class: "lesson-walk" }, [this.#back, this.#progress, this.#on]);
    place.replaceChildren(walk, this.#title, this.#text, this.#shows, this.#errata, form);
  }

  /** @param {Words} words */
  speak(words) {
    this.#words = words;
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
    // What was said of another mechanism no longer holds.
    const answer = this.#answers.get(this.#steps[number - 1]);
    if (answer?.verdict && answer.document !== snapshot.state.document) {
      answer.verdict = null;
      this.#say();
    }
  }

  /**
   * A link may hold a step that the lesson has no more: the last is open.
   * @param {State} state
   */
  #number({ view }) {
    return Math.min(view.lesson?.step ?? 1, this.#steps.length);
  }

  get #step() {
    return this.#steps[this.#number(this.#parts.store.get()) - 1];
  }

  /** @param {number} by */
  #go(by) {
    this.#parts.store.update((state) => {
      const { lesson } = state.view;
      return lesson ? withView(state, { lesson: { ...lesson, step: this.#number(state) + by } }) : state;
    });
  }

  /** @param {number} number */
  #write(number) {
    const words = this.#words;
    const { id, formula, shows, question, errata } = this.#steps[number - 1];
    this.#back.ariaLabel = this.#back.title = words.text("back");
    this.#on.ariaLabel = this.#on.title = words.text("on");
    // A button that leads no farther gives the focus to its twin, else it would be lost.
    const focused = document.activeElement;
    this.#back.disabled = number === 1;
    this.#on.disabled = number === this.#steps.length;
    if (focused === this.#back && this.#back.disabled) this.#on.focus();
    if (focused === this.#on && this.#on.disabled) this.#back.focus();

    write(this.#title, words.text(`${id}.title`));
    const paragraphs = words.text(`${id}.text`).split("\n").map((text) => make("p", {}, withSubscripts(text)));
    this.#text.replaceChildren(...paragraphs, make("p", { class: "formula" }, withSubscripts(typeof formula === "string" ? formula : formula(words.numbers))));
    this.#shows.replaceChildren(...shows.map((show) => {
      const text = words.text(show.name ? `${id}.show.${show.name}` : "show");
      const button = make("button", { id: `lesson-show${show.name ? `-${show.name}` : ""}`, class: "segment", type: "button" }, [text]);
      button.addEventListener("click", () => this.#show(show));
      return button;
    }));
    write(this.#errata, words.text("errata"));
    this.#errata.hidden = !errata;
    const within = question.within ? ` ${words.text("within", { value: words.numbers.upTo(question.within, 3) + (question.unit ?? "") })}` : "";
    write(this.#legend, words.text(`${id}.question`) + within);
    this.#fields.replaceChildren(...this.#inputs());
    write(this.#check, words.text("check"));
    this.#say();
  }

  /** @returns {HTMLElement[]} what the answer is given in */
  #inputs() {
    const step = this.#step;
    const { choices, unit } = step.question;
    const given = this.#answers.get(step)?.given ?? "";
    const note = (/** @type {HTMLInputElement} */ input) => {
      this.#answers.set(step, { given: input.value, verdict: null, document: null });
      this.#say();
    };
    if (!choices) {
      const input = make("input", {
        id: "lesson-answer", class: "control number", type: "text", inputmode: "decimal", spellcheck: "false",
        "aria-labelledby": "lesson-question", "aria-describedby": "lesson-said",
      });
      input.value = given;
      input.addEventListener("input", () => note(input));
      return [make("div", { class: "lesson-answer" }, [input, unit ?? ""])];
    }
    return choices.map((choice) => {
      const input = make("input", { id: `lesson-${choice}`, type: "radio", name: "lesson-choice", value: choice });
      input.checked = choice === given;
      input.addEventListener("change", () => note(input));
      return make("label", { class: "choice" }, [input, this.#words.text(`${step.id}.choice.${choice}`)]);
    });
  }

  /** @param {Show<K>} show */
  #show({ preset, change = (document) => document, play = false, overlays = ["traces"], at }) {
    const { store, model, history, presets } = this.#parts;
    const document = presets.find(({ id }) => id === preset)?.document;
    if (!document) return;
    const shown = Object.fromEntries(SWITCHES.map((name) => [name, overlays.includes(name)]));
    /** @type {Pick<State["view"], "plot" | "axes">} the plots that the words are about */
    const plots = { plot: "angles", axes: "analogues" };
    history.step(() => {
      store.update((state) => withDocument(state, change(document)));
      // Where the crank goes is known once the engine has taken the mechanism.
      model.follow(store.get());
      const phi = at?.(/** @type {Summary<K>} */ (model.summary));
      const place = phi === undefined ? {} : { phi_deg: degrees(phi) };
      store.update((state) => withView(state, { ...shown, ...plots, ...place, playing: play }));
    });
  }

  #answer() {
    const step = this.#step;
    if (!this.#snapshot) return;
    const given = this.#answers.get(step)?.given ?? "";
    const verdict = judge(step.question, given, this.#snapshot);
    this.#answers.set(step, { given, verdict, document: this.#snapshot.state.document });
    if (verdict === "right") this.#solved.add(step);
    this.#say();
  }

  /** Writes progress and what is said of the answer. */
  #say() {
    const words = this.#words;
    const step = this.#step;
    const [number, count] = [this.#steps.indexOf(step) + 1, this.#steps.length].map((one) => words.numbers.exact(one));
    const solved = this.#solved.size > 0 ? `, ${words.counted("solved", this.#solved.size)}` : "";
    write(this.#progress, words.text("progress", { number, count }) + solved);
    const verdict = this.#answers.get(step)?.verdict ?? null;
    this.#said.dataset.verdict = verdict ?? "";
    write(this.#said, verdict ? [words.text(verdict), this.#reason(step, verdict)].join(" ") : "");
  }

  /**
   * @param {Step<K>} step
   * @param {Verdict} verdict
   */
  #reason({ id, question }, verdict) {
    const words = this.#words;
    if (verdict === "not_yet") return words.text(`${id}.hint`);
    if (verdict !== "right" || !this.#snapshot) return "";
    const summary = /** @type {Summary<K>} */ (this.#snapshot.summary);
    const exact = question.answer(summary);
    if (typeof exact !== "number") return words.text(`${id}.right`);
    const places = Object.entries(question.places?.(summary) ?? {}).map(([name, value]) => [name, words.numbers.exact(value)]);
    if (question.whole) return words.counted(`${id}.right`, exact, Object.fromEntries(places));
    return words.text(`${id}.right`, { value: words.numbers.upTo(exact, 3) + (question.unit ?? "") });
  }
}

/**
 * @template {Kind} K
 * @param {Question<K>} question
 * @param {string} given
 * @param {Snapshot} snapshot
 * @returns {Verdict}
 */
function judge({ answer, choices, within = 0, round = false }, given, { summary, stale }) {
  if (stale) return "stale";
  const exact = answer(/** @type {Summary<K>} */ (summary));
  if (exact === undefined) return "none";
  if (typeof exact === "string") {
    if (!choices?.includes(given)) return "unanswered";
    return given === exact ? "right" : "not_yet";
  }
  const value = parseNumber(given);
  if (value === null) return "unread";
  const off = value - exact;
  const turns = round ? 360 * Math.round(off / 360) : 0;
  return Math.abs(off - turns) <= within ? "right" : "not_yet";
}
