// Tests of the text beside the pointer.
import assert from "node:assert/strict";
import test from "node:test";
import { pointerText } from "assur/drawing/pointer-text.js";
import { Page } from "assur/tests/page.js";

test("beside the pointer: its place, and length and angle of the link that is stretched", () => {
  const { words } = new Page("crank-rocker");
  const read = (...of) => pointerText(...of, words).map((line) => line.replace(/\s+/g, " "));
  assert.deepEqual(read([-3.8, 1.2], null, true), ["x −3.8 y 1.2"]);
  assert.deepEqual(read([4, 5], [1, 1], true), ["l 5 φ 53.1°", "x 4 y 5"]);
  assert.deepEqual(read([4, 5], [1, 1], false), ["φ 53.1°", "x 4 y 5"], "a guide has no length");
  assert.deepEqual(read([1, 1], [1, 1], true), ["x 1 y 1"]);
});
