// Tests of every step of every lesson of the page: its mechanisms open without a problem, and its answers are judged and written in every language.
import assert from "node:assert/strict";
import { existsSync, readFileSync, readdirSync } from "node:fs";
import test from "node:test";
import { Words } from "assur/core/words.js";
import { FolderLesson, judged } from "assur/lesson/folder.js";
import { wholePresets } from "assur/lesson/offer.js";
import { Page } from "assur/tests/page.js";
import { LANGUAGES, tableOf } from "assur/tests/words.js";

const LESSONS = new URL("../lessons/", import.meta.url);
const read = (path) => JSON.parse(readFileSync(new URL(path, LESSONS), "utf8"));

/** Right answers by lesson and step, and by button if the step's buttons have names. null: no answer is right yet; false: another kind is asked about. */
const LISTS = JSON.parse(readFileSync(new URL("../../tests/data/page/lesson_answers.json", import.meta.url), "utf8"));
const ANSWERS = Object.fromEntries(Object.entries(LISTS).map(([id, steps]) => [id, Object.fromEntries(steps)]));

/**
 * A lesson as the panel receives it, in every language.
 * @param {string} id
 * @param {Page} page
 */
async function told(id, page) {
  const { LESSON } = await import(`assur/lessons/${id}/lesson.js`);
  const presets = existsSync(new URL(`${id}/presets.json`, LESSONS)) ? wholePresets(read(`${id}/presets.json`)) : {};
  const lesson = new FolderLesson(id, LESSON, presets, page);
  const languages = LANGUAGES.map((lang) => new Words(lang, new Map([...tableOf(lang), ...Object.entries(read(`${id}/words.${lang}.json`))])));
  return { LESSON, languages: languages.map((words) => ({ words, steps: lesson.tell(words) })) };
}

/** @param {string} text that a reader is to see */
function checkSaid(text) {
  assert.ok(text.length > 5 && !/[{}]|undefined|NaN/.test(text), text);
}

test("every lesson has its answers here", () => {
  assert.deepEqual(readdirSync(LESSONS), Object.keys(ANSWERS).sort());
});

for (const [id, answers] of Object.entries(ANSWERS)) {
  test(`steps of the lesson ${id} open without a problem and have their answers`, async () => {
    const page = new Page("mixer-a");
    const { LESSON, languages } = await told(id, page);
    assert.deepEqual(LESSON.steps.map((step) => step.id), Object.keys(answers));
    for (const [number, step] of LESSON.steps.entries()) {
      for (const [button, { name = "" }] of step.shows.entries()) {
        const what = `${id} ${step.id} ${name}`;
        const before = page.store.get();
        languages[0].steps[number].shows[button].open();
        const now = page.now();
        assert.deepEqual([now.problems, now.stale], [[], false], what);
        const right = name === "" ? answers[step.id] : answers[step.id][name];
        check(step, right, now, languages.map(({ words, steps }) => ({ words, question: steps[number].question })), what);
        // To show a mechanism is one undo step, unless it was open already.
        if (page.store.get().document === before.document) continue;
        page.history.undo();
        assert.deepEqual([page.store.get().kind, page.store.get().document], [before.kind, before.document], what);
        page.history.redo();
      }
    }
  });

  test(`the lesson ${id} says everything in every language`, async () => {
    const { LESSON, languages } = await told(id, new Page("mixer-a"));
    for (const { words, steps } of languages) {
      const end = steps.at(-1);
      assert.deepEqual([end.id, end.question, steps.length], ["end", null, LESSON.steps.length + 1]);
      for (const said of [end.title, end.text, end.shows[0].text]) checkSaid(said);
      for (const [number, { title, text, formula, shows, question }] of steps.slice(0, -1).entries()) {
        for (const said of [text, question.text, question.hint()]) checkSaid(said);
        assert.ok(title.length > 2 && !title.includes("."), title);
        assert.ok(shows.every((show) => show.text.length > 1 && !show.text.includes("show.")));
        assert.deepEqual(question.options?.map(({ value }) => value), LESSON.steps[number].question.choices);
        assert.ok(question.options?.every((option) => !option.text.includes("choice.")) ?? true);
        // The question is the last sentence of its text, and contains the tolerance.
        if (LESSON.steps[number].question.within) assert.match(question.text, /^[^?]+\)\?$/);
        // All lessons use one letter for the numbers of pairs: P₁, P₂.
        assert.doesNotMatch(`${formula} ${text} ${question.text}`, /p[₁-₅]/);
        // A number in a formula has the decimal sign of the language.
        if (words.lang !== "en") assert.doesNotMatch(formula, /\d\.\d/);
      }
    }
  });
}

/**
 * @param {object} step
 * @param {number | string | false | null} right
 * @param {import("assur/state/model.js").AnySnapshot} now
 * @param {{ words: Words, question: import("assur/lesson/panel.js").Question }[]} languages
 * @param {string} what
 */
function check({ question: asked }, right, now, languages, what) {
  for (const { words, question } of languages) {
    if (right === false) {
      assert.deepEqual([question.judge("1", now), question.answer(now)], ["none", null], what);
      continue;
    }
    if (right === null) {
      // An answer becomes right only when the reader has corrected the shown mechanism.
      for (const given of ["1", "20"]) assert.equal(question.judge(given, now), "not_yet", what);
      continue;
    }
    if (typeof right === "string") {
      for (const choice of asked.choices) assert.equal(question.judge(choice, now), choice === right ? "right" : "not_yet", `${what} ${choice}`);
      assert.equal(question.judge("", now), "unanswered");
    } else {
      const { within } = asked;
      // Answers in the notation of the language, as near as the tolerance of the question allows.
      assert.equal(question.judge(words.numbers.exact(right), now), "right", what);
      for (const sign of [-1, 1]) {
        if (within > 0) assert.equal(question.judge(words.numbers.exact(right + 0.99 * sign * within), now), "right", what);
        assert.equal(question.judge(words.numbers.exact(right + sign * (within > 0 ? 1.01 * within : 1)), now), "not_yet", what);
      }
      assert.equal(question.judge("", now), "unread");
    }
    assert.equal(question.judge(String(right), { ...now, stale: true }), "stale");
    checkSaid(question.right(now));
    assert.equal(question.judge(choiceOf(question, question.answer(now)), now), "right", what);
  }
}

/**
 * @param {import("assur/lesson/panel.js").Question} question
 * @param {string} answer as it is shown
 * @returns {string} the answer as a reader types or chooses it
 */
function choiceOf({ options, unit }, answer) {
  return options ? options.find(({ text }) => text === answer).value : answer.slice(0, answer.length - unit.length);
}

test("a question about another kind of document than is open has no answer", async () => {
  const page = new Page("mixer-a");
  const { languages: [{ steps }] } = await told("mobility", page);
  assert.equal(steps[0].question.judge("7", page.now()), "none");
});

test("a number is judged by its distance, round ones by that on the circle", () => {
  for (const [given, exact, within, round, verdict] of [
    ["10", 10, 0, false, "right"], ["1.3", 1.2, 0.1, false, "right"], ["0.4", 0.3, 0.1, false, "right"], ["0.3", 0.1 + 0.2, 0, false, "right"], ["1.31", 1.2, 0.1, false, "not_yet"], ["10.01", 10, 0, false, "not_yet"], ["359", 1, 2, true, "right"], ["-359", 1, 0, true, "right"], ["359", 1, 2, false, "not_yet"],
    ["", 1, 2, false, "unread"], ["x", 1, 2, false, "unread"], ["1,5", 1.5, 0, false, "right"], ["180", -180, 0.1, true, "right"],
  ]) assert.equal(judged(given, exact, within, round), verdict, `${given} ${exact}`);
});
