// Worksheets and answer sheets of a lecturer's lesson, one for each name with its own numbers, from the same source.
import { Transform } from "assur/canvas/transform.js";
import { fieldName } from "assur/controls/problems.js";
import { make } from "assur/core/dom.js";
import { attempt } from "assur/core/problem.js";
import { withSubscripts } from "assur/core/subscripts.js";
import { paperTheme, toSvgElement } from "assur/export/pictures.js";
import { answerOf, isAngle, taskOf } from "assur/lesson/tasks.js";
import { Figure } from "assur/stage/figure.js";
import { alone } from "assur/state/state.js";

/**
 * @typedef {import("assur/app/page.js").Page} Page
 * @typedef {import("assur/core/words.js").Words} Words
 * @typedef {import("assur/state/state.js").Written} Written
 */

/** Of a drawing, in pixels. */
const SIZE = Object.freeze({ width: 460, height: 260 });
const MARGIN = 16;

/**
 * @param {Written} lesson
 * @param {readonly string[]} names without any, one sheet with a line to write a name on
 * @param {boolean} answers whether they stand there, instead of room for them
 * @param {Page} page
 * @param {Words} words
 * @returns {HTMLElement} what is to be printed
 */
export function sheets(lesson, names, answers, page, words) {
  const all = names.length > 0 ? names : [""];
  return make("section", { id: "worksheet", class: "paper", lang: words.lang }, all.map((name) => sheet(lesson, name, answers, page, words)));
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
  const { title, text, formula = "", shows, question } = lesson.steps[index];
  const parts = [make("b", {}, [title]), ...text.split("\n").map((line) => make("p", {}, withSubscripts(line)))];
  if (formula) parts.push(make("p", { class: "formula" }, withSubscripts(formula)));
  if (shows) parts.push(...shown(lesson, index, name, page, words));
  if (question) {
    const { number, choice } = question;
    const tolerance = number?.within ? ` ${words.text("lesson.within", { value: words.numbers.upTo(number.within, 6) + unitOf(number) })}` : "";
    parts.push(make("p", {}, [make("b", {}, withSubscripts(question.text + tolerance))]));
    parts.push(...(choice ? choice.options.map((option) => make("p", { class: "choice" }, withSubscripts(option))) : [make("p", { class: "blank" }), make("p", { class: "blank" })]));
  }
  return make("li", {}, parts);
}

/**
 * @param {Written} lesson
 * @param {number} index
 * @param {string} name
 * @param {Page} page
 * @param {Words} words
 */
function answered(lesson, index, name, page, words) {
  const { title, question } = lesson.steps[index];
  const { number, choice, reach } = question ?? {};
  const value = (/** @type {number} */ exact, unit = "") => words.numbers.upTo(exact, 4) + unit;
  const exact = number ? answerOf(lesson, index, name, page.engine) : null;
  const said = exact !== null && number ? value(exact, unitOf(number))
    : choice ? choice.options[choice.answer]
    : reach ? `${reach.quantity} = ${value(reach.value, isAngle(reach.quantity) || reach.quantity === "input" ? "°" : "")}` : "—";
  return make("li", {}, [make("b", {}, [title]), make("p", { class: "answer" }, withSubscripts(said)), ...own(lesson, index, name, page, words)]);
}

/** @param {NonNullable<NonNullable<Written["steps"][number]["question"]>["number"]>} number */
function unitOf({ quantity, unit }) {
  return unit || (isAngle(quantity ?? "") || quantity === "input" ? "°" : "");
}

/**
 * @param {Written} lesson
 * @param {number} index
 * @param {string} name
 * @param {Page} page
 * @param {Words} words
 * @returns {HTMLElement[]} the drawing of what a step shows, and the reader's own dimensions
 */
function shown(lesson, index, name, page, words) {
  const { engine, model: { coordinate } } = page;
  const task = taskOf(lesson, index, name, engine);
  const sketch = task && attempt(() => engine.sketch(alone(task.state))).value;
  if (!sketch) return own(lesson, index, name, page, words);
  const { bounds, scene, frame, labels } = sketch;
  const theme = paperTheme(engine.roles);
  /** @type {import("assur/export/pictures.js").Picture["paint"]} */
  const paint = (target, its, newPath) => {
    const figure = new Figure({ roles: engine.roles, labels }, its, newPath);
    figure.take({ scene, frame, frameInput: 0, coordinate, readouts: null, revision: 1, words });
    const view = Transform.fit(bounds, SIZE.width, SIZE.height, MARGIN);
    figure.paintStill(target, view);
    figure.paintMoving(target, view);
    figure.paintLabels(target, view, SIZE, true);
  };
  const svg = toSvgElement({ size: SIZE, paint }, theme, lesson.steps[index].title);
  return [make("figure", {}, [svg]), ...own(lesson, index, name, page, words)];
}

/**
 * @param {Written} lesson
 * @param {number} index
 * @param {string} name
 * @param {Page} page
 * @param {Words} words
 */
function own(lesson, index, name, { engine }, words) {
  const task = lesson.steps[index].shows ? taskOf(lesson, index, name, engine) : null;
  return (task?.own ?? []).map(({ field, value }) => make("p", { class: "own" }, [`${fieldName(field, words, task?.state.document)} = ${words.numbers.exact(value)}`]));
}
