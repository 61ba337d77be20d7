import assert from "node:assert/strict";
import test from "node:test";
import { LANGUAGES } from "assur/core/words.js";
import { OTHER_NAMES } from "assur/gallery/other-names.js";
import { findable, findableMechanism, found } from "assur/gallery/search.js";
import { newEngine } from "assur/tests/engine.js";
import { wordsOf } from "assur/tests/words.js";

const card = findable({ names: ["Watt’s six-bar I", "Steam engine", "Чебышёв: механизм"] }, "III");

test("a card is found by how its words begin, in any order and in any letters", () => {
  for (const query of ["", "watt", "WATT six", "bar steam", "чебы", "eng wat", "  watt,  engine!", "Watt's", "Чебышев", "sixbar"]) assert.ok(found(card, query), query);
  for (const query of ["att", "watt lever", "gine", "шёв"]) assert.ok(!found(card, query), query);
});

test("the numeral of a class is a whole word, typed with Latin or Cyrillic letters or as a number", () => {
  for (const query of ["iii", "III", "ііі", "3"]) assert.ok(found(card, query), query);
  for (const query of ["ii", "iv", "4", "v"]) assert.ok(!found(card, query), query);
  assert.ok(found(findable({ names: ["x"] }, "II"), "ii") && !found(findable({ names: ["x"] }, "III"), "ii"));
});

test("a word of a sentence is not found by three letters that begin it", () => {
  const { names, about } = { names: ["Class V"], about: ["positions by Newton’s method, a cam"] };
  for (const query of ["newton", "newt", "method", "cam"]) assert.ok(found(findable({ names, about }), query), query);
  for (const query of ["new", "met"]) assert.ok(!found(findable({ names, about }), query), query);
});

const engine = newEngine();
const tables = LANGUAGES.map(wordsOf);
const all = engine.functions.shelves().map((shelf) => ({ shelf, words: findableMechanism(shelf, engine.catalogue.preset(shelf.id).kind, tables) }));
const search = (query) => all.filter(({ words }) => found(words, query)).map(({ shelf: { id } }) => id).sort();

test("mechanisms are found by other names, in every language and spelling", () => {
  for (const query of ["theo jansen", "strandbeest", "Янсен", "Янсена", "тео янсен", "beach animal"]) assert.deepEqual(search(query), ["jansen"], query);
  for (const query of ["Чебышёв", "Чебышев", "Чебишов", "Chebyshev", "Tschebyscheff"]) assert.deepEqual(search(query), ["chebyshev", "hoeken"], query);
  const bars = all.map(({ shelf: { id } }) => id).filter((id) => /\b4-bar/.test(OTHER_NAMES[id])).sort();
  for (const query of ["4-bar", "4bar", "4 bar", "4-звенник"]) assert.deepEqual(search(query), bars, query);
  for (const query of ["fourbar", "four-bar"]) assert.ok(bars.every((id) => search(query).includes(id)), query);
  for (const query of ["slider crank", "slidercrank", "crank slider", "қосиінді-сырғақты"]) assert.ok(search(query).includes("slider-crank"), query);
});

test("nothing is found by chance", () => {
  for (const query of ["cam", "new", "geneva"]) assert.deepEqual(search(query), [], query);
  const second = all.filter(({ shelf }) => shelf.class === "II").map(({ shelf: { id } }) => id).sort();
  for (const query of ["Class II", "2 класс", "клас 2", "II класс"]) assert.deepEqual(search(query), second, query);
  assert.ok(!second.includes("stephenson-2") && search("stephenson ii").includes("stephenson-2"));
});

test("every other name is of a mechanism of the catalogue", () => {
  for (const id of Object.keys(OTHER_NAMES)) assert.ok(engine.catalogue.preset(id), id);
});
