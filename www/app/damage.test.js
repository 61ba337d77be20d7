// Tests of damaged addresses and files: each is refused with a sentence that names the damage, or is still a valid
// state and opens.
import assert from "node:assert/strict";
import test from "node:test";
import { lineOf } from "assur/app/notices.js";
import { takeAddress, takeFile } from "assur/app/opening.js";
import { attempt } from "assur/core/problem.js";
import { MAX_LENGTH } from "assur/state/codec.js";
import { initialState } from "assur/state/state.js";
import { KINDS, address, damagedAddress, damagedFile, depth, held, sound } from "assur/tests/damage.js";
import { newEngine } from "assur/tests/engine.js";
import { often } from "assur/tests/random.js";
import { LANGUAGES, wordsOf } from "assur/tests/words.js";

const engine = newEngine();
const habits = { calm: false, lang: "en" };
const words = LANGUAGES.map((lang) => wordsOf(lang));
const NAME = "<img src=x onerror=window.hurt=1>.json";
const EACH = 34;

const prototypes = () => [Object, Array, Function, String].map(({ prototype }) => Reflect.ownKeys(prototype).length).join();

/** The address as a browser returns it, given the part after the #. */
function barred(hash) {
  const url = new URL("https://assur.test/");
  url.hash = hash;
  return url.href;
}

/**
 * Reads the content of an input by the engine.
 * @param {unknown} value undefined if the input cannot be parsed
 * @param {string} [text] text of the file; undefined for an address
 */
function judged(value, text) {
  if (text === undefined && (value === undefined || depth(value) > 12)) return { value: null, problems: [{ code: "unreadable_link" }] };
  const other = text !== undefined && (value === undefined ? "not_json" : (value?.format === undefined || depth(value) > 12) && "no_mechanism");
  if (other) return { value: null, problems: [{ code: other }, { code: "what_opens" }] };
  const size = text === undefined ? 0 : text.length - (typeof value.picture?.image === "string" ? value.picture.image.length : 0);
  if (size > MAX_LENGTH) return { value: null, problems: [{ code: "too_many_characters", size, max: MAX_LENGTH }] };
  return attempt(() => {
    if (text !== undefined) engine.functions.checkKeys(text);
    return engine.functions.readState(value);
  });
}

/** @param {string} text of a file */
function read(text) {
  try {
    return JSON.parse(text);
  } catch {
    return undefined;
  }
}

/**
 * @param {string} input
 * @param {import("assur/app/opening.js").Taken} taken
 * @param {ReturnType<typeof judged>} expected
 * @param {string} named text that the sentence must contain
 */
function check(input, { state, failure }, expected, named) {
  const brief = `${input.slice(0, 600)}\n${JSON.stringify(failure)}`;
  assert.equal(prototypes(), clean, `a prototype was changed: ${brief}`);
  assert.equal({}.hurt ?? globalThis.hurt, undefined, brief);
  if (expected.value) {
    const { kind, document, view } = expected.value;
    const lang = LANGUAGES.includes(view.lang) ? view.lang : "en";
    assert.deepEqual(state, initialState(kind, document, { ...view, lang }, expected.value), brief);
    assert.equal(failure, null);
    engine.set(state);
    return;
  }
  assert.equal(state, null, `it is no state: ${brief}`);
  assert.deepEqual(failure.problems, expected.problems, brief);
  for (const [i, one] of words.entries()) {
    const said = lineOf(failure, one);
    // No placeholder of the sentence is left. Braces in a text of the input are not placeholders.
    assert.ok(said.length > 40 && !/\{\w+\}/.test(said) && !/(problem|notice|field)\.\w/.test(said), `${said}: ${brief}`);
    if (i === 0) assert.ok(said.includes(named), `${said}: ${brief}`);
    for (const { code, path } of failure.problems) {
      // A value of the wrong form is named by its path.
      if (code === "bad_state" && /^[^.]+\.[^.]/.test(path)) assert.ok(said.includes(path), `${path}: ${said}`);
    }
  }
}

const clean = prototypes();

for (let kind = 0; kind < KINDS; kind++) {
  test(`addresses with damage of kind ${kind + 1} of ${KINDS} are sentences, or states as they say`, async () => {
    const inputs = new Set();
    often(EACH, (dice) => inputs.add(damagedAddress(dice, kind)));
    inputs.delete("");
    let refused = 0;
    for (const input of inputs) {
      const bar = barred(input);
      const taken = await takeAddress(bar, engine, habits);
      check(input, taken, judged(held(bar.split("#").slice(1).join("#")) ?? undefined), "The link");
      refused += Number(!taken.state);
    }
    assert.ok(refused >= inputs.size / 3, `${refused} of ${inputs.size}`);
  });

  test(`files with damage of kind ${kind + 1} of ${KINDS} are sentences, or states as they say`, async () => {
    const inputs = new Set();
    often(EACH, (dice) => inputs.add(damagedFile(dice, kind)));
    let refused = 0;
    for (const input of inputs) {
      const taken = await takeFile(new File([input], NAME), engine, habits);
      check(input, taken, judged(read(input), input), NAME);
      refused += Number(!taken.state);
    }
    assert.ok(refused >= inputs.size / 3, `${refused} of ${inputs.size}`);
  });
}

test("what is not damaged is opened", async () => {
  const whole = address();
  const { state } = await takeAddress(barred(whole), engine, habits);
  assert.deepEqual(state.document, engine.functions.readState(sound()).document);
  assert.deepEqual((await takeFile(new File([JSON.stringify(sound())], NAME), engine, habits)).state, state);
  check(whole, { state, failure: null }, judged(held(whole)), "");
});

test("what is refused leaves the mechanism that is set", async () => {
  const good = await takeAddress("https://assur.test/#jansen&v.phi_deg=30&v.playing=false", engine, habits);
  engine.set(good.state);
  const before = [...engine.at(0.5).frame];
  for (let kind = 0; kind < KINDS; kind++) {
    const inputs = [];
    often(3, (dice) => inputs.push([damagedAddress(dice, kind), damagedFile(dice, kind)]));
    for (const [hash, file] of inputs) {
      await takeAddress(barred(hash), engine, habits);
      await takeFile(new File([file], NAME), engine, habits);
    }
  }
  assert.deepEqual([...engine.at(0.5).frame], before);
  assert.equal(engine.trapped, false);
});
