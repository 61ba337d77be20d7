// Tests of the cone of the links' directions: no name covers another.
import { all } from "assur/tests/document.js";
import assert from "node:assert/strict";
import test from "node:test";
import { cone } from "assur/kinds/synthesis/cone.js";

/** The height of a name, in the unit of the picture. */
const HEIGHT = 0.2;

test("names of directions that all but agree stand one behind the other", () => {
  for (const off of [0, 0.02, 0.1, 0.25]) {
    const names = all(cone([0.5, 1.2, 4, 1.2 + off], ""), "text");
    const places = names.map((name) => ["x", "y"].map((way) => Number(name.getAttribute(way))));
    const [e1, e3] = [places[1], places[3]];
    assert.ok(Math.hypot(e1[0] - e3[0], e1[1] - e3[1]) > HEIGHT, `${off}: ${places}`);
  }
});
