// Tests of the figures of the lesson: the linear equations in numbers, and finite differences beside the exact analogues.
import { all } from "assur/tests/document.js";
import assert from "node:assert/strict";
import test from "node:test";
import { Differences, differences } from "assur/lessons/class4-dwell/differences.js";
import { System } from "assur/lessons/class4-dwell/system.js";
import { Words } from "assur/core/words.js";
import { Page } from "assur/tests/page.js";
import { tableOf } from "assur/tests/words.js";

const { engine } = new Page("class4-dwell");
const words = new Words("en", new Map([...tableOf("en"), ["derivatives.figure.system", "system"]]));

test("central differences are exact for a parabola, and none without a neighbour", () => {
  assert.deepEqual(differences([4, 1, 0], 1), [-2, 2]);
  assert.equal(differences([4, undefined, 0], 1), null);
});

test("a step in the middle comes nearest to the exact ψ″", () => {
  const at = Math.PI / 3;
  const [, , exact] = engine.simulator.plotted(at);
  const off = [10, 0.1, 1e-5].map((degrees) => {
    const h = (degrees * Math.PI) / 180;
    const found = differences([at - h, at, at + h].map((phi) => engine.simulator.plotted(phi)[0]), h);
    return Math.abs(found[1] - exact);
  });
  assert.ok(off[1] < 1e-4 && off[0] > 100 * off[1] && off[2] > 10 * off[1], off.join());
});

test("six equations with their solutions of both orders hold in numbers", () => {
  const system = new System(engine);
  system.render({ input: Math.PI / 3, stale: false }, words);
  const rows = all(system.element, "tr:has(td)");
  const numbers = rows.map((row) => all(row, "td").map(({ textContent }) => Number(textContent.replace("−", "-"))));
  assert.equal(numbers.length, 10);
  const [matrix, right, solutions] = [numbers.slice(0, 6), numbers.slice(6, 8), numbers.slice(8)];
  for (const [i, row] of matrix.entries()) {
    for (const [order, solution] of solutions.entries()) {
      const left = row.reduce((sum, factor, k) => sum + factor * solution[k], 0);
      assert.ok(Math.abs(left - right[order][i]) < 0.02, `${row} ${order}: ${left}`);
    }
  }
});

test("the plot of differences has its scale: the greatest and the least ψ″", () => {
  const { cycle } = new Page("class4-dwell").now().summary;
  const figure = new Differences(engine);
  figure.render({ kind: "linkage", summary: { cycle }, stale: false }, words);
  const ends = all(figure.element, "text").map(({ textContent }) => Number(textContent.replace("−", "-")));
  const values = Array.from({ length: 360 }, (_, i) => engine.simulator.plotted(((i + 0.5) * Math.PI) / 180)[2]);
  assert.ok(Math.abs(ends[0] - Math.max(...values)) < 0.01 && Math.abs(ends[1] - Math.min(...values)) < 0.01, ends.join());
});

test("where nothing with derivatives is plotted, the figure of differences is not shown", () => {
  const cycle = { start: 0, end: 2 * Math.PI };
  const shown = (/** @type {readonly number[]} */ values) => {
    const figure = new Differences({ simulator: { plotted: () => values } });
    figure.render({ kind: "linkage", summary: { cycle }, stale: false }, words);
    return !figure.element.hidden;
  };
  assert.equal(shown([1]), false);
  assert.equal(shown([]), false);
});
