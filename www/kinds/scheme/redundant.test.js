// Tests that every place of the page shows the same number of redundant constraints of a scheme.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import test from "node:test";
import { all, clear } from "assur/tests/document.js";
import { FormulasView } from "assur/kinds/scheme/formulas.js";
import { GeometryView } from "assur/kinds/scheme/geometry.js";
import { MethodView } from "assur/kinds/scheme/method.js";
import { Description } from "assur/kinds/scheme/description.js";
import { SAID } from "assur/kinds/scheme/status.js";
import { wholePresets } from "assur/lesson/offer.js";
import { initialState } from "assur/state/state.js";
import { newEngine } from "assur/tests/engine.js";
import { snapshotOf } from "assur/tests/shown.js";

const engine = newEngine();
const PRESETS = wholePresets(JSON.parse(readFileSync(new URL("../../lessons/mobility/presets.json", import.meta.url), "utf8")));

const page = globalThis.document;

/** All numbers that the page shows as q, for a scheme whose contours are cut open. */
function told({ kind, document }) {
  const closed = engine.set(initialState(kind, { ...document, cut: [] }, {}));
  const snapshot = snapshotOf(engine, initialState(kind, { ...document, cut: closed.automatic }, { lang: "en" }));
  clear();
  const views = [new FormulasView(), new GeometryView({}), new MethodView({}), new Description()];
  for (const view of views) view.render(snapshot);
  const { summary, words } = snapshot;
  const lines = all(page.getElementById("rail"), "p").map(({ textContent }) => textContent)
    // This line is about the scheme with replaced pairs.
    .filter((line) => line !== words.text("replace.said"));
  // Only the total of a sum counts, not its terms.
  const said = [...lines, page.getElementById("mechanism-description").textContent].flatMap((line) => line.match(/\bq = [^.;]*/) ?? []);
  return [...said.map((one) => Number(one.split("= ").at(-1))), SAID.q(summary, words).value];
}

test("one scheme has one q: that of the rank", () => {
  for (const [name, q] of [["bennett", 3], ["sarrus", 1], ["hooke", 1], ["parallelogram", 7], ["tilted", 2], ["roller", 1], ["rssr", 0]]) {
    const numbers = told(PRESETS[name]);
    assert.ok(numbers.length >= 4, `${name}: ${numbers}`);
    assert.deepEqual(new Set(numbers), new Set([q]), `${name}: ${numbers}`);
  }
});

test("where a lesson asks for W by the count alone, W by rank is there to be compared with it", () => {
  const { kind, document } = PRESETS.tilted;
  const snapshot = snapshotOf(engine, initialState(kind, document, { lang: "en" }));
  const shown = (/** @type {readonly string[]} */ ...withheld) => {
    clear();
    new GeometryView({}).render({ ...snapshot, withheld: new Set(withheld) });
    return all(page.getElementById("rail"), "section p").map(({ textContent }) => textContent).join("\n");
  };
  assert.match(shown("scheme-w"), /W = 0,.*W = \?:/s);
  assert.match(shown("scheme-w", "scheme-rank"), /W = \?,.*W = \?:/s);
});

test("where the geometry is not known q is that of the count", () => {
  const { kind, document } = PRESETS.parallelogram;
  const [first, ...others] = document.pairs;
  const unknown = { ...document, pairs: [{ ...first, at: undefined }, ...others] };
  const { summary, words } = snapshotOf(engine, initialState(kind, unknown, { lang: "en" }));
  assert.equal(summary.space, null);
  assert.equal(SAID.q(summary, words).value, summary.redundant);
});
