// The exercise on a free body: its signs are judged by those of the engine.
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
const SIGNS = { "-1": "−", 0: "0", 1: "+" };

/** The rod of a slider-crank at rest under its weight. */
function rod() {
  const page = new Page("slider-crank", { phi_deg: 60, omega: 0, playing: false });
  const state = page.store.get();
  const links = state.document.links.map((link) => (link.name === "rod" ? { ...link, mass: 2 } : link));
  page.engine.set({ ...state, document: { ...state.document, links, gravity: [0, -10] } });
  return page.engine.simulator.freeBody(Math.PI / 3, 1);
}

test("right signs are right, wrong ones are marked, and those of moments follow the point", () => {
  const body = rod();
  assert.deepEqual(body.points, ["B", "C"]);
  const exercise = new Exercise(() => words);
  document.body.append(exercise.element);
  exercise.show(body, "2: rod");
  const fields = all(exercise.element, "tbody select");
  assert.equal(fields.length, 3 * body.acting.length);
  const check = () => {
    exercise.element.querySelector("#force-exercise-check").click();
    return exercise.element.querySelector("#force-exercise-said").textContent;
  };
  assert.equal(check(), `Wrong: 0; not yet answered: ${fields.length}.`);
  const about = exercise.element.querySelector("#force-exercise-about");
  const answer = (point) => body.acting.forEach(({ signs }, row) => [0, 1, 2 + point].forEach((at, k) => {
    fields[3 * row + k].value = SIGNS[signs[at]];
  }));
  answer(1);
  about.selectedIndex = 1;
  assert.equal(check(), "All signs are right.");
  // The weight turns the rod one way about one end, and the other way about the other.
  const weight = body.acting.find(({ symbol }) => symbol === "G₂");
  assert.deepEqual(weight.signs, [0, -1, -1, 1]);
  about.selectedIndex = 0;
  assert.match(check(), /^Wrong: [1-9]; not yet answered: 0\.$/);
  assert.ok(all(exercise.element, "[aria-invalid]").length > 0);
  // On paper there are blanks and no answers.
  const paper = exercise.onPaper();
  assert.equal(all(paper, ".cell").length, fields.length);
  assert.ok(all(paper, ".cell").every(({ textContent }) => textContent === ""));
});
