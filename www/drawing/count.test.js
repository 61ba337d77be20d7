// Tests of Chebyshev's formula with its numbers, for a drawing and for a linkage.
import assert from "node:assert/strict";
import test from "node:test";
import { counted } from "assur/drawing/count.js";
import { edit } from "assur/drawing/edit.js";
import { Page } from "assur/tests/page.js";

test("W in numbers: of a drawing that does not move, of one that does, with redundant constraints", () => {
  const page = new Page("crank-rocker");
  const said = () => {
    const { summary, words } = page.now();
    return counted(summary.counts, words.numbers);
  };
  assert.equal(said(), "= 3n − 2p₅ − p₄ = 3·3 − 2·4 − 0 =");
  edit(page, { edit: "bar", ends: [{ point: "C" }, { at: [9, 9] }] });
  assert.equal(page.store.get().kind, "draft");
  assert.equal(said(), "= 3n − 2p₅ − p₄ = 3·4 − 2·5 − 0 =");
  assert.equal(page.now().summary.mobility, 2);
  const counts = { links: 4, lower: 6, higher: 0, mobility: 1, by_count: 0 };
  assert.equal(counted(counts, page.words.numbers), "= 3n − 2p₅ − p₄ + q = 3·4 − 2·6 − 0 + 1 =");
});
