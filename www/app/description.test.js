// What a screen reader is told as the page goes on to another mechanism and another language.
import assert from "node:assert/strict";
import test from "node:test";
import { Description } from "assur/app/description.js";
import { withView } from "assur/state/state.js";
import { Page } from "assur/tests/page.js";
import { wordsOf } from "assur/tests/words.js";

globalThis.HTMLElement = class HTMLElement {
  textContent = "";
};

/** A page at rest, and all that it says to who does not see it. */
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
  const { kind, document } = page.engine.blank();
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
