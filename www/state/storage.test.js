// Tests of the contents of the browser's storage, also if the storage is full or forbidden, and if another tab stores
// another mechanism.
import assert from "node:assert/strict";
import test, { beforeEach } from "node:test";
import { happen } from "assur/tests/window.js";
import { withDocument, withExtras, withView } from "assur/state/state.js";
import { Address } from "assur/state/address.js";
import { keep, keepLesson, kept, persist } from "assur/state/storage.js";
import { Store } from "assur/state/store.js";
import { newEngine, stateOf } from "assur/tests/engine.js";

const engine = newEngine();
const rocker = stateOf(engine, "crank-rocker");
const picture = { image: `data:image/png;base64,${"A".repeat(2000)}`, at: [0, 0], width: 10, turn_deg: 0, opacity: 0.5 };

/** @type {Map<string, string>} */
const texts = new Map();
let room = Infinity;
globalThis.localStorage = {
  getItem: (key) => texts.get(key) ?? null,
  removeItem: (key) => texts.delete(key),
  key: (i) => [...texts.keys()][i] ?? null,
  get length() {
    return texts.size;
  },
  setItem: (key, text) => {
    const others = [...texts].filter(([other]) => other !== key).reduce((sum, [, { length }]) => sum + length, 0);
    if (others + text.length > room) throw new DOMException("", "QuotaExceededError");
    texts.set(key, text);
  },
};
globalThis.document = new EventTarget();
globalThis.history = { replaceState() {} };
globalThis.location = { href: "https://assur.test/" };

beforeEach(() => {
  texts.clear();
  room = Infinity;
});

/** Page whose state is stored; `told` lists what was reported as not stored. */
function begin(ours = true) {
  const store = new Store(rocker);
  const told = [];
  persist(store, new Address(engine, "en"), () => true, ours, (...what) => told.push(what.join(" ")));
  const change = (make) => {
    store.update(make);
    happen("pagehide");
  };
  return { told, change, store };
}

const titled = (title) => (state) => withDocument(state, { title });

test("a state that does not fit is said once; what was kept before stays", () => {
  const { told, change } = begin();
  change(titled("first"));
  const before = texts.get("assur.state");
  room = before.length;
  for (const letters of [500, 600]) change(titled("x".repeat(letters)));
  assert.deepEqual([told, texts.get("assur.state")], [["state"], before]);
  change(titled("last"));
  change(titled("x".repeat(500)));
  assert.deepEqual(told, ["state", "state"]);
});

test("a picture that does not fit is said, the state is kept without it", () => {
  const { told, change } = begin();
  room = JSON.stringify(rocker, null, 2).length + 1000;
  change((state) => withExtras(titled("drawn")(state), { picture }));
  assert.deepEqual([told, texts.has("assur.image")], [["picture"], false]);
  assert.equal(JSON.parse(texts.get("assur.state")).document.title, "drawn");
});

test("where neither state nor picture fits, both are said at once", () => {
  const { told, change } = begin();
  room = 100;
  change((state) => withExtras(titled("drawn")(state), { picture }));
  assert.deepEqual(told, ["state picture"]);
});

test("an image that another tab has written over is written again with the next change", () => {
  const { change } = begin();
  change((state) => withExtras(state, { picture }));
  texts.set("assur.image", "data:theirs");
  happen("storage", { key: "assur.image", newValue: "data:theirs" });
  change(titled("drawn"));
  assert.equal(texts.get("assur.image"), picture.image);
});

test("where the browser forbids to keep anything, nothing is said of it", (t) => {
  const { told, change } = begin();
  t.mock.method(localStorage, "setItem", () => {
    throw new DOMException("", "SecurityError");
  });
  change(titled("first"));
  assert.deepEqual(told, []);
});

/** Simulates another tab that stores a state. */
const elsewhere = (state) => happen("storage", { key: "assur.state", newValue: JSON.stringify(state) });

test("another tab that keeps its own mechanism is said once, where this one has its own", () => {
  const { told, change, store } = begin();
  elsewhere(titled("other")(rocker));
  assert.deepEqual(told, [], "the mechanism of the catalogue is not lost");
  change(titled("own"));
  elsewhere(withView(store.get(), { phi_deg: 90 }));
  happen("storage", { key: "assur.welcome", newValue: "closed" });
  happen("storage", { key: null, newValue: null });
  assert.deepEqual(told, []);
  for (const title of ["other", "one more"]) elsewhere(titled(title)(rocker));
  assert.deepEqual(told, ["tab"]);
  // The next change in this tab is stored over the state of the other tab.
  change(titled("last"));
  assert.equal(JSON.parse(texts.get("assur.state")).document.title, "last");
});

test("a picture behind a mechanism of the catalogue is the tab's own", () => {
  const { told, change } = begin();
  change((state) => withExtras(state, { picture }));
  elsewhere(rocker);
  assert.deepEqual(told, ["tab"]);
});

test("a frame of another page keeps nothing and is not told", () => {
  const { told, change } = begin(false);
  change(titled("own"));
  elsewhere(titled("other")(rocker));
  assert.deepEqual([told, texts.size], [[], 0]);
});

test("of lecturers' lessons the last forty keep their answers and names, all else stays", () => {
  keep("lesson.mobility", "{}");
  keep("lesson.written", "d3");
  // Entries of an older version, which kept no list of lessons.
  texts.set("assur.lesson.own.old", "Ada");
  texts.set("assur.lesson.own.old.1x", "{}");
  for (let i = 0; i < 40; i++) {
    keepLesson(`own.d${i}`, `Reader ${i}`);
    keepLesson(`own.d${i}.1x`, "{}");
    keepLesson(`own.d${i}.2x`, "{}");
  }
  assert.deepEqual([kept("lesson.own.old"), kept("lesson.own.old.1x")], [null, null]);
  assert.deepEqual([kept("lesson.own.d0"), kept("lesson.own.d39.2x")], ["Reader 0", "{}"]);
  // A lesson that is used again moves to the end of the list.
  keepLesson("own.d0.1x", "{}");
  keepLesson("own.more", "Reader");
  assert.deepEqual(["d0", "d0.2x", "d1", "d1.2x", "d2", "more"].map((name) => kept(`lesson.own.${name}`) !== null), [true, true, false, false, true, true]);
  assert.deepEqual([kept("lesson.mobility"), kept("lesson.written")], ["{}", "d3"]);
});

test("answers in a lesson that do not fit are said once and stay for the visit", () => {
  const { told } = begin();
  const answers = "x".repeat(300);
  keepLesson("own.full.1x", "{}");
  room = 200;
  for (let times = 0; times < 3; times++) keepLesson("own.full.1x", answers + times);
  keepLesson("mobility", answers);
  assert.deepEqual([told, kept("lesson.own.full.1x"), kept("lesson.mobility")], [["lesson"], `${answers}2`, answers]);
  // The answers stored before are not removed to make room.
  assert.equal(texts.get("assur.lesson.own.full.1x"), "{}");
  room = Infinity;
  keepLesson("own.full.1x", "anew");
  assert.deepEqual([kept("lesson.own.full.1x"), texts.get("assur.lesson.own.full.1x")], ["anew", "anew"]);
  // Another tab has written since.
  texts.set("assur.lesson.own.full.1x", "theirs");
  assert.equal(kept("lesson.own.full.1x"), "theirs");
  room = 200;
  keepLesson("own.full.1x", answers);
  assert.deepEqual(told, ["lesson", "lesson"]);
});

test("answers in a lesson stay for the visit where the browser forbids to keep them, and nothing is said", (t) => {
  const { told } = begin();
  t.mock.method(localStorage, "setItem", () => {
    throw new DOMException("", "SecurityError");
  });
  keepLesson("own.forbidden.1x", "{}");
  assert.deepEqual([told, kept("lesson.own.forbidden.1x")], [[], "{}"]);
});

test("a lesson's answers have the room of those that are forgotten for them", () => {
  const { told } = begin();
  for (let i = 0; i < 40; i++) keepLesson(`own.r${i}`, "x".repeat(100));
  room = [...texts.values()].join("").length;
  keepLesson("own.next", "x".repeat(90));
  assert.deepEqual([told, texts.get("assur.lesson.own.next"), kept("lesson.own.r0")], [[], "x".repeat(90), null]);
});

test("in motion the input waits for the end, all else is kept after a while", (t) => {
  t.mock.timers.enable({ apis: ["setTimeout"] });
  const { store } = begin();
  const speedOf = () => JSON.parse(texts.get("assur.state") ?? "{}").view?.speed;
  const phiOf = () => JSON.parse(texts.get("assur.state") ?? "{}").view?.phi_deg;
  store.update((state) => withView(state, { playing: true }));
  t.mock.timers.tick(400);
  for (const phi of [10, 20, 30]) store.update((state) => withView(state, { phi_deg: phi }));
  t.mock.timers.tick(4000);
  assert.notEqual(phiOf(), 30);
  store.update((state) => withView(state, { speed: 3 }));
  t.mock.timers.tick(400);
  assert.deepEqual([speedOf(), phiOf()], [3, 30]);
  store.update((state) => withView(state, { phi_deg: 40 }));
  store.update((state) => withView(state, { playing: false }));
  t.mock.timers.tick(400);
  assert.equal(phiOf(), 40);
});
