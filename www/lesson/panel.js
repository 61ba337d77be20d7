// A lesson step by step: a text, something to show, a question with a checked answer. Loaded when a lesson is opened.
import { make, write } from "assur/core/dom.js";
import { parseNumber } from "assur/core/numbers.js";
import { withSubscripts } from "assur/core/subscripts.js";
import { Progress } from "assur/lesson/progress.js";
import { open } from "assur/lesson/show.js";
import { Tools } from "assur/lesson/tools.js";
import { withView } from "assur/state/state.js";

/**
 * @typedef {import("assur/state/state.js").Documents} Documents
 * @typedef {import("assur/state/state.js").Kind} Kind
 * @typedef {import("assur/state/model.js").AnySnapshot} Snapshot
 * @typedef {import("assur/state/state.js").State} State
 * @typedef {import("assur/engine.js").Summaries} Summaries
 * @typedef {import("assur/core/numbers.js").Numbers} Numbers
 * @typedef {import("assur/core/words.js").Words} Words
 */

/**
 * @template {Kind} [K=Kind]
 * @typedef {Readonly<{
 *   name?: string, preset: string, set?: Readonly<Record<string, number>>, drive?: string, play?: boolean, overlays?: readonly string[], plot?: string,
 *   at?: (summary: Summaries[K]) => number | undefined,
 * }>} Show
 * What a button opens instead of the document there is: a preset, with dimensions `set` (by their names, as in `controls`) or another link
 * to `drive` it, the crank's angle in it or its motion, what is laid over the drawing, and what is plotted. The words of the button are `ID.show.NAME`, or "Show it".
 */

/**
 * @template {Kind} [K=Kind]
 * @typedef {Readonly<{
 *   answer: (summary: Summaries[K]) => number | string | undefined,
 *   within?: number, unit?: string, round?: boolean, whole?: boolean, choices?: readonly string[],
 *   places?: (summary: Summaries[K]) => Readonly<Record<string, number>>, hides?: readonly string[],
 * }>} Question
 * `answer`: what the engine says of the mechanism as it is; undefined where it says nothing. One of the `choices`, or a number
 * to be met `within` a tolerance; `round`: 360° more or less is the same; `whole`: it counts, and `ID.right` has plural forms;
 * `hides`: the read-outs that tell the answer, which the page withholds until it was given, or the reader gives up.
 */

/**
 * @template {Kind} [K=Kind]
 * @typedef {Readonly<{
 *   kind?: K, id: string, formula: string | ((numbers: Numbers) => string), shows: readonly Show<K>[], question: Question<K>, errata?: boolean,
 *   controls?: readonly string[], readouts?: readonly string[], equations?: boolean,
 * }>} Step
 * `kind`: of the documents that it shows and asks about, where it is not the lesson's; `formula`: one with a number in it is written with
 * the reader's decimal sign; `errata`: misprints of the lesson's paper concern the step. In the step itself stand its `controls`, by their fields, its `readouts`,
 * by what follows `out-` in their ids, and the constraint `equations`.
 */

/**
 * @template {Kind} [K=Kind]
 * @typedef {Readonly<{ kind: K, steps: readonly (Step<K> | { [J in Kind]: Step<J> & { kind: J } }[Kind])[] }>} Lesson
 * What `lesson.js` of a lesson's folder exports as `LESSON`. Steps are told apart by their ids, which progress is kept by.
 */

/**
 * @typedef {{ [K in Kind]: Readonly<{ kind: K, document: Documents[K] }> }[Kind]} Whole
 * @typedef {Readonly<Record<string, Whole>>} OwnPresets what `presets.json` of a lesson's folder holds, by name
 *
 * @typedef {"right" | "not_yet" | "unread" | "unanswered" | "none" | "stale"} Verdict
 * @typedef {{ verdict: Verdict, document: State["document"] }} Judged the document that the verdict was given of
 * @typedef {Readonly<{ title: string, text: string, choices: readonly string[] }>} Asked a question, with what may be chosen
 */

export class LessonPanel {
  #page;
  #id;
  #kind;
  #steps;
  #presets;
  #progress;
  /** @type {Words} */
  #words;
  /** @type {Snapshot | null} */
  #snapshot = null;
  /** @type {Map<Step, Judged>} */
  #judged = new Map();
  /** @type {readonly unknown[]} step and words that are shown */
  #shown = [];

  #back = make("button", { id: "lesson-back", class: "control icon", type: "button" }, ["‹"]);
  #on = make("button", { id: "lesson-on", class: "control icon", type: "button" }, ["›"]);
  #walked = make("p", { id: "lesson-progress", role: "status" });
  #title = make("h2", { id: "lesson-title", tabindex: "-1" });
  #text = make("div", { class: "lesson-text" });
  #shows = make("div", { class: "segments" });
  #errata = make("button", { id: "lesson-errata", class: "control add", type: "button" });
  #legend = make("legend", { id: "lesson-question" });
  #fields = make("div", { class: "choices" });
  #check = make("button", { id: "lesson-check", class: "control" });
  #reveal = make("button", { id: "lesson-reveal", class: "control", type: "button" });
  #said = make("p", { id: "lesson-said", role: "status" });
  #tools = new Tools();
  /** @type {Set<Step>} those of which the reader has asked to see the answer */
  #revealed = new Set();

  /**
   * @param {HTMLElement} place
   * @param {import("assur/app/page.js").Page} page
   * @param {string} id of the lesson
   * @param {{ kind: Kind, steps: readonly Step[] }} lesson
   * @param {OwnPresets} presets
   * @param {Words} words of the page, and those of the lesson
   */
  constructor(place, page, id, { kind, steps }, presets, words) {
    this.#page = page;
    this.#id = id;
    this.#kind = kind;
    this.#steps = steps;
    this.#presets = presets;
    this.#progress = new Progress(id, steps);
    this.#words = words;
    const form = make("form", { autocomplete: "off" }, [make("fieldset", {}, [this.#legend, this.#fields]), make("div", { class: "lesson-buttons" }, [this.#check, this.#reveal]), this.#said]);
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      this.#answer();
    });
    this.#back.addEventListener("click", () => this.#go(-1));
    this.#on.addEventListener("click", () => this.#go(1));
    this.#errata.addEventListener("click", async () => {
      const { openErrata } = await import("assur/lesson/errata.js");
      await openErrata(this.#id, this.#words.lang);
    });
    this.#reveal.addEventListener("click", () => {
      this.#revealed.add(this.#step);
      this.#withhold();
      this.#check.focus();
    });
    const walk = make("div", { class: "lesson-walk" }, [this.#back, this.#walked, this.#on]);
    place.replaceChildren(walk, this.#title, this.#text, this.#shows, this.#tools.element, this.#errata, form);
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
  }

  /** @returns {Asked[]} */
  questions() {
    const words = this.#words;
    return this.#steps.map(({ id, question }) => ({
      title: words.text(`${id}.title`),
      text: this.#asked(id, question),
      choices: (question.choices ?? []).map((choice) => words.text(`${id}.choice.${choice}`)),
    }));
  }

  /**
   * @param {string} id
   * @param {Question} question
   */
  #asked(id, { within, unit = "" }) {
    const words = this.#words;
    const tolerance = within ? ` ${words.text("lesson.within", { value: words.numbers.upTo(within, 3) + unit })}` : "";
    return words.text(`${id}.question`) + tolerance;
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
    const judged = this.#judged.get(step);
    if (judged && judged.document !== snapshot.state.document) {
      this.#judged.delete(step);
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
    return this.#steps[this.#number(this.#page.store.get()) - 1];
  }

  /** @param {number} by */
  #go(by) {
    this.#page.store.update((state) => {
      const { lesson } = state.view;
      return lesson ? withView(state, { lesson: { ...lesson, step: this.#number(state) + by } }) : state;
    });
  }

  /** @param {number} number */
  #write(number) {
    const words = this.#words;
    const step = this.#steps[number - 1];
    const { id, formula, shows, question, errata } = step;
    this.#back.ariaLabel = this.#back.title = words.text("lesson.back");
    this.#on.ariaLabel = this.#on.title = words.text("lesson.on");
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
      const text = words.text(show.name ? `${id}.show.${show.name}` : "lesson.show");
      const button = make("button", { id: `lesson-show${show.name ? `-${show.name}` : ""}`, class: "segment", type: "button" }, [text]);
      button.addEventListener("click", () => this.#show(show));
      return button;
    }));
    write(this.#errata, words.text("lesson.errata"));
    this.#errata.hidden = !errata;
    write(this.#legend, this.#asked(id, question));
    this.#fields.replaceChildren(...this.#inputs());
    write(this.#check, words.text("lesson.check"));
    write(this.#reveal, words.text("lesson.reveal"));
    this.#tools.show(step, () => this.#page.store.get().document);
    this.#withhold();
    this.#say();
  }

  /** Read-outs that tell the answer are withheld until it is given, unless the reader gives up. */
  #withhold() {
    const step = this.#step;
    const open = !this.#progress.isSolved(step.id) && !this.#revealed.has(step);
    const { hides = [] } = step.question;
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

  /** @returns {HTMLElement[]} what the answer is given in */
  #inputs() {
    const step = this.#step;
    const { choices, unit } = step.question;
    const given = this.#progress.given(step.id);
    const note = (/** @type {HTMLInputElement} */ input) => {
      this.#progress.give(step.id, input.value);
      this.#judged.delete(step);
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

  /** @param {Show} show */
  #show(show) {
    open(show, this.#presets, this.#page);
  }

  #answer() {
    const step = this.#step;
    if (!this.#snapshot) return;
    const verdict = judge(step.question, this.#progress.given(step.id), this.#snapshot, step.kind ?? this.#kind);
    this.#judged.set(step, { verdict, document: this.#snapshot.state.document });
    if (verdict === "right") this.#progress.solve(step.id);
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
    const verdict = this.#judged.get(step)?.verdict ?? null;
    this.#said.dataset.verdict = verdict ?? "";
    write(this.#said, verdict ? [words.text(`lesson.${verdict}`), this.#reason(step, verdict)].join(" ") : "");
  }

  /**
   * @param {Step} step
   * @param {Verdict} verdict
   */
  #reason({ id, question }, verdict) {
    const words = this.#words;
    if (verdict === "not_yet") return words.text(`${id}.hint`);
    if (verdict !== "right" || !this.#snapshot) return "";
    const { summary } = this.#snapshot;
    const exact = question.answer(summary);
    if (typeof exact !== "number") return words.text(`${id}.right`);
    const places = Object.entries(question.places?.(summary) ?? {}).map(([name, value]) => [name, words.numbers.exact(value)]);
    if (question.whole) return words.counted(`${id}.right`, exact, Object.fromEntries(places));
    return words.text(`${id}.right`, { value: words.numbers.upTo(exact, 3) + (question.unit ?? "") });
  }
}

/**
 * @param {Question} question
 * @param {string} given
 * @param {Snapshot} snapshot
 * @param {Kind} asked the kind of document that the question is about
 * @returns {Verdict}
 */
function judge({ answer, choices, within = 0, round = false }, given, { summary, stale, kind }, asked) {
  if (stale) return "stale";
  const exact = kind === asked ? answer(summary) : undefined;
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
