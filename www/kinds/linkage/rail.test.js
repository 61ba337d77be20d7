// Tests of the rows of the rail: each names the link and the points of its dimension, once.
import assert from "node:assert/strict";
import test from "node:test";
import { all } from "assur/tests/document.js";
import { LinkageRail } from "assur/kinds/linkage/rail.js";
import { initialState } from "assur/state/state.js";
import { newEngine, stateOf } from "assur/tests/engine.js";
import { snapshotOf } from "assur/tests/shown.js";

const engine = newEngine();
const page = { engine, drafts: { has: () => false, drop() {}, text: () => null } };

/** Visible names and accessible labels of the fields of a linkage: those of links and slides, and those of fixed pivots. */
function rows(state) {
  const snapshot = snapshotOf(engine, state);
  new LinkageRail(page).render(snapshot);
  const fields = all(globalThis.document.getElementById("fold-dimensions").lastElementChild, "[data-field]");
  const isOfPoint = (row) => row.getAttribute("data-field").startsWith("points");
  return [fields.filter((row) => !isOfPoint(row)), fields.filter(isOfPoint)].map((rows) => rows.map((row) => {
    const field = row.querySelector("[type=text]");
    return [row.querySelector("label").textContent, field.getAttribute("aria-label")];
  }));
}

test("points that the symbol says are not in the name beside it", () => {
  const [links] = rows(stateOf(engine, "crank-rocker", { lang: "en" }));
  assert.deepEqual(links.slice(0, 4), [
    ["lAB crank", "Length of link crank"],
    ["lBC coupler", "Side of link coupler, B\u2060–\u2060C"],
    ["lBM coupler", "Side of link coupler, B\u2060–\u2060M"],
    ["lCM coupler", "Side of link coupler, C\u2060–\u2060M"],
  ]);
  assert.deepEqual(links[4], ["∠CBM coupler", "Angle of link coupler, C\u2060–\u2060B\u2060–\u2060M"]);
});

test("points that no symbol can carry stand in the name, on one line", () => {
  const state = structuredClone(stateOf(engine, "crank-rocker", { lang: "en" }));
  const text = JSON.stringify(state.document).replaceAll('"M"', '"Middle"').replaceAll("M.", "Middle.");
  const [links] = rows(initialState("linkage", JSON.parse(text), { lang: "en" }));
  assert.equal(links[2][0], "l coupler, B\u2060–\u2060Middle");
  assert.equal(links[4][0], "∠ coupler, C\u2060–\u2060B\u2060–\u2060Middle");
});

test("an offset is of a point, from the line that the name says", () => {
  const [links, pivots] = rows(stateOf(engine, "slider-crank-offset", { lang: "en" }));
  assert.deepEqual(links.at(-1), ["eC F\u2060–\u2060G", "Offset of link slider, C → F\u2060–\u2060G"]);
  assert.deepEqual(pivots.map(([text]) => text), ["xA", "yA", "xF", "yF", "xG", "yG"]);
});
