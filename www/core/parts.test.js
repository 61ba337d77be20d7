// Tests of the engine in two parts: a first view needs only one of them, the second is loaded once, and may fail to load.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import test from "node:test";
import { isDivided, matching, start } from "assur/core/parts.js";
import { Engine } from "assur/engine.js";
import { Context, themeOf } from "assur/tests/canvas.js";
import { initialState } from "assur/state/state.js";
import { WASM } from "assur/tests/engine.js";
import * as divided from "assur/pkg/assur_web.js";
import * as whole from "assur/pkg/assur_web.js?whole";

const compiled = (name) => new WebAssembly.Module(readFileSync(new URL(import.meta.resolve(`assur/pkg/${name}`))));
const first = compiled("first.wasm");
const second = compiled("second.wasm");

/** Returns the second part; one test replaces this function by functions that fail. */
let getSecond = () => second;
let loads = 0;
await start(first, () => {
  loads += 1;
  return getSecond();
});

/** The second part with a different number of its build. */
function ofAnotherBuild() {
  const bytes = Uint8Array.from(readFileSync(new URL(import.meta.resolve("assur/pkg/second.wasm"))));
  bytes[bytes.length - 1] ^= 1;
  return new WebAssembly.Module(bytes);
}

whole.initSync({ module: readFileSync(WASM) });
const { document: class4 } = whole.catalogue().find(({ id }) => id === "class4-dwell");
const CLASS4 = initialState("linkage", class4, { playing: false });

/** @param {Engine} engine */
function stateOfFirstView({ catalogue }) {
  const [{ kind, document }] = catalogue.mixers;
  return initialState(kind, document);
}

const refusal = (code) => ({ problems: [{ code }] });

test("a first view needs the first part only; the rest is loaded once, when something needs it", () => {
  const engine = new Engine();
  const { home } = engine.set(stateOfFirstView(engine));
  engine.simulator.scene();
  engine.at(engine.simulator.advance(home, 0.1)[0]);
  const { palette, scale } = themeOf(engine.roles);
  engine.chart(new Context(), { width: 400, height: 300, palette, scale, ratio: 1, whole: false, only: "all", around: home });
  assert.equal(loads, 0);
  engine.set(CLASS4);
  engine.catalogue.preset("jansen");
  assert.equal(loads, 1);
});

test("both parts together compute what the whole engine does, digit by digit", () => {
  const computed = ({ Simulator, catalogue, defaultView }) =>
    catalogue().map(({ id, kind, document }) => {
      const simulator = new Simulator();
      const summary = simulator.set({ format: 2, kind, document, view: defaultView() });
      return { id, summary, here: "home" in summary && simulator.at(summary.home), scene: simulator.scene(), sweep: "home" in summary && simulator.sweep(12) };
    });
  const [one, other] = [computed(divided), computed(whole)];
  assert.ok(one.length > 50, `${one.length} mechanisms`);
  assert.deepEqual(one, other);
});

test("if the rest does not load, its calls are refused, and the engine works on", (t) => {
  t.mock.method(console, "error", () => {});
  // A new instance has no second part yet.
  divided.__wbg_reset_state();
  const engine = new Engine();
  const { home } = engine.set(stateOfFirstView(engine));
  const before = engine.at(home).frame;
  for (const fail of [() => null, () => matching(ofAnotherBuild(), first), () => { throw new Error("no connection"); }]) {
    getSecond = fail;
    assert.throws(() => engine.set(CLASS4), refusal("not_arrived"));
    assert.equal(engine.trapped, false);
    assert.deepEqual(engine.at(home).frame, before);
  }
  getSecond = () => second;
  assert.equal(engine.set(CLASS4).moves, "angle");
});

test("a whole module has no second part", () => {
  assert.equal(isDivided(first), true);
  assert.equal(isDivided(new WebAssembly.Module(readFileSync(WASM))), false);
});
