// Tests of the panel beside a drawing: numbers and names typed into it, and its reasons.
import { all } from "assur/tests/document.js";
import assert from "node:assert/strict";
import test from "node:test";
import { degrees } from "assur/core/angles.js";
import { DrawingRail } from "assur/drawing/rail.js";
import { initialState, withDocument, withView } from "assur/state/state.js";
import { Page } from "assur/tests/page.js";
import { wordsOf } from "assur/tests/words.js";

/** Makes the panel of a drawing with a selected traced point; `type` writes into one of its fields. */
function begin(view = {}) {
  const page = new Page("crank-rocker", view);
  page.store.update((state) => withDocument(state, { tracers: [{ name: "P1", link: "coupler", at: [1, 0.5] }] }));
  page.mechanism.joints = () => page.now().summary.handles?.map(({ name }, i) => ({ name, x: page.now().handles[2 * i], y: page.now().handles[2 * i + 1] })) ?? [];
  const rail = new DrawingRail(page, { points: new Set(["P1"]), links: new Set() }, { remove() {}, duplicate() {}, mirror() {} });
  const render = () => rail.render(page.now(), page.store.get().document);
  render();
  const section = globalThis.document.getElementById("rail").firstElementChild;
  const type = (id, text) => {
    const input = section.querySelector(`#${id}`);
    input.value = text;
    input.dispatchEvent(new Event("input"));
    render();
  };
  return { page, type };
}

test("the panel of an empty sheet invites to draw, that of a bar that it has no driver", () => {
  const page = new Page("crank-rocker");
  const rail = new DrawingRail(page, { points: new Set(), links: new Set() }, { remove() {}, duplicate() {}, mirror() {} });
  const section = globalThis.document.getElementById("rail").firstElementChild;
  const { kind, document: blank } = page.engine.functions.blank();
  page.store.update(() => initialState(kind, blank, { drawing: true }));
  const told = () => {
    rail.render(page.now(), page.store.get().document);
    const reasons = section.querySelector("#draw-reasons");
    return all(reasons).map(({ textContent }) => textContent);
  };
  assert.deepEqual(told(), ["Click two places to draw a link. The first is a fixed pivot, and links go on from place to place."]);
  page.store.update((state) => withDocument(state, { points: [{ name: "A", at: [0, 0] }, { name: "B", at: [1, 0] }], frame: ["A"], links: [{ name: "AB", points: ["A", "B"] }] }));
  const [reason, ...more] = told();
  assert.ok(reason.startsWith("No driver is given") && more.length === 0, [reason, ...more].join());
});

for (const at of [0, 1, 100]) {
  test(`the place of a traced point on its link is what is typed, and nothing else is changed, ${at}° on`, () => {
    const { page, type } = begin();
    page.store.update((state) => withView(state, { phi_deg: degrees(page.now().summary.home) + at }));
    const { document: before, view } = page.store.get();
    type("draw-along", "1.3");
    type("draw-across", "-0.7");
    const { document: after, view: later } = page.store.get();
    assert.deepEqual(after, { ...before, tracers: [{ name: "P1", link: "coupler", at: [1.3, -0.7] }] });
    assert.deepEqual(later, view);
  });
}

test("a link of the catalogue is named in the reader's language, and keeps its name until another is typed", () => {
  const page = new Page("jansen", { drawing: true });
  page.words = wordsOf("ru");
  page.mechanism.joints = () => [];
  const links = new Set(["upper triangle"]);
  const selection = { points: new Set(), links, set: (_, names) => names.forEach((name) => links.clear() ?? links.add(name)) };
  const rail = new DrawingRail(page, selection, { remove() {}, duplicate() {}, mirror() {} });
  rail.render(page.now(), page.store.get().document);
  const field = globalThis.document.getElementById("rail").querySelector("#draw-name");
  assert.equal(field.value, "верхний треугольник");
  assert.ok(page.store.get().document.links.some(({ name }) => name === "upper triangle"));
});
