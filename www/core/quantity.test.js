// Tests of the names of read-outs, which are made of a quantity and the order of its derivative.
import assert from "node:assert/strict";
import test from "node:test";
import { idOf, partsOf, readingOf } from "assur/core/quantity.js";

/** Names that could be confused: of a link and of a point, of a derivative, and of another read-out. */
const NAMES = ["C.angle", "dC.angle", "ddC.angle", "C.x", "dC.x", "C.x.angle", "C′.angle", "″.x", "input.angle", "formula.angle", "C.centre.angle", "B-C1-D.corner"];

test("a derivative has a stroke for each order, and its name says what it is of", () => {
  assert.deepEqual([0, 1, 2].map((order) => idOf("rocker.angle", order)), ["rocker.angle", "rocker.angle′", "rocker.angle″"]);
  for (const quantity of ["input", "driven", ...NAMES]) {
    for (const order of [0, 1, 2]) assert.deepEqual(readingOf(idOf(quantity, order)), { quantity, order });
  }
});

test("no two read-outs go by one name", () => {
  const all = ["input", "formula", "C.centre", ...NAMES.flatMap((name) => [0, 1, 2].map((order) => idOf(name, order)))];
  assert.equal(new Set(all).size, all.length);
});

test("the last part of a quantity's name is what it is, the rest is whose", () => {
  assert.deepEqual(partsOf("C.x.angle"), { of: "C.x", what: "angle" });
  assert.deepEqual(partsOf("B-C1-D.corner"), { of: "B-C1-D", what: "corner" });
  assert.deepEqual([partsOf(".x"), partsOf("input")], [{ of: "", what: "x" }, { of: "", what: "input" }]);
});
