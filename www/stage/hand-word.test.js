// Tests of the effect of a drag that the page shows before the drag.
import assert from "node:assert/strict";
import test from "node:test";
import { effectOf } from "assur/stage/hand-word.js";
import { Page } from "assur/tests/page.js";

/** Effects of all handles of a mechanism of the catalogue. */
function effects(id) {
  const page = new Page(id);
  const { summary, handles } = page.now();
  const before = page.store.get();
  const all = summary.handles.map(({ name }, k) => [name, effectOf(page, { name, x: handles[2 * k], y: handles[2 * k + 1] })]);
  assert.equal(page.store.get(), before, "nothing is changed");
  return Object.fromEntries(all);
}

test("a handle drives, changes lengths, or moves a pivot or a traced point: the page knows before it is dragged", () => {
  const { A, B, C, D } = effects("crank-rocker");
  assert.deepEqual([A, B, C, D], ["pivot", "drives", "lengths", "pivot"]);
  const mixer = effects("mixer-a");
  assert.deepEqual([mixer.B, mixer.C, mixer.D], ["drives", "lengths", "lengths"]);
  assert.equal(effects("klann").P1 ?? "traced", "traced");
});
