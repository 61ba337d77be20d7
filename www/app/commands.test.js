// Tests of the commands of keys and buttons, without the elements of the page.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import test from "node:test";
import "assur/tests/window.js";
import { stoppedAt } from "assur/state/player.js";
import { Address } from "assur/state/address.js";
import { withDocument, withExtras, withView } from "assur/state/state.js";
import { Page } from "assur/tests/page.js";
import { wordsOf } from "assur/tests/words.js";

globalThis.HTMLDialogElement = class HTMLDialogElement {};
const dialog = Object.assign(new HTMLDialogElement(), { opened: 0, showModal: () => void (dialog.opened += 1) });
const field = () => Object.assign(new HTMLInputElement(), { addEventListener() {}, select() {} });
globalThis.document = { getElementById: (id) => (id === "link" ? dialog : field()), createTreeWalker() {} };
globalThis.location = { href: "https://assur.test/" };
globalThis.history = { replaceState() {} };
const clipboard = { text: "", writeText: async (text) => void (clipboard.text = text) };
Object.defineProperty(globalThis, "navigator", { value: { clipboard } });
const { commands } = await import("assur/app/commands.js");
const { lineOf } = await import("assur/app/notices.js");
const { SPEEDS } = await import("assur/controls/transport.js");

/** @param {string} id */
function begin(id, view = {}) {
  const page = new Page(id, view);
  page.drive = (inputShown) => page.store.update((state) => stoppedAt(state, inputShown, page.model));
  page.step = (count) => page.drive(page.model.coordinate.of(page.store.get()) + count * page.model.coordinate.step);
  page.address = new Address(page.engine, "en");
  page.notices = { told: [], tell: (lines) => (page.notices.told = lines.map((line) => lineOf(line, wordsOf("en")))) };
  const all = commands(page);
  return { page, all, view: () => page.store.get().view };
}

test("small and large steps, the ends of the axis", () => {
  const { all, view } = begin("mixer-a", { phi_deg: 75, playing: true });
  const after = (...names) => {
    for (const name of names) all[name]();
    return view().phi_deg;
  };
  assert.deepEqual([after("start"), view().playing], [0, false]);
  assert.equal(after("forward", "forward", "back"), 1);
  assert.equal(after("forward10", "forward10", "back10"), 11);
  assert.equal(after("back10", "back10"), 351);
  assert.equal(after("end"), 360);
});

test("a slide steps by its way and stops at its ends", () => {
  const { page, all } = begin("mixer-a");
  page.choose("linkage", JSON.parse(readFileSync(new URL("../../tests/data/linkages/driven-slide.json", import.meta.url), "utf8")));
  assert.equal(page.now().summary.moves, "length");
  all.end();
  const { end } = page.model.coordinate.axis(0);
  all.forward();
  assert.equal(page.store.get().view.s, end);
});

test("speeds are gone through one by one, and leave real time", () => {
  const { page, all, view } = begin("mixer-a");
  const found = [];
  for (let i = 0; i <= SPEEDS.length; i++) {
    found.push(view().speed);
    all.faster();
  }
  assert.deepEqual([...new Set(found)], SPEEDS.filter((speed) => speed >= 1));
  for (let i = 0; i <= SPEEDS.length; i++) all.slower();
  assert.equal(view().speed, SPEEDS[0]);
  page.store.update((state) => withView(state, { true_time: true }));
  all.faster();
  assert.equal(view().true_time, false);
});

test("play and reverse are their own opposites, and make no step of undo", () => {
  const { page, all, view } = begin("mixer-a");
  const before = page.store.get();
  for (const name of ["play", "reverse", "projector"]) {
    all[name]();
    assert.notDeepEqual(view(), before.view);
    all[name]();
    assert.deepEqual(view(), before.view);
  }
  for (const name of ["play", "reverse", "forward", "end", "faster"]) all[name]();
  assert.equal(page.history.canUndo, false);
});

test("another assembly is a step of undo; what has none stays as it is", () => {
  const { page, all } = begin("mixer-a", { phi_deg: 75 });
  const rocker = () => page.now().readouts.value("rocker.angle");
  const first = rocker();
  all.assembly2();
  const second = rocker();
  assert.ok(second < 0 && first > 0);
  all.assembly1();
  assert.equal(rocker(), first);
  all.undo();
  assert.equal(rocker(), second);
  all.undo();
  assert.equal(rocker(), first);
  assert.equal(page.history.canUndo, false);
  all.redo();
  assert.equal(rocker(), second);
  const slide = begin("mobility-1a");
  const { document } = slide.page.store.get();
  slide.all.assembly2();
  assert.equal(slide.page.store.get().document, document);
});

test("reset is the mechanism as it stands in the catalogue, in one step, and drops what was typed", () => {
  const { page, all } = begin("mixer-c");
  const { document } = page.store.get();
  page.history.step(() => page.store.update((state) => withDocument(state, { l1: 0.3 })));
  page.drafts.keep("l4");
  all.reset();
  assert.deepEqual([page.store.get().document, page.drafts.fields()], [document, []]);
  all.undo();
  assert.equal(page.store.get().document.l1, 0.3);
  all.undo();
  assert.deepEqual([page.store.get().document, page.history.canUndo], [document, false]);
});

test("reset of a mechanism goes back to that of its own origin, of one that has none nowhere", () => {
  const { page, all } = begin("mixer-b");
  const { kind, document } = page.engine.catalogue.preset("jansen");
  page.choose(kind, { ...document, title: "Leg" });
  all.reset();
  assert.deepEqual(page.store.get().document, document);
  const { origin, ...own } = document;
  page.choose(kind, own);
  all.reset();
  assert.deepEqual(page.store.get().document, own);
  assert.equal(origin, "jansen");
  // The mixer shown last is remembered.
  const mixer = page.engine.catalogue.preset("mixer-b");
  page.choose(mixer.kind, { ...mixer.document, l1: 0.31 });
  all.reset();
  assert.deepEqual(page.store.get().document, mixer.document);
});

test("a copied link is said; that a long one may be cut on its way is said besides, also where it is copied by hand", async (t) => {
  const { page, all } = begin("mixer-a");
  const copy = async () => {
    page.notices.told = [];
    all.copy();
    await new Promise(setImmediate);
    return page.notices.told;
  };
  const cut = "The link is long: messengers and mail programs may cut it. Save a file and send that instead.";
  assert.deepEqual(await copy(), ["Link copied."]);
  const lesson = (letters) => page.store.update((state) => withExtras(state, { lesson: { title: "x".repeat(letters), steps: [] } }));
  lesson(0);
  lesson(7999 - page.address.link(page.store.get()).length);
  assert.deepEqual([await copy(), clipboard.text.length], [["Link copied."], 7999]);
  lesson(8000);
  assert.deepEqual(await copy(), ["Link copied.", cut]);
  lesson(400_000);
  assert.deepEqual(await copy(), ["The lesson is too long for a link. Save it as a file and share the file."]);
  t.mock.method(clipboard, "writeText", () => Promise.reject(new DOMException("", "NotAllowedError")));
  lesson(1);
  assert.deepEqual([await copy(), dialog.opened], [[], 1]);
  lesson(8000);
  assert.deepEqual([await copy(), dialog.opened], [[cut], 2]);
});
