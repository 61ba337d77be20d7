// Worksheets and answer sheets of a lecturer's lesson. Each reader has a sheet with their own numbers.
import { Transform } from "assur/canvas/transform.js";
import { fieldName, measuredAs } from "assur/controls/problems.js";
import { make } from "assur/core/dom.js";
import { attempt } from "assur/core/problem.js";
import { marked, withSubscripts } from "assur/core/subscripts.js";
import { measured } from "assur/core/units.js";
import { paperTheme, toSvgElement } from "assur/export/pictures.js";
import { stepOnPaper } from "assur/export/steps.js";
import { given } from "assur/lesson/given.js";
import { quantityName, secrets, toleranceOf, unitIn, withTolerance } from "assur/lesson/quantity.js";
import { answerOf, coordinateOf, taskOf } from "assur/lesson/tasks.js";
import { Figure } from "assur/stage/figure.js";
import { Names, Readouts } from "assur/state/readouts.js";
import { withoutExtras } from "assur/state/state.js";

/**
 * @typedef {import("assur/app/page.js").Page} Page
 * @typedef {import("assur/core/words.js").Words} Words
 * @typedef {import("assur/engine.js").Engine} Engine
 * @typedef {import("assur/lesson/tasks.js").Task} Task
 * @typedef {import("assur/state/state.js").Written} Written
 * @typedef {ReturnType<typeof seenIn>} Seen
 * @typedef {import("assur/lesson/quantity.js").Asked} Asked
 */

/** Size of a drawing, in pixels. */
const SIZE = Object.freeze({ width: 460, height: 260 });
const MARGIN = 16;

/**
 * @param {Written} lesson
 * @param {readonly string[]} names names of the readers; if the list is empty, there is one sheet with a blank for the name
 * @param {boolean} answers true for answer sheets, false for worksheets
 * @param {Page} page
 * @param {Words} words
 * @returns {HTMLElement} element to print
 */
export function sheets(lesson, names, answers, page, words) {
  const all = names.length > 0 ? names : [""];
  return make("section", { id: "worksheet", class: answers ? "paper answers" : "paper", lang: words.lang }, all.map((name) => sheet(lesson, name, answers, page, words)));
}

/**
 * @param {Written} lesson
 * @param {string} name
 * @param {boolean} answers
 * @param {Page} page
 * @param {Words} words
 */
function sheet(lesson, name, answers, page, words) {
  const { title, author = "", steps } = lesson;
  const blank = make("span", { class: "blank" }, [`${words.text("print.name")} ${name}`]);
  return make("article", { class: "sheet" }, [
    make("header", {}, [
      make("h1", {}, [title]),
      ...(author ? [make("p", {}, [author])] : []),
      make("p", { class: "blanks" }, answers ? [make("b", {}, [name]), make("span", {}, [words.text("write.answers")])] : [blank, make("span", { class: "blank" }, [words.text("print.date")])]),
    ]),
    make("ol", {}, steps.map((_, index) => (answers ? answered(lesson, index, name, page, words) : asked(lesson, index, name, page, words)))),
  ]);
}

/**
 * @param {Written} lesson
 * @param {number} index
 * @param {string} name
 * @param {Page} page
 * @param {Words} words
 */
function asked(lesson, index, name, page, words) {
  const { formula = "", shows, question, ...step } = lesson.steps[index];
  const { number, choice } = question ?? {};
  const task = shows || number?.quantity ? taskOf(lesson, index, name, page.engine) : null;
  const seen = seenOf(task, number, page.engine);
  const inUnits = measuredIn(seen, words);
  const shown = shows && task ? [...drawing(seen, lesson.steps[index], page, words), ...own(task, inUnits), numbers(task, page, inUnits)] : [];
  const posed = question ? { text: withTolerance(question.text, toleranceOf(number), unitIn(number, seen, inUnits), words), options: choice?.options ?? [] } : null;
  return stepOnPaper({ ...step, formula, question: posed }, [...shown, ...position(number, seen, inUnits)]);
}

/**
 * @param {Written} lesson
 * @param {number} index
 * @param {string} name
 * @param {Page} page
 * @param {Words} words
 */
function answered(lesson, index, name, page, words) {
  const { title, shows, question } = lesson.steps[index];
  const { number, choice, reach } = question ?? {};
  const value = (/** @type {number} */ exact, unit = "") => measured(words.numbers.upTo(exact, 4), unit);
  const task = shows || number?.quantity || reach ? taskOf(lesson, index, name, page.engine) : null;
  const seen = seenOf(task, number, page.engine);
  const inUnits = measuredIn(seen, words);
  const exact = number ? answerOf(lesson, index, name, page.engine) : null;
  const said = exact !== null ? value(exact, unitIn(number, seen, inUnits))
    : choice ? choice.options[choice.answer]
    : reach ? `${nameOf(reach.quantity, task, seen, page, words)} = ${value(reach.value, unitIn(reach, seen, inUnits))}` : "—";
  return make("li", {}, [make("b", { class: "title" }, [title]), ...(shows && task ? own(task, inUnits) : []), make("p", { class: "answer" }, marked(said))]);
}

/**
 * @param {string} quantity quantity of the step's mechanism or, if there is none, of the page's
 * @param {Task | null} task
 * @param {Seen | null} seen
 * @param {Page} page
 * @param {Words} words
 */
function nameOf(quantity, task, seen, { model, store }, words) {
  const { summary, coordinate } = seen ?? model;
  return quantityName(quantity, { summary, coordinate: coordinate ?? model.coordinate, state: task?.state ?? store.get() }, words);
}

/**
 * @param {Task | null} task
 * @param {Asked | null | undefined} number number asked for
 * @param {Engine} engine
 * @returns {Seen | null} null if the mechanism cannot be drawn
 */
function seenOf(task, number, engine) {
  return task && attempt(() => seenIn(task.state, number?.at ?? null, engine)).value;
}

/**
 * @param {import("assur/state/state.js").State} state
 * @param {number | null} inputShown position of the driver in the reader's unit; null for the position in the state
 * @param {Engine} engine
 * @returns the engine's summary of the state's mechanism, and its drawing with the driver at this position
 */
function seenIn(state, inputShown, engine) {
  return engine.withScratchSimulator((other) => {
    const summary = engine.detailed(other.set(withoutExtras(state)), state);
    const coordinate = summary.moves === null ? null : coordinateOf(summary);
    const frameInput = coordinate ? coordinate.input(inputShown ?? coordinate.of(state)) : 0;
    const { frame, readouts: values } = other.at(frameInput);
    const readouts = Readouts.of(new Names(other.readouts()), values);
    return { state, summary, coordinate, frameInput, frame, readouts, scene: other.scene(), labels: other.labelNames(), lengths: other.lengths() };
  });
}

/**
 * @param {Seen | null} seen
 * @param {Written["steps"][number]} step step that shows the mechanism
 * @param {Page} page
 * @param {Words} words
 * @returns {HTMLElement[]} the drawing, with the values asked for hidden
 */
function drawing(seen, { title, question }, { engine, model }, words) {
  if (!seen) return [];
  const { summary: { bounds }, labels, ...drawn } = seen;
  const theme = paperTheme(engine.roles);
  const withheld = new Set(secrets(question?.number));
  /** @type {import("assur/export/pictures.js").Picture["paint"]} */
  const paint = (target, its, newPath) => {
    const figure = new Figure({ roles: engine.roles, labels }, its, newPath);
    figure.take({ ...drawn, coordinate: drawn.coordinate ?? model.coordinate, revision: 1, words, withheld });
    const view = Transform.fit(bounds, SIZE.width, SIZE.height, MARGIN);
    figure.paintStill(target, view);
    figure.paintMoving(target, view);
    figure.paintLabels(target, view, SIZE, true);
  };
  return [make("figure", {}, [toSvgElement({ size: SIZE, paint }, theme, title)])];
}

/**
 * @param {Task} task
 * @param {Words} words words with the unit of the mechanism's lengths
 * @returns {HTMLElement[]} the reader's own numbers
 */
function own({ own: numbers, state }, words) {
  const valued = (/** @type {Task["own"][number]} */ { field, value }) => measuredAs(field, words.numbers.exact(value), words);
  return numbers.map((one) => make("p", { class: "own" }, [`${fieldName(one.field, words, state.document)} = ${valued(one)}`]));
}

/**
 * @param {Task} task
 * @param {Page} page
 * @param {Words} words words with the unit of the mechanism's lengths
 * @returns {HTMLElement} all numbers given for the mechanism
 */
function numbers({ state }, { engine }, words) {
  return make("p", { class: "given" }, withSubscripts(given(state, engine, words).join("; ")));
}

/**
 * @param {Asked | null | undefined} number number asked for
 * @param {Seen | null} seen
 * @param {Words} words words with the unit of the mechanism's lengths
 * @returns {HTMLElement[]} the position of the driver, if the question gives one
 */
function position(number, seen, words) {
  if (typeof number?.at !== "number" || !seen?.coordinate) return [];
  const { coordinate, frameInput } = seen;
  return [make("p", { class: "given" }, [`${coordinate.symbol} = ${coordinate.short(frameInput, words, 4)}`])];
}

/**
 * @param {Seen | null} seen
 * @param {Words} words
 * @returns {Words} words with the unit of the mechanism's lengths
 */
function measuredIn(seen, words) {
  return words.measured(seen?.lengths ?? "none");
}
