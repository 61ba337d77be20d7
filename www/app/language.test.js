// Tests of the language that the reader chooses, which the browser stores apart from the state.
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
 * @param {(of: string) => Promise<Words>} load
 * @returns {Promise<Page>} resolves after the words have loaded or failed to load
 */
async function choose(t, lang, habits, load = async (/** @type {string} */ of) => wordsOf(of)) {
  kept.clear();
  t.mock.method(Words, "load", load);
  const select = new HTMLSelectElement();
  globalThis.document = { getElementById: () => select, createElement: () => ({ setAttribute() {}, append() {} }) };
  const page = Object.assign(new Page("mixer-a"), { habits, setLanguage() {} });
  // The language of a state, for example from a link, is not a choice of the reader.
  chooseLanguage(page);
  assert.deepEqual([select.value, kept.size], ["en", 0]);
  select.value = lang;
  select.dispatchEvent(new Event("change"));
  assert.equal(page.store.get().view.lang, lang);
  for (let turns = 0; turns < 50; turns++) await null;
  return page;
}

test("the language that a reader chooses is known on the next visit", async (t) => {
  await choose(t, "uk", { lang: "en" });
  assert.equal(chosenLanguage(), "uk");
});

test("what another page shows in a frame keeps no language", async (t) => {
  await choose(t, "uk", { lang: "en", embedding: {} });
  assert.equal(chosenLanguage(), null);
});

test("without a network the page goes on in the language it speaks, and keeps none that did not come", async (t) => {
  let asked = 0;
  const page = await choose(t, "uk", { lang: "en" }, async (lang) => {
    asked += 1;
    if (lang !== "en") throw new TypeError("no net");
    return wordsOf(lang);
  });
  const select = document.getElementById("lang");
  // The reader chooses again while the words of the first choice are loading.
  for (const lang of ["ru", "uk"]) {
    select.value = lang;
    select.dispatchEvent(new Event("change"));
  }
  for (let turns = 0; turns < 50; turns++) await null;
  assert.deepEqual([page.store.get().view.lang, select.value, chosenLanguage()], ["en", "en", null]);
  assert.ok(asked < 10, String(asked));
});

test("a language that the page does not have was never chosen", () => {
  kept.set("assur.lang", "fr");
  assert.equal(chosenLanguage(), null);
});
