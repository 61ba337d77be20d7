// Tests of URLs of PMKS+ and files of Linkage, whole and damaged. The tests of assur-import test the content of the
// results.
import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import test from "node:test";
import { lineOf } from "assur/app/notices.js";
import { isForeign, takeFile, takeForeign } from "assur/app/opening.js";
import init from "assur/pkg/assur_web.js";
import { newEngine } from "assur/tests/engine.js";
import { LANGUAGES, wordsOf } from "assur/tests/words.js";

const engine = newEngine();
const habits = { calm: false, lang: "uk" };
const words = wordsOf("en");
const PUBLISHED = new URL("../../crates/assur-import/tests/published/", import.meta.url);
const read = (name) => readFileSync(new URL(`linkage2/${name}`, PUBLISHED), "utf8");

/**
 * URL of the punch press of PMKS+, with a force and masses. Its source is in
 * crates/assur-import/tests/published/pmks.txt.
 */
const LINK = "https://app.pmksplus.com/?2P.Ay,1E8.K,0.1011.MA,A,0,0,0.GB,B,0,Im,0.GC,C,0,0r8,0.LP,P,0,0r8,OZ.."
  + "YRAB,Crank,VG,o,0,9O,c5cae9,A,B,,.YRBC,Connecting rod,ku,6G,0,0HC,303e9f,B,C,,.YPCP,CP,1Tm,0,0,0,,C,P,,.."
  + "2F1,BC,F1,0,0r8,0,0bW,1Xg0..N_J";

/** URL of the four-bar of issue 91 of PMKS+, in the first form of these URLs. */
const FIRST = "https://pmksplus.mech.website/?j=A,4.1,3.75,AB,R,t,0,0.1,t,%0AB,1.244,0.196,AB%7CCBE,R,f,0,0.1,f,%0A"
  + "C,-2.32,-2.293,DC%7CCBE,R,f,0,0.1,f,%0AD,0.165,1.322,DC,R,t,0,0.1,f,%0AE,-2.591,1.657,CBE,R,f,0,0.1,f,%0A"
  + "&l=AB,1,1,1.9,3.2,A%7CB,,l%0ADC,1,1,2.0,2.5,C%7CD,,l%0ACBE,1,1,1.5,2.2,B%7CC%7CE,,et&f=&pp=&tp=&s=10,false,false,cm";

test("a link of PMKS+ is opened, with what was left out of it", async () => {
  const { state, failure } = await takeForeign(LINK, null, engine, habits);
  assert.deepEqual(state.document.links.map(({ name }) => name), ["Crank", "Connecting rod", "C"]);
  assert.equal(state.view.lang, "uk");
  const said = lineOf(failure, words);
  for (const part of ["PMKS+, app.pmksplus.com was opened", "Forces are left out: F1.", "Crank was driven at −20 rpm"]) assert.ok(said.includes(part), said);
  assert.ok(lineOf(failure, wordsOf("ru")).includes("Силы опущены: F1."));
});

test("a link of the first form of PMKS+ is opened", async () => {
  const { state, failure } = await takeForeign(FIRST, null, engine, habits);
  assert.equal(state.document.unit, "cm");
  const said = lineOf(failure, words);
  assert.ok(said.includes("pmksplus.mech.website") && said.includes("AB was driven at 10 rpm"), said);
  assert.ok(lineOf(failure, wordsOf("ru")).includes("pmksplus.mech.website): "));
});

test("a file of Linkage has its own name for a title", async () => {
  const { state } = await takeFile(new File([read("jansen.linkage2")], "Jansen’s leg.linkage2"), engine, habits);
  assert.deepEqual([state.document.title, state.document.source, state.document.links.length], ["Jansen’s leg", "Linkage (.linkage2)", 7]);
  const { failure } = await takeFile(new File([read("piston.linkage2")], "piston.LINKAGE2"), engine, habits);
  assert.match(lineOf(failure, words), /piston.*only drawings: 6/);
  const long = await takeFile(new File([read("jansen.linkage2")], `${"x".repeat(500)}.linkage2`), engine, habits);
  assert.equal(long.state.document.title, "x".repeat(400));
});

test("every published file opens, and what was lost is a sentence in every language", async () => {
  const tables = LANGUAGES.map((lang) => wordsOf(lang));
  const names = readdirSync(new URL("linkage2/", PUBLISHED));
  assert.ok(names.length > 20);
  for (const name of names) {
    const { state, failure } = await takeFile(new File([read(name)], name), engine, habits);
    if (!state) {
      assert.equal(failure.kind, "file", name);
    } else {
      engine.set(state);
      assert.ok(failure === null || failure.kind === "import", name);
    }
    for (const table of failure ? tables : []) {
      const said = lineOf(failure, table);
      assert.ok(said.includes(name) && !/[{}]|import\.\w|problem\.\w|NaN|undefined/.test(said), said);
    }
  }
});

test("damaged ones are named, with the place of the damage", async () => {
  const jansen = read("jansen.linkage2");
  for (const [name, text, part] of [
    ["a.linkage2", jansen.slice(0, 500), "Line 9"],
    ["<img src=x>.linkage2", jansen.replace("352", "<img src=x>"), "<img src=x>.linkage2"],
    ["b.linkage2", jansen.replace("\"352\"", "\"wide\""), "connector 1, x: wide is not a usable number"],
    ["c.linkage2", "<linkage2></linkage2>", "It contains no links of a mechanism."],
    ["d.pmks", "2P.Fe.K,0.1011.MA,A,0,0,0...N_9", "check character"],
  ]) {
    const { state, failure } = await takeFile(new File([text], name), engine, habits);
    assert.equal(state, null);
    const said = lineOf(failure, words);
    assert.ok(said.includes(name) && said.includes(part), said);
  }
  const cut = await takeForeign(LINK.slice(0, -12), null, engine, habits);
  assert.match(lineOf(cut.failure, words), /^The pasted text could not be opened.*check character/);
  const other = await takeForeign("some other text", null, engine, habits);
  assert.match(lineOf(other.failure, words), /neither a PMKS\+ link nor a Linkage file/);
});

test("only what is meant as another program's is taken for it", () => {
  for (const text of [LINK, FIRST, read("jansen.linkage2"), LINK.slice(0, -12)]) assert.ok(isForeign(text, engine), text.slice(0, 60));
  for (const text of ["", "some other text", "{\"format\":2}", "https://example.org/?2P", "[1,2]"]) assert.ok(!isForeign(text, engine), text);
});

test("what does not move is opened as a drawing", async () => {
  const { state } = await takeFile(new File([read("jansen.linkage2").replace(" input=\"true\"", "")], "e.linkage2"), engine, habits);
  assert.equal(state.kind, "draft");
  assert.ok(engine.set(state).reasons?.some(({ code }) => code === "no_driver"), JSON.stringify(Object.keys(engine.set(state))));
});

test("a text or file that is too large is refused, and the engine's memory does not grow", async () => {
  const { memory } = await init();
  const before = memory.buffer.byteLength;
  const large = `<linkage2>${" ".repeat(100_000_000)}</linkage2>`;
  assert.ok(isForeign(large, engine));
  for (const { failure } of [await takeForeign(large, null, engine, habits), await takeFile(new File([large], "f.linkage2"), engine, habits)]) {
    assert.match(lineOf(failure, words), /too large/);
  }
  assert.ok(memory.buffer.byteLength - before < 2 ** 23, `${memory.buffer.byteLength - before} bytes`);
});
