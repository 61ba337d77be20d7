// Tests of a wanted function: the positions derived from it, its form in the state, and the sentences for its faults.
import assert from "node:assert/strict";
import test from "node:test";
import { sentence } from "assur/controls/problems.js";
import { attempt } from "assur/core/problem.js";
import { formula } from "assur/kinds/synthesis/function.js";
import { tableOf } from "assur/kinds/synthesis/function-dialog.js";
import { fromFile, toFile } from "assur/state/codec.js";
import { initialState } from "assur/state/state.js";
import { newEngine } from "assur/tests/engine.js";
import { LANGUAGES, wordsOf } from "assur/tests/words.js";

const LOG = Object.freeze({ of: "log10", x: [1, 2], input_deg: [90, 150], output_deg: [210, 270] });

const engine = newEngine();
const PAIR = Object.freeze([{ output_deg: 240, input_deg: 45 }, { output_deg: 253, input_deg: 60 }]);
const stateOf = (wanted, positions = PAIR) => initialState("synthesis", { frame: 10, positions, function: wanted }, { playing: false });
const ask = (wanted, count, even) => attempt(() => engine.functions.functionPositions(stateOf({ ...LOG, ...wanted }), count, even));

test("positions stand at Chebyshev's places or in even steps, and the linkage is compared with the function", () => {
  const { value: even } = ask({}, 5, true);
  assert.deepEqual(even.map(({ input_deg: input }) => Math.round(input * 1e9) / 1e9), [90, 105, 120, 135, 150]);
  const { value: positions } = ask({}, 3, false);
  const state = stateOf(LOG, positions);
  const { function: error, from } = engine.set(state);
  assert.equal(from, "exact");
  assert.equal(error.complete, true);
  assert.equal(error.curve.length, 101);
  // Computed independently of the engine.
  const [x, greatest] = error.greatest;
  assert.ok(Math.abs(x - 2) < 1e-9, String(x));
  assert.ok(Math.abs(greatest + 0.000521470237586174) < 1e-12, String(greatest));
  // The error is zero at the three positions: its curve changes sign three times.
  const signs = error.curve.map(([, off]) => Math.sign(off));
  assert.equal(signs.filter((sign, k) => k > 0 && sign !== signs[k - 1]).length, 3);
  assert.deepEqual(engine.functions.readState(fromFile(toFile(state))).document, engine.functions.readState(state).document);
  assert.equal(engine.set(stateOf(null, positions)).function, null);
});

test("what is wrong with a function has a sentence in every language that names the field", () => {
  for (const [wanted, code, field] of [
    [{ x: [1, 1] }, "equal_ends", "function.x"], [{ input_deg: [1, 1] }, "equal_ends", "function.input_deg"], [{ output_deg: [1, 1] }, "equal_ends", "function.output_deg"],
    [{ x: [0, 1] }, "no_value", "function.x"], [{ of: { power: 2 }, x: [-1, 1] }, "equal_values", "function.x"],
    [{ of: { table: [[1, 2], [1, 3]] } }, "bad_row", "function.of"], [{ of: { table: [] } }, "too_few_rows", "function.of"],
  ]) {
    const { problems: [problem] } = ask(wanted, 3, false);
    assert.deepEqual([problem.code, problem.field], [code, field]);
    for (const lang of LANGUAGES) {
      const words = wordsOf(lang);
      const said = sentence(problem, words);
      assert.ok(said.startsWith(`${words.text(`field.${field}`)}: `) && !said.includes("{"), said);
    }
  }
});

test("rows are two numbers with a space, a semicolon or a comma between, with a decimal point or comma", () => {
  const problems = [];
  const rows = "1 2\n\n 1.5;2,5 \n2, 3\n2,5\t4e0\n3,−1\n4 ; 5";
  assert.deepEqual(tableOf(rows, problems), [[1, 2], [1.5, 2.5], [2, 3], [2.5, 4], [3, -1], [4, 5]]);
  assert.deepEqual(problems, []);
  tableOf("1 2\nx y\n1 2 3\n7", problems);
  assert.deepEqual(problems.map(({ row }) => row), [2, 3, 4]);
});

test("a function is written as a formula where it has one", () => {
  const [en, ru] = ["en", "ru"].map((lang) => wordsOf(lang));
  assert.deepEqual(["log10", "exp", "sin", { power: -0.5 }].map((of) => formula(of, ru)), ["y = log₁₀ x", "y = eˣ", "y = sin x", "y = x^−0,5"]);
  assert.equal(formula({ table: [] }, en), "table of x and y");
});
