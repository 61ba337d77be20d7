// Tests of the numbers on the axes of the paper.
import assert from "node:assert/strict";
import test from "node:test";
import { numbered } from "assur/drawing/axes.js";

test("numbers stand at round values, as close as they have room", () => {
  // Squares of 1 unit are 50 pixels wide.
  const values = (widest) => numbered(50, 200, 0, 400, widest).map(({ value, at }) => [value, at]);
  assert.deepEqual(values(20).slice(0, 3), [[-4, 0], [-3, 50], [-2, 100]]);
  assert.deepEqual(values(20).at(-1), [4, 400]);
  assert.deepEqual(values(45).map(([value]) => value), [-4, -2, 0, 2, 4]);
  // Squares of 0.1 unit, and no rounding errors.
  assert.deepEqual(numbered(500, 0, 0, 200, 20).map(({ value }) => value), [0, 0.1, 0.2, 0.3, 0.4]);
});
