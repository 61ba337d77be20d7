// The language that was chosen: kept by itself, for addresses that say nothing of a language.
import assert from "node:assert/strict";
import test from "node:test";
import { chooseLanguage, chosenLanguage } from "assur/app/language.js";
import { Words } from "assur/core/words.js";
import { Page } from "assur/tests/page.js";
import { wordsOf } from "assur/tests/words.js";

const kept = new Map();
globalThis.localStorage = { getItem: (key) => kept.get(key) ?? null, setItem: (key, text) => kept.set(key, text) };
globalThis.Node = class Node extends EventTarget {};
globalThis.HTMLSelectElement = class HTMLSelectElement extends Node {
  value = "";
  append() {}
};

/**
 * Chooses a language by hand.
 * @param {import("node:test").TestContext} t
 * @param {string} lang
 * @param {object} habits of the page
 */
function choose(t, lang, habits) {
  kept.clear();
  t.mock.method(Words, "load", async (of) => wordsOf(of));
  const select = new HTMLSelectElement();
  globalThis.document = { getElementById: () => select, createElement: () => ({ setAttribute() {}, append() {} }) };
  const page = Object.assign(new Page("mixer-a"), { habits, hear() {} });
  // What the state says by itself, as that of a link, is no choice.
  chooseLanguage(page);
  assert.deepEqual([select.value, kept.size], ["en", 0]);
  select.value = lang;
  select.dispatchEvent(new Event("change"));
  assert.equal(page.store.get().view.lang, lang);
}

test("the language that a reader chooses is known on the next visit", (t) => {
  choose(t, "uk", { lang: "en" });
  assert.equal(chosenLanguage(), "uk");
});

test("what another page shows in a frame keeps no language", (t) => {
  choose(t, "uk", { lang: "en", embedding: {} });
  assert.equal(chosenLanguage(), null);
});

test("a language that the page does not have was never chosen", () => {
  kept.set("assur.lang", "fr");
  assert.equal(chosenLanguage(), null);
});
