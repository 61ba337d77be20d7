// The verdict on an answer in a lecturer's lesson, and the digest that identifies the lesson.
import { parseNumber } from "assur/core/numbers.js";
import { attempt } from "assur/core/problem.js";
import { digest } from "assur/lesson/chance.js";
import { judged } from "assur/lesson/folder.js";
import { isRound } from "assur/lesson/quantity.js";
import { answerOf } from "assur/lesson/tasks.js";

/** @typedef {import("assur/state/state.js").Written} Written */

/** Answer, in a result code, to a question that the reader solves by moving the mechanism to a value. */
export const REACHED = "1";

/** Key in the browser's storage for the digest of the lesson last written in this browser. */
export const WRITTEN_HERE = "written-here";

/**
 * @param {Written} lesson
 * @param {import("assur/engine.js").Engine} engine
 * @returns {string} digest that identifies the lesson, whatever the notation of its file
 */
export function digestOf(lesson, engine) {
  return digest(attempt(() => engine.functions.readLesson(lesson)).value ?? lesson);
}

/**
 * @param {Written} lesson
 * @param {number} index of a step with a question
 * @param {string} given
 * @param {string} name name of the reader who gave the answer
 * @param {import("assur/engine.js").Engine} engine
 * @returns {import("assur/lesson/panel.js").Verdict}
 */
export function verdictOn(lesson, index, given, name, engine) {
  return verdictOf(lesson.steps[index].question, given, () => attempt(() => answerOf(lesson, index, name, engine)).value ?? null);
}

/**
 * @param {Written["steps"][number]["question"]} question
 * @param {string} given
 * @param {() => number | null} answer returns the right number, null if there is none
 * @returns {import("assur/lesson/panel.js").Verdict}
 */
export function verdictOf(question, given, answer) {
  const { number, choice } = question ?? {};
  if (choice) {
    if (given === "") return "unanswered";
    return given === String(choice.answer) ? "right" : "not_yet";
  }
  if (!number) return given === REACHED ? "right" : "not_yet";
  if (parseNumber(given) === null) return "unread";
  const exact = answer();
  return exact === null ? "none" : judged(given, exact, number.within, isRound(number.quantity ?? ""));
}
