import assert from "node:assert/strict";
import test from "node:test";
import { digest, generator, hash, nameKey, ownNumbers, valueIn } from "assur/lesson/chance.js";
import { fromCode, toCode } from "assur/lesson/code.js";
import { fieldOf, withNumber } from "assur/lesson/field.js";
import { often } from "assur/tests/random.js";

test("what a name comes to is the same for ever: lessons that were given out keep their numbers", () => {
  assert.deepEqual(["", "Ann", "Айгүл"].map((name) => hash(name)), [2_872_998_923, 3_533_320_028, 501_443_453]);
  const next = ownNumbers("Ann Lee", 0);
  assert.deepEqual([next(), next()].map((share) => Math.floor(share * 1e6)), [247_304, 114_880]);
  assert.equal(digest({ a: 1 }), "faaba12dc94d822c");
});

test("a name is the same however it is typed, and each step has numbers of its own", () => {
  const first = (name, step = 0) => ownNumbers(name, step)();
  for (const typed of [" ann lee", "ANN  LEE", "Ann\tLee ", "Ａｎｎ Lee"]) assert.equal(first(typed), first("Ann Lee"), typed);
  assert.equal(nameKey("  Айгүл  Н "), "айгүл н");
  assert.notEqual(first("Ann Lee"), first("Ann Lea"));
  assert.notEqual(first("Ann Lee"), first("Ann Lee", 1));
});

test("drawn numbers are spread evenly from 0 to below 1", () => {
  const next = generator(1);
  const bins = Array(10).fill(0);
  for (let i = 0; i < 20_000; i++) {
    const share = next();
    assert.ok(share >= 0 && share < 1);
    bins[Math.floor(share * 10)] += 1;
  }
  for (const count of bins) assert.ok(Math.abs(count - 2000) < 200, String(bins));
});

test("a value of a range is one of its steps, from the first to the last", () => {
  assert.deepEqual([0.999, 0].map((share) => valueIn({ from: 0.1, to: 0.4, step: 0.1 }, share)), [0.4, 0.1]);
  often(500, (dice) => {
    const step = dice.one([0.001, 0.05, 0.1, 0.25, 1, 3]);
    const count = 1 + dice.below(40);
    const from = Math.round(dice.between(-100, 100)) * step;
    const range = { from, to: from + count * step, step };
    const found = new Set(Array.from({ length: count + 1 }, (_, i) => valueIn(range, (i + 0.5) / (count + 1))));
    assert.equal(found.size, count + 1);
    for (const value of found) {
      assert.ok(Math.abs((value - from) / step - Math.round((value - from) / step)) < 1e-6, String(value));
      assert.ok(value >= range.from - 1e-9 && value <= range.to + 1e-9);
    }
  });
});

test("a digest does not depend on the order of keys, and on all else", () => {
  assert.equal(digest({ a: 1, b: [true, "x"] }), digest({ b: [true, "x"], a: 1 }));
  assert.equal(digest({ a: 1, b: undefined }), digest({ a: 1 }));
  for (const other of [{ a: 2 }, { a: "1" }, { a: [1] }, { b: 1 }, { a: null }, [{ a: 1 }]]) assert.notEqual(digest(other), digest({ a: 1 }), JSON.stringify(other));
  assert.notEqual(digest([1, 2]), digest([2, 1]));
});

test("a result comes back from its code, whatever letters are in it", () => {
  often(300, (dice) => {
    const text = (most) => Array.from({ length: dice.below(most) }, () => dice.one([..."Az09 .,−°", "Ж", "ү", "💥", "\"", "\\"])).join("");
    const result = { lesson: digest(text(9)), name: text(40), answers: Array.from({ length: dice.below(30) }, () => (dice.below(4) ? { given: text(20), tries: dice.below(9), shown: dice.below(2) === 0 } : null)) };
    const code = toCode(result);
    assert.match(code, /^assur2\.[\w-]+\.[a-z0-9]+$/);
    assert.deepEqual(fromCode(` ${code}\n`), result);
  });
});

test("a slip of copying a code is found: a letter left out, doubled or exchanged", () => {
  const code = toCode({ lesson: "0123456789abcdef", name: "Ann Lee", answers: [{ given: "40,4", tries: 2, shown: false }, null, { given: "1", tries: 0, shown: true }] });
  for (let i = 0; i < code.length; i++) {
    const [before, letter, after] = [code.slice(0, i), code[i], code.slice(i + 1)];
    for (const slip of [before + after, before + letter + letter + after, `${before}${letter === "x" ? "y" : "x"}${after}`, before + letter.toUpperCase() + after]) {
      if (slip !== code) assert.equal(fromCode(slip), null, slip);
    }
  }
});

test("what is no code is none, even where its sum is right", () => {
  const packed = (value) => btoa(typeof value === "string" ? value : JSON.stringify(value)).replace(/=+$/, "");
  const signed = (text, version = "assur1") => `${version}.${text}.${hash(text).toString(36)}`;
  for (const value of [["a", "b", "3"], ["a", "b", ["3"]], ["a", "b", ["3", -1, 0]], ["a", "b", ["3", 1.5, 0]], ["a", "b", ["3", 1, 2]], ["a", "b", ["3", 1, true]], ["a", "b", [3, 1, 0]]]) {
    assert.equal(fromCode(signed(packed(value), "assur2")), null, JSON.stringify(value));
  }
  for (const value of [{}, "text", [1, "a"], ["a"], ["a", "b", 3], ["a", "b", {}], ["a", "b", "x".repeat(201)], "\xff\xfe", "[", ["a", "b".repeat(201)]]) {
    assert.equal(fromCode(signed(packed(value))), null, JSON.stringify(value));
  }
  assert.deepEqual(fromCode(signed(packed(["a", "b", null]))), { lesson: "a", name: "b", answers: [null] });
  // A code of the older version, which has no numbers of tries.
  assert.deepEqual(fromCode(signed(packed(["a", "b", "40,4"]))), { lesson: "a", name: "b", answers: [{ given: "40,4", tries: 0, shown: false }] });
  for (const text of ["", "hello", "assur1", "assur1..", "assur3.YQ.1", `${signed(packed(["a", "b"]))}.x`, "x".repeat(30_000)]) assert.equal(fromCode(text), null, text.slice(0, 40));
});

test("fields go by the names of links and points, numbers are put where the field says", () => {
  const document = { links: [{ name: "crank" }, { name: "F.K" }], points: [{ name: "H", at: [1, 2] }], wheels: [{ z: 18 }], magnets: { peak: [1, 2] } };
  assert.deepEqual(["crank.length", "F.K.length", "H.x", "nobody.length", "l1"].map((name) => fieldOf(name, document)), ["links[0].length", "links[1].length", "points[0].x", "nobody.length", "l1"]);
  const changed = withNumber(withNumber(document, "wheels[0].z", 24), "magnets.peak[1]", 3);
  assert.deepEqual([changed.wheels, changed.magnets, document.wheels, document.magnets], [[{ z: 24 }], { peak: [1, 3] }, [{ z: 18 }], { peak: [1, 2] }]);
  assert.equal(changed.links, document.links);
});
