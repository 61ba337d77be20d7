import assert from "node:assert/strict";
import test from "node:test";
import { called, calledIn, entryNumber, numberEntries } from "assur/core/names.js";
import { isLength, subscript, symbol } from "assur/core/symbols.js";
import { derived } from "assur/core/units.js";
import { wordsOf } from "assur/tests/words.js";

const [en, ru] = ["en", "ru"].map((lang) => wordsOf(lang));
const three = (quantity, physical) => [0, 1, 2].map((order) => symbol(quantity, order, physical, en));

test("derivatives have strokes by the input, and letters and dots by time", () => {
  assert.deepEqual(three({ name: "rocker.angle", number: "3" }, false), ["φ₃", "φ₃′", "φ₃″"]);
  assert.deepEqual(three({ name: "rocker.angle", number: "3" }, true), ["φ₃", "ω₃", "ε₃"]);
  assert.deepEqual(three({ name: "wheel5.angle", number: "5" }, false), ["ψ₅", "ψ₅′", "ψ₅″"]);
  assert.deepEqual(three({ name: "wheel5.angle", number: "5" }, true), ["ψ₅", "ω₅", "ε₅"]);
  assert.equal(symbol({ name: "wheel5.angle" }, 0, false, en), `φ ${called("wheel5", en)}`);
  assert.deepEqual(three({ name: "C2.x" }, false), ["x", "x′", "x″"]);
  assert.deepEqual(three({ name: "C2.y" }, true), ["y", "ẏ", "ÿ"]);
});

test("what is measured is said with its points or links", () => {
  assert.equal(symbol({ name: "B-D.distance" }, 0, false, en), "d B-D");
  assert.equal(symbol({ name: "B-C1-D.corner" }, 1, false, en), "θ′ B-C₁-D");
  assert.equal(symbol({ name: "coupler-rocker.between" }, 0, false, en), "θ coupler-rocker");
  assert.equal(symbol({ name: "coupler-rocker.between" }, 0, false, ru), `θ ${called("coupler", ru)}-${called("rocker", ru)}`);
  assert.equal(symbol({ name: "C2.transmission" }, 0, false, en), "μ C₂");
  assert.equal(symbol({ name: "rocker.angle" }, 0, false, en), "φ rocker");
});

test("a quantity without letters of its own goes by its name", () => {
  assert.deepEqual(three({ name: "sun.power" }, false), ["sun.power", "sun.power′", "sun.power″"]);
  assert.equal(symbol({ name: "dwell" }, 0, true, en), "dwell");
});

test("coordinates and distances are lengths, all else is an angle", () => {
  for (const what of ["x", "y", "distance", "radius", "centre_x", "centre_y"]) assert.ok(isLength(what), what);
  for (const what of ["angle", "corner", "between", "transmission", "pressure", "load_angle"]) assert.ok(!isLength(what), what);
});

test("digits are written low, letters stay", () => {
  assert.equal(subscript("0123456789C12"), "₀₁₂₃₄₅₆₇₈₉C₁₂");
});

test("units of derivatives are divided as often as they are derived", () => {
  assert.deepEqual([1, 2].map((order) => derived("mm", "s", order)), ["mm/s", "mm/s²"]);
  assert.deepEqual([1, 2].map((order) => derived("rad", "rad", order)), ["1", "1/rad"]);
  assert.deepEqual([1, 2].map((order) => derived("", "s", order)), ["1/s", "1/s²"]);
  assert.deepEqual([1, 2].map((order) => derived("mm", "", order)), ["mm", "mm"]);
});

test("links are called by the words of the language, with their numbers, and others by their names", () => {
  assert.equal(called("AB", en), "AB");
  assert.equal(called("", en), "");
  assert.equal(called("by_hand", en), "by_hand", "another text of the page");
  for (const name of ["crank", "coupler", "rocker"]) {
    assert.equal(called(name, ru), ru.text(`link.${name}`, { n: "" }));
    assert.notEqual(called(name, ru), name);
  }
  assert.ok(called("wheel5", ru).includes("5") && called("wheel5", ru) !== "wheel5", called("wheel5", ru));
  assert.ok(!/[{}]/.test(called("wheel", ru) + called("wheel12", ru)));
});

test("in a formula of structure only links are called by words", () => {
  const formula = calledIn("I(frame,crank) → II₂(AB+rocker,BC)", ru);
  assert.equal(formula, `I(${called("frame", ru)},${called("crank", ru)}) → II₂(AB+${called("rocker", ru)},BC)`);
});

test("entries of a list are counted from one, unless a kind numbers them", () => {
  assert.equal(entryNumber("nothing", 0), "1");
  numberEntries("nothing", (index) => `№${index}`);
  assert.equal(entryNumber("nothing", 3), "№3");
});
