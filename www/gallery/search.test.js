import assert from "node:assert/strict";
import test from "node:test";
import { findable, found } from "assur/gallery/search.js";

const card = findable(["Watt’s six-bar I", "Steam engine", "Чебышёв: механизм"], "III");

test("a card is found by how its words begin, in any order and in any letters", () => {
  for (const query of ["", "watt", "WATT six", "bar steam", "чебы", "eng wat", "  watt,  engine!"]) assert.ok(found(card, query), query);
  for (const query of ["att", "watt lever", "gine", "шёв"]) assert.ok(!found(card, query), query);
});

test("the numeral of a class is a whole word, typed with Latin or Cyrillic letters or as a number", () => {
  for (const query of ["iii", "III", "ііі", "3"]) assert.ok(found(card, query), query);
  for (const query of ["ii", "iv", "4", "v"]) assert.ok(!found(card, query), query);
  assert.ok(found(findable(["x"], "II"), "ii") && !found(findable(["x"], "III"), "ii"));
});
