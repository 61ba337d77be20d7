// Tests of the results of a class as a saved table.
import assert from "node:assert/strict";
import test from "node:test";
import "assur/tests/canvas.js";
import "assur/tests/document.js";
import { toCode } from "assur/lesson/code.js";
import { Results } from "assur/lesson/results.js";
import { digestOf } from "assur/lesson/verdict.js";
import { withExtras } from "assur/state/state.js";
import { Page } from "assur/tests/page.js";
import { wordsOf } from "assur/tests/words.js";

const saved = [];
HTMLAnchorElement.prototype.click = function () {
  saved.at(-1).name = this.download;
};
URL.createObjectURL = (file) => saved.push({ file }) && "blob:";

/** @param {string} lang */
async function csvIn(lang) {
  const page = new Page("crank-rocker");
  const { kind, document } = page.engine.catalogue.preset("crank-rocker");
  const question = (options) => ({ text: "Which?", choice: { options, answer: 0 } });
  const lesson = { title: "Week 3", steps: [
    { title: "1", text: "", shows: { kind, document, view: {} }, question: question(["crank, rocker", "none"]) },
    { title: "2", text: "" },
    { title: "3", text: "", question: question(["=1+1", "no"]) },
  ] };
  page.store.update((state) => withExtras(state, { lesson }));
  const results = new Results(page, wordsOf(lang));
  const field = (id) => results.element.querySelector(`#${id}`);
  results.render(lesson);
  assert.equal(field("write-save_results").hidden, true);
  const digest = digestOf(lesson, page.engine);
  const code = (name, ...answers) => toCode({ lesson: digest, name, answers });
  const given = (one, tries, shown = false) => ({ given: one, tries, shown });
  field("write-codes").value = [code("Ann", given("0", 2), null, given("0", 1)), "damaged", code("Әсем", given("1", 1), null, given("0", 0, true))].join("\n");
  field("write-codes").dispatchEvent(new Event("input"));
  assert.equal(field("write-save_results").hidden, false);
  // The codes are judged in slices of time, so the rows do not come at once.
  while (results.element.querySelectorAll("tbody tr").length < 3) await new Promise((done) => setTimeout(done));
  field("write-save_results").dispatchEvent(new Event("click"));
  const { file, name } = saved.at(-1);
  return { text: await file.text(), name };
}

test("a table of results is saved under the title of the lesson, each answer with its sign and its tries in cells of their own", async () => {
  const { text, name } = await csvIn("en");
  assert.equal(name, "Week-3.csv");
  assert.deepEqual(text.replace("\ufeff", "").split("\n"), [
    "Name,1,1: answer,1: tries,3,3: answer,3: tries,Right",
    'Ann,✓,"crank, rocker",2,✓,\'=1+1,1,2',
    text.split("\n")[2],
    "Әсем,✗,none,1,◇,,,0",
    "",
  ]);
  assert.match(text.split("\n")[2], /2/);
});

test("spreadsheets of languages with a decimal comma get semicolons", async () => {
  const { text } = await csvIn("ru");
  assert.ok(text.includes("Имя;1;1: ответ;1: число попыток;3;"), text);
});
