import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import test from "node:test";
import { fileURLToPath } from "node:url";
import { list } from "../../crates/xtask/build/files.js";
import { measured } from "assur/core/units.js";
import { Words, unbroken } from "assur/core/words.js";
import { LANGUAGES, tableOf, wordsOf } from "assur/tests/words.js";

/** Plural form of a noun for a number in each language, by the rules of its grammar. */
const FORMS = {
  en: (n) => (n === 1 ? "one" : "other"),
  kk: (n) => (n === 1 ? "one" : "other"),
  ru: slavic,
  uk: slavic,
};

/** @param {number} n */
function slavic(n) {
  const [ones, tens] = [n % 10, n % 100];
  if (ones === 1 && tens !== 11) return "one";
  return ones >= 2 && ones <= 4 && (tens < 12 || tens > 14) ? "few" : "many";
}

for (const lang of LANGUAGES) {
  test(`every noun beside a number from 0 to 200 has the form of its language (${lang})`, () => {
    const table = tableOf(lang);
    const words = new Words(lang, table);
    const keys = [...table.keys()].filter((key) => key.endsWith(".other") && table.has(`${key.slice(0, -6)}.one`)).map((key) => key.slice(0, -6));
    assert.ok(keys.length >= 3, String(keys));
    for (const key of keys) {
      for (let n = 0; n <= 200; n++) {
        const form = `${key}.${FORMS[lang](n)}`;
        assert.ok(table.has(form), form);
        const said = words.counted(key, n);
        assert.equal(said, words.text(form, { count: String(n) }));
        // A text without digits, such as “one point”, is right for 1 only.
        if (!said.includes(String(n))) assert.equal(n, 1, `${form}: ${said}`);
      }
    }
  });

  test(`lengths have the unit of their document (${lang})`, () => {
    const words = wordsOf(lang);
    assert.equal(words.length("1"), "1");
    assert.equal(words.unit, "");
    for (const unit of ["mm", "cm", "m"]) {
      const measured = words.measured(unit);
      assert.notEqual(measured.unit, `unit.${unit}`);
      assert.equal(measured.length("1"), `1\u00a0${measured.unit}`);
      assert.equal(measured.measured(unit), measured);
      assert.equal(measured.measured("none").unit, "");
    }
  });
}

const table = new Map([["plain", "{a} and {b}"], ["unit.mm", "mm"], ["axis", "length, {unit}"], ["n.other", "{count} of {of}"]]);
const words = new Words("en", table);

test("placeholders are filled in once, and those that nobody fills stay", () => {
  assert.equal(words.text("plain", { a: "{b}", b: "2" }), "{b} and 2");
  assert.equal(words.text("plain", { a: "1" }), "1 and {b}");
  assert.equal(words.text("plain", { a: "$&", b: "$1" }), "$& and $1");
  assert.equal(words.text("plain", { a: "1", toString: "2" }), "1 and {b}");
  assert.equal(new Words("en", new Map([["odd", "{toString} {constructor}"]])).text("odd"), "{toString} {constructor}");
});

test("a text that is missing is its key", () => {
  assert.equal(words.text("nowhere.to.be.found"), "nowhere.to.be.found");
  assert.ok(!words.has("nowhere.to.be.found"));
});

test("what has no unit is followed by none", () => {
  assert.equal(words.text("axis"), "length");
  assert.equal(words.measured("mm").text("axis"), "length, mm");
  assert.equal(words.text("axis", { unit: "°" }), "length, °");
  for (const [text, without, mm] of [["length ({unit})", "length", "length (mm)"], ["{n} {unit} long", "{n} long", "{n} mm long"], ["from {n} {unit} to {m} {unit}", "from {n} to {m}", "from {n} mm to {m} mm"]]) {
    const own = new Words("en", new Map([["own", text], ["unit.mm", "mm"]]));
    assert.deepEqual([own.text("own"), own.measured("mm").text("own")], [without, mm]);
  }
});

test("no text of any table is left with the brackets or the comma of a unit that there is not", () => {
  const lessons = list(fileURLToPath(new URL("../lessons", import.meta.url)));
  for (const lang of LANGUAGES) {
    const told = [...lessons].filter(([name]) => name.endsWith(`words.${lang}.json`)).map(([, file]) => Object.entries(JSON.parse(readFileSync(file, "utf8"))));
    const texts = [...tableOf(lang), ...told.flat()].filter(([, text]) => text.includes("{unit}"));
    assert.ok(texts.length >= 40, String(texts.length));
    for (const [key, text] of texts) {
      const said = new Words(lang, new Map([[key, text]])).text(key);
      assert.doesNotMatch(said, /\(\s*\)|\[\s*\]|^[\s,]|[\s,]$| [ ,.;:]|, ,/u, `${lang} ${key}: ${said}`);
    }
  }
});

test("a form that a table lacks is the usual one", () => {
  assert.equal(words.counted("n", 1, { of: "x" }), "1 of x");
  const russian = tableOf("ru");
  assert.equal(new Words("ru", russian).counted("wheels.teeth", 25), "25 зубьев");
  russian.delete("wheels.teeth.many");
  assert.equal(new Words("ru", russian).counted("wheels.teeth", 25), "25 зуба");
});

test("tables are put one over the other, each is fetched once, and one that failed is asked for again", async (t) => {
  let down = true;
  const asked = [];
  t.mock.method(globalThis, "fetch", async (url) => {
    asked.push(String(url).split("/").slice(-2).join("/"));
    if (down && String(url).includes("own")) return new Response("", { status: 503 });
    return Response.json(String(url).includes("own") ? { a: "own" } : { a: "page", b: "page" });
  });
  await assert.rejects(Words.load("en", ["lang/*", "own/*"]), /503/);
  down = false;
  const loaded = await Words.load("en", ["lang/*", "own/*"]);
  assert.deepEqual([loaded.text("a"), loaded.text("b")], ["own", "page"]);
  await Words.load("en", ["lang/*", "own/*"]);
  assert.deepEqual(asked.toSorted(), ["lang/en.json", "own/en.json", "own/en.json"]);
});

test("no line breaks between what is read as one", () => {
  const shown = (text) => unbroken(text).replaceAll("\u00a0", "_");
  const all = {
    "{left} mm and 5 % of {n} kB, {value} {unit}": "{left}_mm and 5_% of {n}_kB, {value}_{unit}",
    "at 60 min⁻¹, 2 N·m; {n} mirrors, 5 sides": "at 60_min⁻¹, 2_N·m; {n} mirrors, 5 sides",
    "скорость {v} мм/с, {n} механизмов, {t} с.": "скорость {v}_мм/с, {n} механизмов, {t}_с.",
    "At φ₁ = {phi} and W = 3·5 − 2 = −1; {a} = 2": "At φ₁_=_{phi} and W_=_3·5 − 2_=_−1; {a}_=_2",
    "z₄ = z₁ + 2z₂, J q′ = −Φ": "z₄ = z₁ + 2z₂, J q′_=_−Φ",
    "Esc — конец": "Esc_— конец",
    "Случаи рис. 4, fig. 2a, в конфиг. Нет": "Случаи рис._4, fig._2a, в_конфиг. Нет",
    "E. W. Blake, 1858; Дж. Уатт; (F. Grashof)": "E._W._Blake, 1858; Дж. Уатт; (F._Grashof)",
    "и в доме, звено (с ползуном) а {n}": "и_в_доме, звено (с_ползуном) а_{n}",
    "a link of a crank": "a link of a crank",
  };
  for (const [text, expected] of Object.entries(all)) assert.equal(shown(text), expected);
});

test("a number stays with its unit", () => {
  assert.deepEqual([["5", ""], ["5", "°"], ["5", "°/s"], ["5", "mm"]].map((one) => measured(...one)), ["5", "5°", "5°/s", "5\u00a0mm"]);
});

test("tables are read with spaces that hold together", async (t) => {
  t.mock.method(globalThis, "fetch", async () => Response.json({ a: "{n} mm" }));
  assert.equal((await Words.load("en", ["held/*"])).text("a", { n: "5" }), "5\u00a0mm");
});

test("a value is not mistaken for its place in any language, also with decimal commas", () => {
  for (const lang of LANGUAGES) {
    const words = wordsOf(lang);
    const [value, angle] = [words.numbers.fixed(-3.6, 1), `${words.numbers.fixed(117.2, 1)}°`];
    for (const text of [words.text("plots.mark", { value, angle }), words.text("told.min", { value, angle }), words.text("told.max", { value, angle })]) {
      assert.doesNotMatch(text, /\d, /, `${lang}: ${text}`);
    }
  }
});
