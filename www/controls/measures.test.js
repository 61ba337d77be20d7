// Tests that the focus stays in the list of measures while the list changes.
import "assur/tests/document.js";
import assert from "node:assert/strict";
import test from "node:test";
import { Measures } from "assur/controls/measures.js";
import { Page } from "assur/tests/page.js";
import { wordsOf } from "assur/tests/words.js";

test("a button keeps the focus when the language changes; when it disappears, another control has it", () => {
  const { document } = globalThis;
  const page = new Page("crank-rocker", { measures: ["B-D.distance", "A-C.distance", "coupler-rocker.between"] });
  const view = new Measures(page);
  const button = (index) => document.getElementById(`measure-remove-${index}`);
  const render = () => view.render(page.now());
  render();
  const last = button(2);
  last.focus();
  page.words = wordsOf("ru");
  render();
  assert.ok(document.activeElement === last && button(2) === last);
  assert.match(last.title, /[а-я]/);
  for (const next of [() => button(0), () => button(0), () => document.getElementById("measure-what")]) {
    document.activeElement.click();
    render();
    assert.ok(document.activeElement === next(), document.activeElement.id);
  }
  assert.deepEqual(page.store.get().view.measures, []);
});
