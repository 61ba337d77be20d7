import assert from "node:assert/strict";
import { test } from "node:test";
import { Words } from "assur/core/words.js";
import { compared, known, labelled } from "assur/lesson/paper.js";
import { tableOf } from "assur/tests/words.js";

const [en, ru] = ["en", "ru"].map((lang) => new Words(lang, tableOf(lang)));
const relation = { item: "", name: "y″_C1", angle: false, turned: false, count: false, value: -0.16, printed: -0.16 };

test("a relation that holds has one number, with the decimal sign of the language", () => {
  assert.equal(compared(relation, en), "y″_C1 = −0.1600");
  assert.equal(compared(relation, ru), "y″_C1 = −0,1600");
  // A rounding error does not count as a difference.
  assert.equal(compared({ ...relation, printed: -0.16 + 1e-12 }, en), "y″_C1 = −0.1600");
});

test("one that does not hold has both numbers and their difference", () => {
  assert.equal(compared({ ...relation, printed: 0.16 }, en), "y″_C1 = −0.1600; as printed 0.1600, difference 0.3200");
});

test("no dash stands before a printed number, where it would be read as a minus", () => {
  for (const lang of ["en", "ru", "uk", "kk"]) {
    const said = compared({ ...relation, printed: 0.16 }, new Words(lang, tableOf(lang)));
    assert.match(said, /0[.,]1600.*0[.,]1600/);
    assert.doesNotMatch(said, /— ?\d/, lang);
  }
});

test("one that divides by zero has no printed number", () => {
  assert.equal(compared({ ...relation, printed: null }, en), "y″_C1 = −0.1600; as printed it divides by zero");
});

test("angles are in degrees, and the same with a turn more", () => {
  const angle = { ...relation, name: "φ₅", angle: true, value: Math.PI / 6, printed: Math.PI / 6 };
  assert.equal(compared(angle, en), "φ₅ = 30.00°");
  assert.equal(compared({ ...angle, printed: angle.value - 2 * Math.PI }, en), "φ₅ = 30.00°");
  assert.equal(compared({ ...angle, printed: angle.value + Math.PI / 2 }, en), "φ₅ = 30.00°; as printed 120.00°, difference 90.00°");
});

test("an angle through which a wheel has turned is not the same with a turn more", () => {
  const wheel = { ...relation, name: "ψ₅", angle: true, turned: true, value: -1.1 * Math.PI, printed: 1.1 * Math.PI };
  assert.equal(compared(wheel, en), "ψ₅ = −198.00°; as printed 198.00°, difference 396.00°");
  assert.equal(compared({ ...wheel, value: -Math.PI, printed: Math.PI }, en), "ψ₅ = −180.00°; as printed 180.00°, difference 360.00°");
  assert.equal(compared({ ...wheel, printed: wheel.value }, en), "ψ₅ = −198.00°");
});

test("an item may have words of its own for its numbers", () => {
  const own = new Words("en", new Map([...tableOf("en"), ["paper.chain.differs", "{name}: {value}, {printed}, {off}"], ["paper.chain.undefined", "{name}: {value}"]]));
  const chain = { ...relation, item: "003.chain", value: 1, printed: 2 };
  assert.equal(compared(chain, own), "y″_C1: 1.0000, 2.0000, 1.0000");
  assert.equal(compared({ ...chain, printed: null }, own), "y″_C1: 1.0000");
  assert.equal(compared({ ...chain, item: "003.c1" }, own), "y″_C1 = 1.0000; as printed 2.0000, difference 1.0000");
});

test("the number of an equation is that after the paper, and no other number in brackets", () => {
  assert.deepEqual(["002.(16)y", "003.(2).CD", "004.(10)"].map(labelled), ["(16)", "(2)", "(10)"]);
  assert.deepEqual(["004.ratio.U1/3(4)", "002.u", "004.tab.4"].map(labelled), ["", "", ""]);
});

test("before the answer only those numbers are seen that do not give it away", () => {
  const [hidden, shown] = [false, true].map((one) => ({ shown: one }));
  assert.deepEqual(known([hidden, shown], new Set(["ratio"])), [shown]);
  assert.deepEqual(known([hidden, shown], new Set()), [hidden, shown]);
});

test("what is counted has no decimals", () => {
  const count = { ...relation, name: "q", count: true, value: 3, printed: 9 };
  assert.equal(compared(count, en), "q = 3; as printed 9, difference 6");
  assert.equal(compared({ ...count, name: "W", value: -2, printed: -2 }, ru), "W = −2");
});
