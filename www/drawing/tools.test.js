// Tests of presses with the drawing tools: bars that go on after undo, ends on the paper and on links, messages that disappear.
import assert from "node:assert/strict";
import test from "node:test";
import { refuse, unsay, unsayLater } from "assur/drawing/edit.js";
import { Work } from "assur/drawing/tools.js";
import { Page } from "assur/tests/page.js";

/** An empty sheet with a tool. */
function begin(tool) {
  const page = new Page("mixer-a");
  const { kind, document } = page.engine.functions.blank();
  page.choose(kind, document);
  const work = new Work(page);
  work.take(tool);
  const press = (...at) => page.history.step(() => work.press({ point: null, link: null, wheel: null, at }));
  const on = (point) => page.history.step(() => work.press({ point, link: null, wheel: null, at: page.store.get().document.points.find(({ name }) => name === point).at }));
  const undo = () => {
    page.history.undo();
    work.follow();
  };
  const redo = () => {
    page.history.redo();
    work.follow();
  };
  const links = () => page.store.get().document.links.map(({ name }) => name);
  return { page, work, press, on, undo, redo, links, last: () => work.pressed[0]?.point };
}

test("after undo the links go on from the last point that is left", () => {
  const { page, press, undo, redo, links, last } = begin("bars");
  press(0, 0);
  press(0, 1);
  press(3, 3);
  assert.equal(last(), "C");
  undo();
  assert.equal(last(), "B");
  press(4, 4);
  assert.deepEqual(links(), ["AB", "BC"]);
  assert.deepEqual(page.store.get().document.frame, ["A"], "no new hinge of the frame");
  assert.deepEqual(page.store.get().document.points.at(-1).at, [4, 4]);
  undo();
  undo();
  assert.equal(last(), "A");
  redo();
  assert.equal(last(), "B");
  undo();
  undo();
  assert.equal(last(), undefined);
  assert.equal(page.store.get().document.points.length, 0);
});

test("undo of the press that ended a chain takes the chain up again; Esc ends it for good", () => {
  const { work, press, on, undo, last, links } = begin("bars");
  press(0, 0);
  press(0, 1);
  press(3, 3);
  on("A");
  assert.deepEqual(links(), ["AB", "BC", "AC"]);
  assert.equal(last(), undefined);
  undo();
  assert.equal(last(), "C");
  work.rest();
  undo();
  assert.equal(last(), undefined);
  press(5, 5);
  assert.equal(last(), "C", "a new chain");
});

test("a last point that was fixed to the frame by a second press is free again after undo, and the chain goes on", () => {
  const { page, press, on, undo, last } = begin("bars");
  press(0, 0);
  press(0, 1);
  on("B");
  assert.deepEqual(page.store.get().document.frame, ["A", "B"]);
  undo();
  assert.deepEqual([page.store.get().document.frame, last()], [["A"], "B"]);
  on("B");
  assert.deepEqual(page.store.get().document.frame, ["A", "B"]);
});

for (const [tool, presses, points] of [["bars", 1, 1], ["triad", 3, 6], ["dyad", 2, 3], ["wheel", 1, 1]]) {
  test(`ends of a new part on the paper are fixed pivots: ${tool}`, () => {
    const { page, press } = begin(tool);
    const places = [[0, 0], [4, 0], [2, 3]].slice(0, presses);
    for (const place of places) press(...place);
    const { document } = page.store.get();
    assert.equal(document.points.length, points);
    const fixed = document.points.filter(({ name }) => document.frame.includes(name)).map(({ at }) => at);
    assert.deepEqual(fixed, places);
    assert.equal(page.drafts.has("edit"), false);
  });
}

test("an end on a link is a point of that link, and the page says so", () => {
  const { page, work, press, links } = begin("bars");
  press(0, 0);
  press(0, 4);
  work.rest();
  page.history.step(() => work.press({ point: null, link: "AB", wheel: null, at: [0, 2] }));
  assert.deepEqual(page.now().problems, [{ code: "on_link", point: "C", link: "ABC" }]);
  press(3, 2);
  assert.deepEqual(page.now().problems.filter(({ code }) => code === "on_link"), []);
  assert.deepEqual(links(), ["ABC", "CD"]);
  assert.deepEqual(page.store.get().document.links[0].points, ["A", "B", "C"]);
});

test("a message about a press leaves after some seconds", (t) => {
  t.mock.timers.enable({ apis: ["setTimeout"] });
  const { page } = begin("drive");
  refuse(page, "press_link");
  unsayLater(page);
  t.mock.timers.tick(5000);
  assert.ok(page.drafts.has("edit"));
  t.mock.timers.tick(5000);
  assert.equal(page.drafts.has("edit"), false);
  refuse(page, "press_link");
  unsay(page);
  assert.equal(page.drafts.has("edit"), false);
});
