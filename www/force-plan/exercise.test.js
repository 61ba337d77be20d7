// Tests of the exercise on a free body: the student chooses senses and point of moments, the engine judges the answers.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import test from "node:test";
import { all } from "assur/tests/document.js";
import { Words } from "assur/core/words.js";
import { Exercise } from "assur/force-plan/exercise.js";
import { tableOf } from "assur/tests/words.js";
import { Page } from "assur/tests/page.js";

const later = Object.entries(JSON.parse(readFileSync(new URL("../forces/words.en.json", import.meta.url), "utf8")));
const words = new Words("en", new Map([...tableOf("en"), ...later]), "m");
const INPUT = Math.PI / 3;
const UNITS = { force: "N", torque: "N·m", length: "m" };

/** The rod of a slider-crank at rest under its weight, with its sheet. */
function rod() {
  const { engine, store } = new Page("slider-crank", { phi_deg: 60, omega: 0, playing: false });
  const state = store.get();
  const links = state.document.links.map((link) => (link.name === "rod" ? { ...link, mass: 2 } : link));
  engine.set({ ...state, document: { ...state.document, links, gravity: [0, -10] } });
  const show = () => exercise.show({ input: INPUT, link: 1, name: "2: rod", units: UNITS });
  const exercise = new Exercise({ words, engine, redraw: () => show() });
  show();
  document.body.replaceChildren(exercise.element);
  const { element } = exercise;
  const about = element.querySelector("#force-exercise-about");
  const rows = () => all(element, "tbody tr").map((row) => ({ signs: all(row, "select").slice(-3), sense: all(row, "select").at(-4), arm: row.querySelector("input") }));
  const addends = (reversed = []) => engine.simulator.equilibrium(INPUT, { link: 1, about: about.selectedIndex, reversed, answers: [] }).addends;
  return { exercise, element, about, rows, addends, show };
}

/** Fills in the right signs, and the arms of given forces. */
function answer(rows, addends) {
  addends.forEach(({ factors, direction }, row) => {
    rows[row].signs.forEach((field, k) => {
      if (!field.disabled) field.value = factors[k] > 0 ? "+" : factors[k] < 0 ? "−" : "0";
    });
    if (direction !== null) rows[row].arm.value = Math.abs(factors[2]).toFixed(3);
  });
}

test("right signs and arms are right, wrong ones are marked, and moments follow the point", () => {
  const { element, about, rows, addends } = rod();
  assert.deepEqual([...about.options].slice(0, 2).map(({ textContent }) => textContent), ["B", "C"]);
  const fields = () => rows().flatMap(({ signs }) => signs).filter(({ disabled }) => !disabled);
  const check = () => {
    element.querySelector("#force-exercise-check").click();
    return element.querySelector("#force-exercise-said").textContent;
  };
  assert.equal(check(), `Wrong: 0; not yet answered: ${fields().length}.`);
  about.selectedIndex = 1;
  about.dispatchEvent(new Event("change"));
  answer(rows(), addends());
  assert.match(check(), /^All is right/);
  assert.equal(all(element, "#force-exercise-found [data-force]").length, addends().length);
  // The weight turns the rod one way about one end, and the other way about the other.
  const turn = () => Math.sign(addends().find(({ symbol }) => symbol === "G₂").factors[2]);
  const first = turn();
  about.selectedIndex = 0;
  about.dispatchEvent(new Event("change"));
  assert.equal(turn(), -first);
  assert.match(check(), /^Wrong: [1-9]\d*; not yet answered: 0\.$/);
  assert.ok(all(element, "[aria-invalid]").length > 0);
  assert.equal(all(element, "#force-exercise-found [data-force]").length, 0);
  // An arm that is no number is wrong, too.
  answer(rows(), addends());
  assert.match(check(), /^All is right/);
  rows()[0].arm.value = "long";
  assert.equal(check(), "Wrong: 1; not yet answered: 0.");
});

test("an unknown in the opposite sense has opposite signs and an opposite value", () => {
  const { exercise, element, rows, addends } = rod();
  const value = (symbol) => Number(element.querySelector(`#force-exercise-found [data-force='${symbol}']`).dataset.value);
  const check = () => {
    element.querySelector("#force-exercise-check").click();
    return element.querySelector("#force-exercise-said").textContent;
  };
  answer(rows(), addends());
  assert.match(check(), /^All is right/);
  const row = addends().findIndex(({ unknown, size }) => unknown !== null && Math.abs(size) > 1);
  const { symbol, unknown, factors } = addends()[row];
  const before = value(symbol);
  const { sense } = rows()[row];
  assert.deepEqual([...sense.options].map(({ textContent }) => textContent), factors[1] < 0 ? ["↓", "↑"] : ["↑", "↓"]);
  sense.value = "reversed";
  sense.dispatchEvent(new Event("change"));
  assert.match(check(), /^Wrong: [1-9]/);
  answer(rows(), addends([unknown]));
  assert.match(check(), /^All is right/);
  assert.equal(value(symbol), -before);
  // The printed sheet has the answers that are filled in.
  const paper = exercise.onPaper();
  assert.equal(all(paper, ".cell").length, 4 * addends().length);
  assert.equal(all(paper, "[data-force]").length, addends().length);
});

test("the sheet on paper has blanks before anything is filled in, and no values", () => {
  const { exercise } = rod();
  const paper = exercise.onPaper();
  assert.ok(all(paper, ".cell").every(({ textContent }) => textContent === ""));
  assert.equal(all(paper, "[data-force]").length, 0);
  assert.equal(all(paper, ".blank").length, 3);
});
