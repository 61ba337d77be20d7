// Scales of plots; a motor's table as text.
import assert from "node:assert/strict";
import test from "node:test";
import "assur/tests/document.js";
import { pairsOf } from "assur/under-load/fields.js";
import { scale } from "assur/under-load/plot.js";

test("numbers of a scale are round and within it", () => {
  assert.deepEqual(scale(0, 10), [0, 5, 10]);
  assert.deepEqual(scale(-0.7, 1.3), [-0.5, 0, 0.5, 1]);
  assert.deepEqual(scale(11.79, 12.27).map((value) => value.toFixed(1)), ["11.8", "12.0", "12.2"]);
  for (let power = -9; power < 9; power++) {
    const found = scale(0.13 * 10 ** power, 1.07 * 10 ** power);
    assert.ok(found.length >= 2 && found.length <= 6, `${found}`);
  }
});

test("a table of a motor is pairs of numbers", () => {
  assert.deepEqual(pairsOf("0 12; 5 10,5;\n20 0"), [[0, 12], [5, 10.5], [20, 0]]);
  for (const text of ["", ";", "1", "1 2 3", "1 2; x 3", "1 2; 3"]) assert.equal(pairsOf(text), null, text);
});
