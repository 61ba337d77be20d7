import assert from "node:assert/strict";
import test from "node:test";
import { Numbers, parseNumber, readable } from "assur/core/numbers.js";
import { often } from "assur/tests/random.js";
import { LANGUAGES } from "assur/tests/words.js";

const all = LANGUAGES.map((lang) => [lang, new Numbers(lang)]);

test("a number is read with a point or a comma, spaces, any minus and a degree sign", () => {
  const read = new Map([
    ["0.5", 0.5], ["0,5", 0.5], [",5", 0.5], [".5", 0.5], ["5,", 5], ["+5", 5], ["-5", -5], ["−5", -5], ["−5 °", -5], ["12 345,5", 12345.5],
    ["12\u00a0345", 12345], ["12\u202f345", 12345], ["1e3", 1000], ["1E-3", 0.001], ["1,5e+2", 150], [" 7 ", 7], ["007", 7], ["-0", -0], ["\t3\n", 3], ["2Е9", 2e9], ["−1,5е−7", -1.5e-7],
  ]);
  for (const [text, value] of read) assert.equal(parseNumber(text), value, JSON.stringify(text));
});

test("what is not one finite number is none", () => {
  const none = ["", " ", "°", "-", "+", ".", ",", "abc", "NaN", "Infinity", "1e999", "-1e999", "0x10", "1_000", "1.2.3", "1,2,3", "0,0,", "--1", "+-1", "1-", "18;18", "1e", "e5", "Е5", "2ЕЕ9", "1e1.5", "½", "٣", "1/2", "1+1"];
  for (const text of none) assert.equal(parseNumber(text), null, JSON.stringify(text));
});

for (const [lang, numbers] of all) {
  test(`a number written in full is read as the same (${lang})`, () => {
    often(3000, (dice) => {
      const value = dice.between(-1, 1) * 10 ** (dice.below(15) - 5);
      // Numbers that are written with a power of ten have a test of their own.
      if (Math.abs(value) >= 1e9 || Math.abs(value) < 1e-6) return;
      const short = Number(value.toPrecision(15));
      assert.equal(parseNumber(numbers.exact(short)), short, numbers.exact(short));
      assert.equal(parseNumber(`${numbers.exact(short)}°`), short);
    });
    assert.equal(parseNumber(numbers.exact(0)), 0);
  });

  test(`a number with a power of ten is read as the same (${lang})`, () => {
    often(1000, (dice) => {
      const value = dice.number();
      assert.equal(parseNumber(numbers.exact(value)), value, numbers.exact(value));
    });
  });

  test(`a number is off by no more than half its last digit (${lang})`, () => {
    often(1000, (dice) => {
      const value = dice.between(-1000, 1000);
      const decimals = dice.below(7);
      for (const written of [numbers.fixed(value, decimals), numbers.upTo(value, decimals)]) {
        assert.ok(Math.abs(parseNumber(written) - value) <= 0.5000001 * 10 ** -decimals, written);
      }
      assert.ok(Math.abs(parseNumber(numbers.short(value)) / value - 1) <= 0.5001e-3, numbers.short(value));
      assert.ok(Math.abs(parseNumber(numbers.brief(value)) / value - 1) <= 0.5001e-5, numbers.brief(value));
    });
  });

  test(`a number has as many decimals as asked for, the sign of the language and no grouping (${lang})`, () => {
    const sign = lang === "en" ? "." : ",";
    assert.equal(numbers.comma, lang !== "en");
    assert.equal(numbers.fixed(1234567.5, 2), `1234567${sign}50`);
    assert.equal(numbers.fixed(-0.25, 2), `−0${sign}25`);
    assert.equal(numbers.upTo(1.5, 4), `1${sign}5`);
    assert.equal(numbers.upTo(2, 4), "2");
    assert.equal(numbers.short(0.123456), `0${sign}1235`);
    assert.equal(numbers.brief(0.123456789), `0${sign}123457`);
    assert.equal(numbers.exact(0.1 + 0.2), `0${sign}3`);
    // A negative number that is rounded to zero has no minus.
    assert.equal(numbers.fixed(-0.001, 1), `0${sign}0`);
  });

  test(`only beyond a milliard or a millionth has a number a power of ten (${lang})`, () => {
    for (const plain of [0, 1e-6, 999_999_999, -999_999_999, -1e-6]) assert.match(numbers.exact(plain), /^−?[\d.,]+$/);
    assert.match(numbers.short(-2.465e-32), /^−2[.,]465·10⁻³²$/);
    assert.match(numbers.short(1e12), /^1·10¹²$/);
    for (const huge of [1e9, -1e9, 9.9e-7, 1e300]) assert.match(numbers.exact(huge), /^−?[\d.,]+\p{L}−?\d+$/u);
  });
}

test("Kazakh numbers are written as Russian ones", () => {
  const [ru, kk] = ["ru", "kk"].map((lang) => new Numbers(lang));
  often(300, (dice) => {
    const value = dice.number();
    assert.equal(kk.exact(value), ru.exact(value));
  });
});

test("a number in motion keeps half of its decimals", () => {
  assert.deepEqual([0, 1, 2, 3, 4, 5].map((decimals) => readable(decimals, true)), [0, 0, 1, 1, 2, 2]);
  assert.deepEqual([0, 1, 2, 3].map((decimals) => readable(decimals, false)), [0, 1, 2, 3]);
});
