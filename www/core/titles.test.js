import assert from "node:assert/strict";
import test from "node:test";
import { sourceOf, titleOf } from "assur/core/titles.js";
import { newEngine, stateOf } from "assur/tests/engine.js";
import { LANGUAGES, wordsOf } from "assur/tests/words.js";

const engine = newEngine();

test("notes on linkages of the catalogue are in the reader’s language", () => {
  const noted = engine.catalogue.presets.filter(({ kind, document }) => kind === "linkage" && document.source);
  assert.ok(noted.length > 40, String(noted.length));
  for (const lang of LANGUAGES) {
    const words = wordsOf(lang);
    for (const { id } of noted) {
      const { document } = stateOf(engine, id);
      assert.ok(words.has(`source.${id}`), `${lang} ${id}`);
      assert.equal(sourceOf(document, engine, words), words.text(`source.${id}`));
      assert.equal(sourceOf({ ...document, source: "Measured." }, engine, words), "Measured.");
      assert.equal(sourceOf({ ...document, source: undefined }, engine, words), "");
      assert.equal(sourceOf({ ...document, origin: undefined }, engine, words), document.source);
    }
  }
  // No two notes are the same, in any language.
  const all = LANGUAGES.flatMap((lang) => noted.map(({ id }) => wordsOf(lang).text(`source.${id}`)));
  assert.equal(new Set(all).size, all.length);
});

test("what is from the catalogue is called as in the gallery, all else by its title or its kind", () => {
  const words = wordsOf("ru");
  const { kind, document } = stateOf(engine, "crank-rocker");
  assert.notEqual(document.title, words.text("gallery.crank-rocker"));
  assert.equal(titleOf({ kind, document }, engine, words), words.text("gallery.crank-rocker"));
  assert.equal(titleOf({ kind, document: { ...document, origin: undefined } }, engine, words), document.title);
  assert.equal(titleOf({ kind, document: { ...document, origin: undefined, title: "" } }, engine, words), words.text("kind.linkage"));
  assert.equal(titleOf(stateOf(engine, "mixer-b"), engine, words), words.text("gallery.mixer-b"));
});
