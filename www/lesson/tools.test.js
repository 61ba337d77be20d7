// What a step says of a quantity: as the table of values writes it.
import "assur/tests/document.js";
import assert from "node:assert/strict";
import test from "node:test";
import { derived } from "assur/lesson/tools.js";

test("a derivative is written as in the table of values: by strokes, or by time with a letter of its own", () => {
  assert.equal(derived("φ₃", 0, "φ"), "φ₃");
  assert.equal(derived("φ₃", 1, "φ′"), "φ₃′");
  assert.equal(derived("ψ₅", 2, "φ″"), "ψ₅″");
  assert.equal(derived("φ₁", 1, "ω"), "ω₁");
  assert.equal(derived("φ₁", 2, "ε"), "ε₁");
});
