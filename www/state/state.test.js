import assert from "node:assert/strict";
import test from "node:test";
import { Store } from "assur/state/store.js";
import {
  DRAWN, PARTS, SWITCHES, UNDOABLE_VIEW, contains, edited, extrasOf, initialState, usualView, withDocument, withExtras, withMechanism, withView, withoutExtras,
} from "assur/state/state.js";

const document = Object.freeze({ l1: 1, wheels: [{ z: 18 }] });
const state = initialState("mixer", document, { lang: "ru" });

test("a change that changes nothing gives the same state", () => {
  assert.equal(withView(state, { phi_deg: 62, lang: "ru", measures: [] }), state);
  assert.equal(withDocument(state, { l1: 1, wheels: [{ z: 18 }] }), state);
  assert.equal(withExtras(state, {}), state);
  assert.equal(withExtras(state, { picture: undefined }), state);
});

test("a change makes a new frozen state and leaves the old one as it was", () => {
  const [turned, longer] = [withView(state, { phi_deg: 63 }), withDocument(state, { l1: 2 })];
  assert.deepEqual([state.view.phi_deg, turned.view.phi_deg, longer.document.l1, state.document.l1], [62, 63, 2, 1]);
  assert.equal(turned.document, state.document);
  assert.equal(longer.view, state.view);
  for (const one of [state, state.view, turned, turned.view, longer, longer.document]) assert.ok(Object.isFrozen(one));
  // 0 and −0 count as different, NaN as equal to itself.
  assert.ok(contains({ a: NaN }, { a: NaN }));
  assert.ok(!contains({ a: 0 }, { a: -0 }));
});

test("what is besides the document goes with every other change, and can be taken away", () => {
  const lesson = { title: "x", steps: [] };
  const taught = withExtras(state, { lesson });
  for (const one of [withView(taught, { phi_deg: 1 }), withDocument(taught, { l1: 3 }), withMechanism(taught, "linkage", { points: [] })]) assert.equal(one.lesson, lesson);
  assert.ok(!("lesson" in withExtras(taught, { lesson: undefined })));
  assert.deepEqual(extrasOf(taught), { lesson, compared: undefined, picture: undefined });
  assert.deepEqual(Object.keys(withoutExtras(taught)).sort(), ["document", "format", "kind", "view"]);
  assert.equal(withoutExtras(taught).document, taught.document);
});

test("a change of one kind of document leaves another as it is", () => {
  assert.equal(edited(state, "linkage", () => ({ l1: 9 })), state);
  assert.equal(edited(state, "mixer", ({ l1 }) => ({ l1: l1 + 1 })).document.l1, 2);
});

test("what the engine draws by, what is undone and what refers to parts are fields of the view", () => {
  const view = usualView({});
  for (const name of [...DRAWN, ...UNDOABLE_VIEW, ...SWITCHES, ...Object.keys(PARTS)]) assert.ok(name in view, name);
  assert.deepEqual({ ...view, ...PARTS }, view);
});

test("a store tells every listener of every change, once, with what was before", () => {
  const [store, heard] = [new Store(1), []];
  const leave = store.subscribe((now, before) => heard.push([now, before]));
  store.update((now) => now + 1);
  store.update((now) => now);
  leave();
  store.update((now) => now + 1);
  assert.deepEqual(heard, [[2, 1]]);
  assert.equal(store.get(), 3);
});

test("a store lets through only what its limit allows, and what comes from outside", () => {
  const store = new Store(1, (next, now) => (next > 3 ? now : next));
  store.update(() => 5);
  assert.equal(store.get(), 1);
  store.put(5);
  assert.equal(store.get(), 5);
});

test("a listener that changes the store is heard to the end", () => {
  const [store, heard] = [new Store(0), []];
  store.subscribe((now) => {
    if (now < 3) store.update((one) => one + 1);
  });
  store.subscribe((now) => heard.push(now));
  store.update(() => 1);
  assert.equal(store.get(), 3);
  assert.deepEqual(heard.toSorted(), [1, 2, 3]);
});
