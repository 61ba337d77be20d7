// Changes to the steps of a lecturer's lesson.
import { RESTING } from "assur/lesson/tasks.js";
import { contains, usualView } from "assur/state/state.js";

/**
 * @typedef {import("assur/state/state.js").Written} Written
 * @typedef {Written["steps"][number]} Step
 * @typedef {NonNullable<Step["question"]>} Question
 */

/** Fields of the view that a reader chooses and that a step neither stores nor changes. */
export const READERS = Object.freeze(["lang", "lesson", "projector", "drawing"]);

/**
 * @param {import("assur/app/page.js").Page} page
 * @returns {NonNullable<Step["shows"]>} the page's document, and the fields of its view that differ from the defaults
 * and do not belong to the reader
 */
export function shownNow({ model: { lastAccepted: { kind, document, view } } }) {
  const usual = /** @type {Record<string, unknown>} */ (usualView(RESTING));
  const own = Object.entries(view).filter(([key, value]) => !READERS.includes(key) && !contains(usual, { [key]: value }));
  return /** @type {NonNullable<Step["shows"]>} */ ({ kind, document, view: Object.fromEntries(own) });
}

/**
 * @template {object} T
 * @param {T} object
 * @param {Partial<T>} change
 * @returns {T} the changed object without the entries that are undefined or null
 */
export function changed(object, change) {
  const entries = Object.entries({ ...object, ...change });
  return /** @type {T} */ (Object.fromEntries(entries.filter(([, value]) => value !== undefined && value !== null)));
}

/**
 * @param {Written} lesson
 * @param {number} index
 * @param {Partial<Step>} change
 * @returns {Written}
 */
export function withStep(lesson, index, change) {
  return { ...lesson, steps: lesson.steps.map((step, i) => (i === index ? changed(step, change) : step)) };
}

/**
 * @param {Written} lesson
 * @param {number} index index of the step before the new one
 * @returns {Written}
 */
export function withNewStep(lesson, index) {
  return { ...lesson, steps: lesson.steps.toSpliced(index + 1, 0, { title: "", text: "" }) };
}

/**
 * @param {Written} lesson
 * @param {number} index index of the step to remove; the only step of a lesson is emptied instead
 * @returns {Written}
 */
export function withoutStep(lesson, index) {
  const steps = lesson.steps.toSpliced(index, 1);
  return { ...lesson, steps: steps.length > 0 ? steps : [{ title: "", text: "" }] };
}

/**
 * @param {Written} lesson
 * @param {number} index
 * @param {1 | -1} by
 * @returns {Written} the lesson with the step moved
 */
export function withMoved(lesson, index, by) {
  const step = lesson.steps[index];
  return { ...lesson, steps: lesson.steps.toSpliced(index, 1).toSpliced(index + by, 0, step) };
}

/** A new question of each kind, made from the text and hint of the old question. */
export const QUESTIONS = Object.freeze(/** @type {Record<string, (text: string, hint: string | undefined, quantity: string) => Question | undefined>} */ ({
  none: () => undefined,
  number: (text, hint, quantity) => changed(/** @type {Question} */ ({ text, hint, number: { quantity, within: 0.1 } }), {}),
  fixed: (text, hint) => changed(/** @type {Question} */ ({ text, hint, number: { value: 0, within: 0.1 } }), {}),
  choice: (text, hint) => changed(/** @type {Question} */ ({ text, hint, choice: { options: ["1", "2"], answer: 0 } }), {}),
  reach: (text, hint, quantity) => changed(/** @type {Question} */ ({ text, hint, reach: { quantity, value: 0, within: 1 } }), {}),
}));

/**
 * @param {Question | null | undefined} question
 * @returns {string} the question's kind, a key of {@link QUESTIONS}
 */
export function sortOf(question) {
  if (question?.choice) return "choice";
  if (question?.reach) return "reach";
  if (!question?.number) return "none";
  return question.number.quantity ? "number" : "fixed";
}
