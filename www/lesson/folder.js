// A lesson that comes with the page, from its folder: its steps and questions in the reader's language.
import { LOST } from "assur/app/notices.js";
import { parseNumber } from "assur/core/numbers.js";
import { notesOf, served } from "assur/core/served.js";
import { measured } from "assur/core/units.js";
import { END } from "assur/lesson/panel.js";
import { withTolerance } from "assur/lesson/quantity.js";
import { holds, open } from "assur/lesson/show.js";

/**
 * @typedef {import("assur/state/state.js").Kind} Kind
 * @typedef {import("assur/state/model.js").AnySnapshot} Snapshot
 * @typedef {import("assur/engine.js").Engine} Engine
 * @typedef {import("assur/state/details.js").Summaries} Summaries
 * @typedef {import("assur/lesson/panel.js").Figure} Figure
 * @typedef {import("assur/core/numbers.js").Numbers} Numbers
 * @typedef {import("assur/core/words.js").Words} Words
 * @typedef {import("assur/lesson/panel.js").Told} Told
 * @typedef {import("assur/lesson/panel.js").Verdict} Verdict
 */

/**
 * @template {Kind} [K=Kind]
 * @typedef {Readonly<{
 *   name?: string, preset: string, set?: Readonly<Record<string, number>>, drive?: string, play?: boolean, overlays?: readonly string[], plot?: string,
 *   omega?: number, at?: (summary: Summaries[K]) => number | undefined,
 * }>} Show
 * A document that a button opens. `name`: the button's text has the key `ID.show.NAME`, where ID is the step's id and
 * NAME is this name; without a name the text is "Show it". `preset`: the document. `set`: changed dimensions, by their
 * names as in `controls`. `drive`: another link to drive. `play`: whether the mechanism moves. `overlays`, `plot`:
 * fields of the view. `omega`: angular velocity of the crank for forces, rad/s. `at`: the input, such as a crank angle.
 */

/**
 * @template {Kind} [K=Kind]
 * @typedef {Readonly<{
 *   answer: (summary: Summaries[K]) => number | string | undefined,
 *   within?: number, unit?: string, round?: boolean, integer?: boolean, choices?: readonly string[],
 *   places?: (summary: Summaries[K]) => Readonly<Record<string, number>>, hides?: readonly string[],
 * }>} Question
 * `answer`: the engine's answer for the current mechanism, a number or one of the `choices`; undefined if there is
 * none. `within`: tolerance of a number. `unit`: unit of the number: a sign, or the name of a unit in the words of the page (`unit.NAME`). `round`: whether a difference of 360° is ignored.
 * `integer`: whether the number is a count, so that `ID.right` has plural forms. `places`: further numbers in
 * `ID.right`, for a count only. `hides`: names of read-outs and quantities that give the answer away. The page hides them until the
 * question is answered or the answer is shown.
 */

/**
 * @template {Kind} [K=Kind]
 * @typedef {Readonly<{
 *   kind?: K, id: string, formula?: string | ((numbers: Numbers) => string), shows: readonly Show<K>[], question: Question<K>, relations?: readonly string[],
 *   controls?: readonly string[], readouts?: readonly string[], lends?: readonly string[], figure?: (engine: Engine) => Figure,
 * }>} Step
 * `kind`: kind of the step's documents, if not the lesson's. `formula`: a function if it contains a number, which is written with the reader's
 * decimal sign. `relations`: ids of the paper's items whose correct formulas the step shows. `controls`: fields of
 * the controls in the step. `readouts`: names of its read-outs. `lends`: ids of the parts of the page that it borrows. `figure`:
 * a figure of its own.
 */

/**
 * @template {Kind} [K=Kind]
 * @typedef {Readonly<{ kind: K, steps: readonly (Step<K> | { [J in Kind]: Step<J> & { kind: J } }[Kind])[] }>} Lesson
 * The export `LESSON` of a lesson's `lesson.js`. Progress is kept under the ids of its steps.
 */

/**
 * @typedef {{ [K in Kind]: Readonly<{ kind: K, document: import("assur/state/state.js").Documents[K] }> }[Kind]} TypedDocument
 * @typedef {Readonly<Record<string, TypedDocument>>} OwnPresets the presets of a lesson's folder, by name
 */

/** Allowance for rounding at the edge of the tolerance, relative to the exact value. */
const ROUNDING = 1e-9;

/** A lesson from a folder, for the panel. */
export class FolderLesson {
  #lesson;
  #presets;
  #page;
  #next;
  #notes;

  /**
   * @param {string} id of the lesson
   * @param {{ kind: Kind, steps: readonly Step[] }} lesson
   * @param {OwnPresets} presets
   * @param {import("assur/app/page.js").Page} page
   * @param {import("assur/lesson/offer.js").Entry} [next] the next lesson
   * @param {readonly import("assur/lesson/paper.js").Item[]} [items] of the lesson's paper
   * @param {boolean} [notes] whether there are notes for teachers
   */
  constructor(id, lesson, presets, page, next, items = [], notes = false) {
    this.id = this.name = id;
    this.paper = { items, main: new Map(lesson.steps.map((step) => [step.id, step.relations ?? []])) };
    this.#lesson = lesson;
    this.#presets = presets;
    this.#page = page;
    this.#next = next;
    this.#notes = notes;
  }

  /**
   * @param {Words} words words of the page and of the lesson
   * @returns {readonly Told[]}
   */
  tell(words) {
    return [...this.#lesson.steps.map((step, index) => this.#step(step, index, words)), this.#end(words)];
  }

  /**
   * Makes the end of the lesson: a summary, and a button for the next lesson or for the gallery.
   * @param {Words} words
   * @returns {Told}
   */
  #end(words) {
    const entry = this.#next;
    const failed = () => this.#page.notices.tell(LOST);
    const further = entry
      ? { text: words.text("lesson.further", { title: words.text(`lessons.${entry.id}.title`) }), open: () => import("assur/lesson/begin.js").then(({ begin }) => begin(this.#page, entry)).catch(failed) }
      : { text: words.text("lesson.gallery"), open: () => import("assur/gallery/gallery.js").then(({ openGallery }) => openGallery(this.#page)).catch(failed) };
    const notes = this.#notes && served() ? [{ id: "lesson-notes", text: words.text("lesson.notes"), open() {}, href: notesOf(this.id, words.lang) }] : [];
    return {
      id: END, title: words.text("lesson.learnt"), text: words.text("learnt"), formula: "", shows: [{ id: "lesson-further", ...further }, ...notes], from: null, question: null,
      tools: {},
    };
  }

  /**
   * @param {Step} step
   * @param {number} index
   * @param {Words} words
   * @returns {Told}
   */
  #step(step, index, words) {
    const { id, formula = "", shows, question } = step;
    const { choices, within, hides = [] } = question;
    const unit = unitIn(question, words);
    return {
      id,
      title: words.text(`${id}.title`),
      text: words.text(`${id}.text`),
      formula: typeof formula === "string" ? formula : formula(words.numbers),
      shows: shows.map((show) => ({
        id: show.name ? `lesson-show-${show.name}` : "lesson-show",
        text: words.text(show.name ? `${id}.show.${show.name}` : "lesson.show"),
        open: (view) => open(show, this.#presets, this.#page, view),
        opened: holds(show, this.#presets, this.#page.engine),
      })),
      from: index,
      tools: step,
      question: {
        text: withTolerance(words.text(`${id}.question`), within, unit, words),
        unit,
        hides,
        options: choices ? choices.map((choice) => ({ value: choice, text: words.text(`${id}.choice.${choice}`) })) : null,
        judge: (given, snapshot) => judge(question, given, snapshot, step.kind ?? this.#lesson.kind),
        hint: () => words.text(`${id}.hint`),
        right: (snapshot) => right(step, snapshot, words),
        answer: (snapshot) => answered(step, snapshot, words),
        ofPage: true,
      },
    };
  }
}

/**
 * @param {Question} question
 * @param {Words} words
 * @returns {string} unit of the answer in the reader's language
 */
function unitIn({ unit = "" }, words) {
  const named = `unit.${unit}`;
  return words.has(named) ? words.text(named) : unit;
}

/**
 * @param {Step} step
 * @param {Snapshot} snapshot
 * @param {Words} words
 * @returns {string} comment on a right answer
 */
function right({ id, question }, { summary }, words) {
  const exact = question.answer(summary);
  if (typeof exact !== "number") return words.text(`${id}.right`);
  const places = Object.entries(question.places?.(summary) ?? {}).map(([name, value]) => [name, words.numbers.exact(value)]);
  if (question.integer) return words.counted(`${id}.right`, exact, Object.fromEntries(places));
  return words.text(`${id}.right`, { value: measured(words.numbers.upTo(exact, 3), unitIn(question, words)) });
}

/**
 * @param {Step} step
 * @param {Snapshot} snapshot of the step's mechanism
 * @param {Words} words
 * @returns {string | null} the right answer in words, null if there is none
 */
function answered({ id, question }, { summary }, words) {
  const exact = question.answer(summary);
  if (exact === undefined || exact === Infinity) return null;
  return typeof exact === "string" ? words.text(`${id}.choice.${exact}`) : measured(words.numbers.upTo(exact, 3), unitIn(question, words));
}

/**
 * @param {Question} question
 * @param {string} given
 * @param {Snapshot} snapshot
 * @param {Kind} asked kind of document that the question is about
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
  return judged(given, exact, within, round);
}

/**
 * @param {string} given
 * @param {number} exact
 * @param {number} within
 * @param {boolean} round whether a difference of 360° does not count
 * @returns {Verdict} verdict on an answer that is a number
 */
export function judged(given, exact, within, round) {
  const value = parseNumber(given);
  if (value === null) return "unread";
  const off = value - exact;
  const turns = round ? 360 * Math.round(off / 360) : 0;
  const rounding = Number.isFinite(exact) ? ROUNDING * Math.max(1, Math.abs(exact)) : 0;
  return Math.abs(off - turns) <= within + rounding ? "right" : "not_yet";
}
