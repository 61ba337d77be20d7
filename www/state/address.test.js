import assert from "node:assert/strict";
import test, { beforeEach } from "node:test";
import { Address, addressed } from "assur/state/address.js";
import { happen } from "assur/tests/window.js";
import { newEngine, stateOf } from "assur/tests/engine.js";
import { persist, takeUpAddress } from "assur/state/storage.js";
import { Store } from "assur/state/store.js";
import { withDocument, withExtras, withView } from "assur/state/state.js";

const engine = newEngine();
const HOME = "https://assur.test/?embed";
const kept = new Map();
let entries = [];

globalThis.localStorage = { getItem: (key) => kept.get(key) ?? null, setItem: (key, text) => kept.set(key, text), removeItem: (key) => kept.delete(key) };
globalThis.PerformanceNavigationTiming = class {
  type = "reload";
};
const ofTab = new Map();
globalThis.sessionStorage = { getItem: (key) => ofTab.get(key) ?? null, setItem: (key, text) => ofTab.set(key, text), removeItem: (key) => ofTab.delete(key) };
globalThis.document = Object.assign(new EventTarget(), { hidden: false });
globalThis.location = { href: HOME };
const go = (put) => (_, __, href) => {
  put(href);
  location.href = href;
};
globalThis.history = {
  replaceState: go((href) => entries.splice(-1, 1, href)),
  pushState: go((href) => entries.push(href)),
};

beforeEach(() => {
  kept.clear();
  ofTab.clear();
  location.href = `${HOME}#old`;
  entries = [location.href];
});

test("what follows the # is the address of a state, with any # in it", () => {
  assert.deepEqual(["https://a.b/", "https://a.b/#", "https://a.b/#x&v.a=1", "https://a.b/#x#y"].map(addressed), ["", "", "x&v.a=1", "x#y"]);
});

test("a mechanism of the catalogue has its name for an address, a changed one all that it is", () => {
  const address = new Address(engine, "en");
  const state = stateOf(engine, "jansen", { phi_deg: 33, lang: "en" });
  assert.equal(address.link(state), `${HOME}#jansen&v.phi_deg=33&v.playing=false`);
  assert.equal(address.link(withView(state, { playing: true, lang: "ru" })), `${HOME}#jansen&v.lang=ru`);
  const changed = address.link(withDocument(state, { title: "Leg" }));
  assert.ok(changed.startsWith(`${HOME}#2&kind=linkage&d.title=Leg&`), changed);
  // The reader's own language is left out.
  assert.equal(new Address(engine, "uk").link(withView(state, { playing: true, lang: "uk" })), `${HOME}#jansen`);
});

test("another mechanism is an entry of its own, the same one is not", () => {
  const address = new Address(engine, "en");
  const [mixer, jansen] = ["mixer-a", "jansen"].map((id) => stateOf(engine, id, { playing: true }));
  address.show(mixer);
  address.enter(mixer, withView(mixer, { traces: false }));
  assert.deepEqual(entries, [`${HOME}#mixer-a`]);
  address.enter(withView(mixer, { traces: false }), jansen);
  assert.deepEqual(entries, [`${HOME}#mixer-a&v.traces=false`, `${HOME}#jansen`]);
});

test("a lesson that is too long for an address leaves none", () => {
  const address = new Address(engine, "en");
  const long = withExtras(stateOf(engine, "jansen"), { lesson: { title: "x".repeat(500_000), steps: [] } });
  assert.equal(address.holds(long), false);
  assert.ok(address.holds(stateOf(engine, "jansen")));
  address.show(long);
  assert.equal(location.href, HOME);
});

test("an address that the browser does not take is no fault", (t) => {
  t.mock.method(history, "replaceState", () => {
    throw new DOMException("", "SecurityError");
  });
  new Address(engine, "en").show(stateOf(engine, "jansen"));
  assert.deepEqual(entries, [`${HOME}#old`]);
});

/**
 * Makes a store whose changes are kept in the address and in the storage of the browser.
 * @param {import("node:test").TestContext} t
 */
function keeping(t, { accepts = () => true, ours = true, unkept = () => {} } = {}) {
  t.mock.timers.enable({ apis: ["setTimeout"] });
  const store = new Store(stateOf(engine, "jansen"));
  persist(store, new Address(engine, "en"), accepts, ours, unkept);
  return store;
}

test("changes are written a while after the first of them, all at once", (t) => {
  const store = keeping(t);
  store.update((state) => withView(state, { traces: false }));
  t.mock.timers.tick(399);
  store.update((state) => withView(state, { centres: true }));
  assert.equal(kept.size, 0);
  t.mock.timers.tick(1);
  assert.deepEqual(JSON.parse(kept.get("assur.state")).view, { ...store.get().view });
  assert.equal(location.href, `${HOME}#jansen&v.playing=false&v.traces=false&v.centres=true`);
});

test("a turning crank alone is written when the page is left", (t) => {
  const store = keeping(t);
  store.update((state) => withView(state, { playing: true }));
  t.mock.timers.tick(400);
  kept.clear();
  store.update((state) => withView(state, { phi_deg: 99 }));
  t.mock.timers.tick(1000);
  assert.equal(kept.size, 0);
  happen("pagehide");
  assert.equal(JSON.parse(kept.get("assur.state")).view.phi_deg, 99);
});

test("what the engine does not take is not kept: what was there stays", (t) => {
  const store = keeping(t, { accepts: () => false });
  store.update((state) => withView(state, { traces: false }));
  t.mock.timers.tick(400);
  assert.deepEqual([kept.size, location.href], [0, `${HOME}#old`]);
});

test("what another page shows in a frame is in the address only", (t) => {
  const store = keeping(t, { ours: false });
  store.update((state) => withView(state, { traces: false }));
  t.mock.timers.tick(400);
  assert.deepEqual([kept.size, location.href], [0, `${HOME}#jansen&v.playing=false&v.traces=false`]);
});

test("an image is kept by itself, once, and one that does not fit is said", (t) => {
  let unkept = 0;
  const store = keeping(t, { unkept: () => (unkept += 1) });
  const set = t.mock.method(localStorage, "setItem");
  const images = () => set.mock.calls.filter(({ arguments: [key] }) => key === "assur.image").length;
  const picture = (image) => ({ image, at: [0, 0], width: 1, turn_deg: 0, opacity: 1 });
  const image = `data:${"x".repeat(5000)}`;
  for (const change of [{ picture: picture(image) }, { picture: { ...picture(image), opacity: 0.5 } }]) {
    store.update((state) => withExtras(state, change));
    t.mock.timers.tick(400);
  }
  assert.deepEqual([images(), kept.get("assur.image"), unkept], [1, image, 0]);
  assert.ok(kept.get("assur.state").length < 5000 + 4000 && !kept.get("assur.state").includes(image));
  store.update((state) => withExtras(state, { picture: undefined }));
  t.mock.timers.tick(400);
  assert.equal(kept.has("assur.image"), false);
  set.mock.mockImplementation((key, text) => {
    if (key === "assur.image") throw new DOMException("", "QuotaExceededError");
    kept.set(key, text);
  });
  store.update((state) => withExtras(state, { picture: picture(image) }));
  t.mock.timers.tick(400);
  assert.equal(unkept, 1);
});

for (const [when, time] of [["just before", 400], ["when", 0]])
  test(`a change that is written ${when} the page is left is there after a reload`, (t) => {
    t.mock.method(performance, "getEntriesByType", () => [new PerformanceNavigationTiming()]);
    const store = keeping(t);
    const taken = location.href;
    store.update((state) => withView(state, { traces: false }));
    // The browser has begun to reload the page with this address.
    t.mock.timers.tick(time);
    happen("pagehide");
    const meant = location.href;
    assert.notEqual(meant, taken);
    location.href = taken;
    takeUpAddress();
    assert.equal(location.href, meant);
    location.href = taken;
    takeUpAddress();
    assert.equal(location.href, taken);
  });
