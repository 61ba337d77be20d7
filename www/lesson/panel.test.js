// Tests of the panel of a lecturer's lesson: another name gets its own answers, in the same elements.
import { all } from "assur/tests/document.js";
import assert from "node:assert/strict";
import test, { beforeEach } from "node:test";
import { LessonPanel } from "assur/lesson/panel.js";
import { WrittenLesson } from "assur/lesson/written.js";
import { withExtras, withView } from "assur/state/state.js";
import { Page } from "assur/tests/page.js";
import { wordsOf } from "assur/tests/words.js";

const words = wordsOf("en");

HTMLElement.prototype.scrollIntoView = () => {};
beforeEach(() => localStorage.clear());

/** Opens a lesson of one step. `find` returns an element of the panel by its id; `type` writes into one as a reader does. */
function begin(question, vary = []) {
  const page = new Page("mixer-a");
  page.redraw = () => {};
  const { kind, document: shown } = page.engine.catalogue.preset("mixer-a");
  const lesson = { title: "Own", steps: [{ title: "", text: "", shows: { kind, document: shown, view: { phi_deg: 30 }, vary }, question: { text: "?", ...question } }] };
  page.store.update((state) => withView(withExtras(state, { lesson }), { lesson: { id: "own", step: 1 } }));
  const container = globalThis.document.createElement("div");
  const panel = new LessonPanel(container, page, new WrittenLesson(lesson, page, words), words);
  const render = () => panel.render(page.model.snapshot(page.store.get(), words, true));
  render();
  const find = (id) => container.querySelector(`#${id}`);
  const type = (id, text) => {
    const input = find(id);
    input.value = text;
    for (const event of ["input", "change"]) input.dispatchEvent(new Event(event));
  };
  const check = () => container.querySelector("form").dispatchEvent(new Event("submit", { cancelable: true }));
  return { page, panel, container, find, type, check, render };
}

test("another name has its own answers, in the same elements", () => {
  const { find, type, check, container } = begin({ number: { value: 5, within: 0.1 } });
  type("lesson-reader", "Ada");
  const named = () => all(container, "[id]");
  const before = named();
  type("lesson-answer", "5");
  check();
  assert.equal(find("lesson-said").dataset.verdict, "right");
  type("lesson-reader", "Bo");
  assert.ok(before.length > 8 && named().every((element, i) => element === before[i]));
  assert.equal(find("lesson-answer").value, "");
  // A verdict on another reader's answer is hidden but keeps its space, so that a button under the pointer does not move.
  assert.equal(find("lesson-said").dataset.verdict, "past");
  assert.ok(!find("lesson-progress").textContent.includes("solved"), find("lesson-progress").textContent);
  check();
  assert.equal(find("lesson-said").dataset.verdict, "unread");
  type("lesson-answer", "4");
  check();
  assert.equal(find("lesson-said").dataset.verdict, "not_yet");
  type("lesson-reader", "Ada");
  assert.equal(find("lesson-answer").value, "5");
  assert.ok(find("lesson-code").value.length > 0);
});

test("options are chosen anew by another name, in the same elements", () => {
  const { find, type } = begin({ choice: { options: ["a", "b"], answer: 1 } });
  type("lesson-reader", "Ada");
  const [first, second] = ["0", "1"].map((value) => find(`lesson-${value}`));
  second.checked = true;
  second.value = "1";
  second.dispatchEvent(new Event("change"));
  type("lesson-reader", "Bo");
  assert.ok(first === find("lesson-0") && second === find("lesson-1"));
  assert.deepEqual([first.checked, second.checked], [false, false]);
  type("lesson-reader", "Ada");
  assert.deepEqual([first.checked, second.checked], [false, true]);
});

test("the mechanism with one's own numbers is that of the new name", () => {
  const { find, type, page, container } = begin({ number: { value: 5, within: 0.1 } }, [{ field: "l1", from: 0.3, to: 0.4, step: 0.01 }]);
  const show = () => {
    find("lesson-show").dispatchEvent(new Event("click"));
    return page.store.get().document.l1;
  };
  type("lesson-reader", "Ada");
  assert.equal(container.querySelector(".lesson-note").textContent, words.text("written.own"));
  const hers = show();
  type("lesson-reader", "Bo");
  const his = show();
  type("lesson-reader", "Ada");
  assert.notEqual(his, hers);
  assert.equal(show(), hers);
});

test("the engine is asked once for an answer, however often it is shown", (t) => {
  const { page, find, type, check } = begin({ number: { quantity: "rocker.angle", within: 0.1 } });
  const asked = t.mock.method(page.engine, "withScratchSimulator");
  find("lesson-reveal").dispatchEvent(new Event("click"));
  assert.equal(find("lesson-said").dataset.verdict, "shown");
  assert.match(find("lesson-said").textContent, /\d°/);
  type("lesson-answer", "1");
  check();
  assert.equal(find("lesson-said").dataset.verdict, "not_yet");
  assert.equal(asked.mock.callCount(), 1);
  type("lesson-reader", "Ada");
  find("lesson-reveal").dispatchEvent(new Event("click"));
  assert.equal(asked.mock.callCount(), 2);
});
