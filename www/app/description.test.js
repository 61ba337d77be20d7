// Tests of the sentences for screen readers after a change of the mechanism or the language.
import assert from "node:assert/strict";
import test from "node:test";
import { Description } from "assur/app/description.js";
import { withView } from "assur/state/state.js";
import { Page } from "assur/tests/page.js";
import { wordsOf } from "assur/tests/words.js";

globalThis.HTMLElement = class HTMLElement {
  textContent = "";
};

/** Page at rest, with the texts that it has for screen readers. */
function begin(t) {
  const elements = new Map();
  globalThis.document = { getElementById: (id) => elements.get(id) ?? elements.set(id, new HTMLElement()).get(id) };
  t.mock.timers.enable({ apis: ["setTimeout"] });
  const page = new Page("mixer-a", { phi_deg: 75 });
  const description = new Description({ panels: [], against: null }, true);
  const said = (id) => {
    description.render(page.now());
    t.mock.timers.tick(1000);
    return elements.get(id).textContent;
  };
  return { page, said };
}

test("a new drawing, which does not move, leaves nothing said of the mechanism before", (t) => {
  const { page, said } = begin(t);
  assert.match(said("announcement"), /^Input angle 75\.0°/);
  const { kind, document } = page.engine.functions.blank();
  page.choose(kind, document);
  for (const id of ["announcement", "mechanism-description", "charts-description"]) assert.equal(said(id), "", id);
});

test("what was said is said again in another language, and is silent in motion", (t) => {
  const { page, said } = begin(t);
  assert.match(said("announcement"), /^Input angle/);
  page.words = wordsOf("ru");
  assert.match(said("announcement"), /75,0°/);
  assert.doesNotMatch(said("announcement"), /Input angle/);
  page.store.update((state) => withView(state, { playing: true }));
  assert.equal(said("announcement"), "");
  assert.equal(said("mechanism-description"), page.words.text("told.moving"));
});

test("what a kind says of itself stands beside it, also of what is opened again", async (t) => {
  const { page, said } = begin(t);
  const { Description: Own } = await import("assur/kinds/scheme/description.js");
  const own = new Own();
  const now = () => {
    said("mechanism-description");
    if (page.store.get().kind === "scheme") own.render(page.now());
    return globalThis.document.getElementById("mechanism-description").textContent;
  };
  const open = (id) => {
    const { kind, document } = page.engine.catalogue.preset(id);
    page.choose(kind, document);
    return now();
  };
  const scheme = open("mobility-2a");
  assert.match(scheme, /4 pairs; W = 1, q = 3/);
  assert.match(open("jansen"), /^Input angle/);
  assert.equal(open("mobility-2a"), scheme);
});

test("a count of assemblies says for which input it is, and that there may be more", (t) => {
  const { page, said } = begin(t);
  for (const [id, expected] of [["crank-rocker", /crank-rocker, assembly 1 of 2 at 60°\.$/], ["coupled-cranks", /assembly 1 of at least 1 at 60°\.$/]]) {
    const { kind, document } = page.engine.catalogue.preset(id);
    page.choose(kind, document);
    assert.match(said("mechanism-description"), expected, id);
  }
});
