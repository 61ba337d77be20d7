// Fields of the form for a lecturer's lesson: how each is read from the lesson, and how typing into it changes the lesson.
import { parseNumber } from "assur/core/numbers.js";
import { changed, withStep } from "assur/lesson/steps.js";

/**
 * @typedef {import("assur/lesson/steps.js").Written} Written
 * @typedef {import("assur/lesson/steps.js").Step} Step
 * @typedef {import("assur/lesson/steps.js").Question} Question
 * @typedef {Readonly<{
 *   id: string, of: "lesson" | "step" | "question", sorts?: readonly string[], rows?: number, most?: number, numeric?: boolean,
 *   get: (lesson: Written, step: Step) => string | number | null | undefined,
 *   put: (lesson: Written, index: number, value: any) => Written,
 * }>} FormField
 * `of`: what the field describes. `sorts`: kinds of question that have the field, by default all. `rows`: height of the field in lines, for longer text.
 * `most`: greatest number of characters. `numeric`: whether the field holds a number. `get`: reads the field. `put`: changes the lesson.
 */

/**
 * @param {Written} lesson
 * @param {number} index
 * @param {Partial<Question>} change
 */
function withQuestion(lesson, index, change) {
  const { question } = lesson.steps[index];
  return question ? withStep(lesson, index, { question: changed(question, change) }) : lesson;
}

/**
 * @template {"number" | "reach" | "choice"} P
 * @param {P} part
 * @param {Written} lesson
 * @param {number} index
 * @param {Partial<NonNullable<Question[P]>>} change
 */
function withPart(part, lesson, index, change) {
  const now = lesson.steps[index].question?.[part];
  return now ? withQuestion(lesson, index, /** @type {Partial<Question>} */ ({ [part]: changed(/** @type {object} */ (now), change) })) : lesson;
}

/** @param {string} text */
const given = (text) => (text === "" ? undefined : text);

/** @type {readonly FormField[]} */
export const FIELDS = Object.freeze(/** @type {FormField[]} */ ([
  { id: "title", of: "lesson", most: 200, get: ({ title }) => title, put: (lesson, _, title) => ({ ...lesson, title }) },
  { id: "author", of: "lesson", most: 200, get: ({ author }) => author, put: (lesson, _, author) => changed(lesson, { author: given(author) }) },
  { id: "step_title", of: "step", most: 200, get: (_, { title }) => title, put: (lesson, i, title) => withStep(lesson, i, { title }) },
  { id: "text", of: "step", rows: 6, most: 5000, get: (_, { text }) => text, put: (lesson, i, text) => withStep(lesson, i, { text }) },
  { id: "formula", of: "step", rows: 2, most: 1000, get: (_, { formula }) => formula, put: (lesson, i, formula) => withStep(lesson, i, { formula: given(formula) }) },
  { id: "asked", of: "question", rows: 2, most: 500, get: (_, { question }) => question?.text, put: (lesson, i, text) => withQuestion(lesson, i, { text }) },
  { id: "at", of: "question", sorts: ["number"], numeric: true, get: (_, { question }) => question?.number?.at, put: (lesson, i, at) => withPart("number", lesson, i, { at }) },
  { id: "value", of: "question", sorts: ["fixed"], numeric: true, get: (_, { question }) => question?.number?.value, put: (lesson, i, value) => withPart("number", lesson, i, { value }) },
  { id: "unit_of", of: "question", sorts: ["fixed"], most: 200, get: (_, { question }) => question?.number?.unit, put: (lesson, i, unit) => withPart("number", lesson, i, { unit: given(unit) }) },
  { id: "target", of: "question", sorts: ["reach"], numeric: true, get: (_, { question }) => question?.reach?.value, put: (lesson, i, value) => withPart("reach", lesson, i, { value }) },
  {
    id: "within", of: "question", sorts: ["number", "fixed", "reach"], numeric: true,
    get: (_, { question }) => (question?.number ?? question?.reach)?.within,
    put: (lesson, i, within) => withPart("number", withPart("reach", lesson, i, { within }), i, { within }),
  },
  {
    id: "options", of: "question", sorts: ["choice"], rows: 3, most: 4000, get: (_, { question }) => question?.choice?.options.join("\n"),
    put: (lesson, i, text) => {
      const options = /** @type {string} */ (text).split("\n");
      const answer = Math.min(lesson.steps[i].question?.choice?.answer ?? 0, options.length - 1);
      return withPart("choice", lesson, i, { options, answer });
    },
  },
  { id: "hint", of: "question", rows: 2, most: 500, get: (_, { question }) => question?.hint, put: (lesson, i, hint) => withQuestion(lesson, i, { hint: given(hint) }) },
]));

/**
 * @param {FormField} field
 * @param {string} text typed text
 * @returns {{ value: string | number | undefined } | null} null if the field holds a number but the text is not one
 */
export function valueTyped({ id, numeric }, text) {
  if (!numeric) return { value: text };
  // The input at which a quantity is asked for is optional.
  if (id === "at" && text.trim() === "") return { value: undefined };
  const value = parseNumber(text);
  return value === null ? null : { value };
}

/**
 * @param {Written} lesson
 * @param {number} index
 * @param {string} quantity quantity asked for, or to be brought to a value
 */
export function withQuantity(lesson, index, quantity) {
  return withPart("number", withPart("reach", lesson, index, { quantity }), index, { quantity });
}

/**
 * @param {Written} lesson
 * @param {number} index
 * @param {number} answer index of the right option
 */
export function withRight(lesson, index, answer) {
  return withPart("choice", lesson, index, { answer });
}

/**
 * @param {Written} lesson
 * @param {number} index
 * @param {boolean} shown whether the page shows the quantity during the question
 */
export function withShown(lesson, index, shown) {
  return withPart("number", lesson, index, { shown: shown || undefined });
}
