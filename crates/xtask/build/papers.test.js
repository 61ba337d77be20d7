import assert from "node:assert/strict";
import { existsSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { built, listed, mathml } from "./papers.js";
import { ROOT } from "./temporary.js";

const VERDICTS = Object.freeze(["right", "misprint", "scan", "false", "unprovable"]);
const LESSONS = path.join(ROOT, "www/lessons");
const read = (/** @type {string} */ name) => readFileSync(path.join(ROOT, name), "utf8");

/** The ids of all items of all papers. */
const ALL = read("tests/data/papers.txt").trim().split("\n");

const PAPERS = readdirSync(LESSONS)
  .filter((lesson) => existsSync(path.join(LESSONS, lesson, "paper.json")))
  .map((lesson) => ({ lesson, items: /** @type {import("./papers.js").Item[]} */ (JSON.parse(read(`www/lessons/${lesson}/paper.json`))) }));

test("a lesson with a paper places every item of it once", () => {
  assert.ok(PAPERS.length > 0);
  for (const { items } of PAPERS) {
    const [paper] = items[0].item.split(".");
    assert.deepEqual(items.map(({ item }) => item).sort(), ALL.filter((id) => id.startsWith(`${paper}.`)).sort());
  }
});

test("items have a known verdict, formulas that can be set, and what holds instead where they do not", () => {
  for (const { item, printed = [], instead = [], verdict = "right" } of PAPERS.flatMap(({ items }) => items)) {
    assert.ok(VERDICTS.includes(verdict), item);
    for (const formula of [...printed, ...instead]) assert.match(mathml(formula), /^<math[^>]*>.*<\/math>$/, item);
    if (printed.length > 0 && ["misprint", "false"].includes(verdict)) assert.ok(instead.length > 0, item);
  }
});

test("an item names what there is: a symbol of the engine, a test", () => {
  for (const { item, engine, test: check } of PAPERS.flatMap(({ items }) => items)) {
    for (const [place, before] of /** @type {const} */ ([[engine, "(fn|const|enum|struct) "], [check, "fn "]])) {
      if (!place) continue;
      const [file, symbol] = place.split(" ");
      assert.match(read(file), new RegExp(`\\b${before}${symbol}\\b`), `${item}: ${place}`);
    }
    assert.ok(!engine || file(engine) !== file(check ?? ""), item);
  }
});

/** @param {string} place */
function file(place) {
  return place.split(" ")[0];
}

test("the tests that docs/errata.md names are there", () => {
  const tests = ["tests/errata.rs", ...readdirSync(path.join(ROOT, "tests/errata"), { recursive: true, encoding: "utf8" }).map((name) => `tests/errata/${name}`)];
  const written = tests.filter((name) => name.endsWith(".rs")).map(read).join("\n");
  const named = [...read("docs/errata.md").matchAll(/`(?:tests\/errata\.rs::)?((?:mixer|class4|synthesis|mobility|differential)_[a-z0-9_]+)`/g)].map(([, name]) => name);
  assert.ok(named.length > 50, `${named.length}`);
  for (const name of named) assert.match(written, new RegExp(`fn ${name}\\(`), name);
});

test("equations and worked numbers have a test", () => {
  for (const { item, printed = [], test: check } of PAPERS.flatMap(({ items }) => items)) if (printed.length > 0 || /\.case/.test(item)) assert.ok(check, item);
});

test("the document has the table", () => {
  const text = listed(PAPERS, ALL.length);
  const place = path.join(ROOT, "docs/papers.md");
  if (process.env.ASSUR_WRITE) writeFileSync(place, text);
  assert.equal(readFileSync(place, "utf8"), text);
});

test("the page is given formulas as MathML, without styles, and nothing of where an item stands in the sources", () => {
  const [row] = JSON.parse(built(JSON.stringify([{ item: "1", step: "end", printed: ["\\bar{l}_1=\\overline{AB}"], engine: "a b", test: "c d" }])));
  assert.deepEqual(Object.keys(row), ["item", "step", "verdict", "printed", "instead", "shown"]);
  assert.match(row.printed[0], /<mover>.*<mo[^>]*>.<\/mo><\/mover>/);
  assert.doesNotMatch(row.printed[0], /style=|class=|menclose/);
  assert.throws(() => built(JSON.stringify([{ item: "1", step: "end", printed: ["\\nothing"] }])), /nothing/);
});
