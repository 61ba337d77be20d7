// Tests of the equations of a force plan in symbols and numbers: the numbers must be those of the engine.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import test from "node:test";
import "assur/tests/document.js";
import { html, render } from "assur/core/html.js";
import { Words } from "assur/core/words.js";
import { describeStep, leverTable, titleOf, unitsOf } from "assur/force-plan/equations.js";
import { Page } from "assur/tests/page.js";
import { LANGUAGES, tableOf } from "assur/tests/words.js";

const later = (lang) => Object.entries(JSON.parse(readFileSync(new URL(`../forces/words.${lang}.json`, import.meta.url), "utf8")));
const wordsOf = (lang) => new Words(lang, new Map([...tableOf(lang), ...later(lang)]), "m");
const term = (symbol, more) => ({ symbol, couple: false, known: true, size: 1, direction: 0, value: 0, arm: null, ...more });
const text = (template) => {
  const box = document.createElement("div");
  render(template, box);
  return box.textContent.replaceAll(/\s+/g, " ").trim();
};

test("a sum of moments is written in symbols, in numbers, and solved", () => {
  const words = wordsOf("en");
  const step = { kind: "moments", plan: 0, links: ["2"], about: "C", open: [], terms: [
    term("G₂", { size: 10, value: 20, arm: 2 }),
    term("MΦ₂", { couple: true, size: -3, value: -3 }),
    term("F₁", { size: 7, value: 1e-16, arm: 1e-17 }),
    term("R₁₂ᵗ", { known: false, size: 3.4, value: -17, arm: -5 }),
  ] };
  const said = text(html`${describeStep(step, unitsOf(words, "m"), words)}`);
  assert.equal(said, "Moments about C (links: 2)ΣMC = G₂·h + MΦ₂ + R₁₂ᵗ·h = 010 N·2 m − 3 N·m + R₁₂ᵗ·5 m = 0 R₁₂ᵗ = −3.4 N");
  // In a consistent system of units, numbers have no units.
  assert.match(text(html`${describeStep(step, unitsOf(words, "none"), words)}`), /10·2 − 3 \+ R₁₂ᵗ·5 = 0/);
});

test("a polygon lists what is known, and what it gives with its direction", () => {
  const words = wordsOf("en");
  const step = { kind: "polygon", plan: 0, links: ["2", "3"], about: null, open: [], terms: [
    term("G₂", { size: 10 }),
    term("R₀₃", { known: false, size: 5, direction: Math.PI / 2 }),
  ] };
  assert.equal(text(html`${describeStep(step, unitsOf(words, "m"), words)}`), "Polygon of forces (links: 2, 3)G₂ + R₀₃ = 0 G₂ = 10 NR₀₃ = 5 N, ∠ 90.0°");
});

test("every kind of step has a title in every language", () => {
  for (const lang of LANGUAGES) {
    const words = wordsOf(lang);
    const titles = ["moments", "along", "polygon", "group", "indeterminate"].map((kind) => titleOf({ kind, plan: 0, links: ["2"], about: "C", open: ["R₁₂"], terms: [] }, words));
    assert.equal(new Set(titles).size, titles.length, lang);
    assert.ok(titles.every((title) => title.includes("2") && !title.includes("{")), titles.join());
  }
});

test("the lever of the engine shows the torque of the plan", () => {
  const page = new Page("slider-crank", { phi_deg: 60, omega: 3, playing: false });
  const state = page.store.get();
  const links = state.document.links.map((link) => ({ ...link, mass: 2 }));
  page.engine.set({ ...state, document: { ...state.document, links, gravity: [0, -10] } });
  const input = Math.PI / 3;
  const { simulator } = page.engine;
  const lever = simulator.forceLever(input);
  assert.ok(Math.abs(lever.by_lever) > 1 && Math.abs(lever.by_lever - lever.by_reactions) < 1e-12 * Math.abs(lever.by_lever) * 100);
  assert.match(text(html`${leverTable(lever, unitsOf(wordsOf("en"), "m"), wordsOf("en"))}`), /By the lever: T₁ = .* N·m/);
  const { steps, loaded } = simulator.forcePlan(input, 1e6);
  assert.ok(loaded);
  const torque = steps.flatMap(({ terms }) => terms).find(({ symbol }) => symbol === "T₁");
  assert.ok(Math.abs(torque.value - lever.by_reactions) < 1e-9);
  assert.equal(simulator.freeBody(input, 0).links.length, 3);
  // A link that does not exist has no forces.
  assert.deepEqual(simulator.freeBody(input, 99).acting, []);
});

test("a plan keeps its scale over the turn", () => {
  const page = new Page("crank-rocker", { phi_deg: 60, omega: 3, playing: false });
  const state = page.store.get();
  const links = state.document.links.map((link) => ({ ...link, mass: 2 }));
  page.engine.set({ ...state, document: { ...state.document, links, gravity: [0, -10] } });
  const inputs = Array.from({ length: 72 }, (_, k) => (k * Math.PI) / 36);
  const rooms = inputs.map((input) => page.engine.simulator.forcePlan(input, 1e6).picture.bounds.join());
  assert.equal(new Set(rooms).size, 1);
});
