// Tests of the mechanism of a step: which documents belong to the step, and how its mechanism is shown again.
import assert from "node:assert/strict";
import test from "node:test";
import { OwnMechanism } from "assur/lesson/own.js";
import { edited, withView } from "assur/state/state.js";
import { Page } from "assur/tests/page.js";
import { happen } from "assur/tests/window.js";

/** A step that shows case B of the mixer, and an element in place of its controls. */
function stepOn(page) {
  const inside = new Node();
  const controls = Object.assign(new Node(), { contains: (target) => target === inside });
  const own = new OwnMechanism(page, controls);
  const { kind, document } = page.engine.catalogue.preset("mixer-b");
  const open = (view = {}) => page.choose(kind, document, [], () => ({ phi_deg: 10, traces: false, ...view }));
  own.begin([{ id: "lesson-show", text: "", open, opened: (state) => JSON.stringify(state.document) === JSON.stringify(document) }]);
  return { own, open, inside };
}

const lengthen = (page, l1) => page.store.update((state) => edited(state, "mixer", () => ({ l1 })));

test("a step's own mechanism is the one shown, and what its controls made of it", () => {
  const page = new Page("mixer-a");
  const { own, open, inside } = stepOn(page);
  assert.equal(own.there, false);
  own.open(open);
  assert.equal(own.there, true);
  happen("input", { target: inside });
  lengthen(page, 0.33);
  assert.equal(own.there, true);
  // Undo and redo stay within the step. An undo beyond its beginning brings back the reader's earlier mechanism.
  happen("click", { target: new Node() });
  page.history.undo();
  assert.equal(own.there, true);
  page.history.redo();
  assert.equal(own.there, true);
  for (const target of [inside, new Node()]) {
    happen("keydown", { target });
    page.history.undo();
    page.history.undo();
    assert.equal(own.there, false, "the reader's");
    page.history.redo();
    page.history.redo();
    assert.equal(own.there, true);
  }
  // A change on the drawing, in the settings or by a file does not belong to the step.
  happen("pointerdown", { target: new Node() });
  lengthen(page, 0.34);
  assert.equal(own.there, false);
  happen("input", { target: inside });
  lengthen(page, 0.35);
  assert.equal(own.there, false, "made of another one by the step's controls");
  own.close();
});

test("it comes back as it was last, looked at as it was, in one step of undo", () => {
  const page = new Page("mixer-a", { lang: "uk" });
  const { own, open, inside } = stepOn(page);
  own.open(open);
  happen("input", { target: inside });
  lengthen(page, 0.33);
  page.store.update((state) => withView(state, { phi_deg: 77 }));
  happen("click", { target: new Node() });
  const { kind, document } = page.engine.catalogue.preset("jansen");
  page.choose(kind, document);
  page.store.update((state) => withView(state, { lang: "kk", traces: true }));
  assert.equal(own.there, false);
  own.bringBack();
  const { document: back, view } = page.store.get();
  assert.deepEqual([back.l1, view.phi_deg, view.traces, view.lang], [0.33, 77, false, "kk"]);
  assert.equal(own.there, true);
  page.history.undo();
  assert.equal(page.store.get().kind, "linkage");
  own.close();
});

test("a step reached by a link recognises its mechanism by its contents", () => {
  const page = new Page("mixer-b");
  const { own } = stepOn(page);
  assert.equal(own.there, true);
  own.close();
  const other = new Page("mixer-a");
  const step = stepOn(other);
  step.own.bringBack();
  assert.deepEqual(other.store.get().document, page.store.get().document);
  assert.equal(step.own.there, true);
  step.own.close();
});
