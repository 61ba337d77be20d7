import assert from "node:assert/strict";
import test from "node:test";
import { MAX_LENGTH, fromAddress, fromFile, toAddress, toFile } from "assur/state/codec.js";
import { initialState, usualView, withExtras, withView } from "assur/state/state.js";
import { Refusal } from "assur/core/problem.js";
import { newEngine, stateOf } from "assur/tests/engine.js";
import { often } from "assur/tests/random.js";

const engine = newEngine();
const usual = usualView({ lang: "en" });
const preset = (id) => {
  const found = engine.catalogue.preset(id);
  return found && { kind: found.kind, document: found.document, view: usual };
};
/** The hash as a browser returns it: characters that an address may not contain are encoded. */
const through = (hash) => {
  const url = new URL("https://assur.test/");
  url.hash = hash;
  return url.href.split("#").slice(1).join("#");
};
const refused = (work, code = "unreadable_link") => assert.throws(work, (error) => error instanceof Refusal && error.problems[0].code === code);

test("a state of every mechanism of the catalogue comes back from its address, long or short", () => {
  for (const { id, kind, document } of engine.catalogue.presets) {
    const state = initialState(kind, document, { phi_deg: 12.5, s: 0.25, playing: false, traces: false, lang: "kk", axes: "physical" });
    const long = toAddress(state, null);
    assert.deepEqual(engine.functions.readState(fromAddress(through(long), preset)), engine.functions.readState(state), id);
    const short = toAddress(state, { id, usual });
    assert.ok(short.startsWith(`${id}&`) && short.length < 200, short);
    assert.deepEqual(engine.functions.readState(fromAddress(through(short), preset)), engine.functions.readState(state), id);
    // Default settings are left out.
    assert.equal(toAddress(initialState(kind, document, { lang: "en" }), { id, usual }), id);
  }
});

test("any JSON in a document and a view comes back from an address", () => {
  const text = (dice) => Array.from({ length: dice.below(9) }, () => dice.one([..."aZ0 &=%#+?/\"'<>{}[],:;\\\u0000\n", "é", "Ж", "💥", "\u202e"])).join("");
  const value = (dice, depth) => {
    const choice = dice.below(depth > 0 ? 7 : 5);
    if (choice === 0) return dice.number();
    if (choice === 1) return text(dice);
    if (choice === 2) return dice.below(2) === 0;
    // A text that could be read as JSON must come back as a text.
    if (choice === 3) return dice.one(["1", "null", "true", "\"x\"", "{}", "[]", " 1", "1 ", "-0", "1e5", ""]);
    if (choice === 4) return dice.below(100);
    const parts = Array.from({ length: dice.below(4) }, () => value(dice, depth - 1));
    return choice === 5 ? parts : Object.fromEntries(parts.map((part) => [text(dice) || "k", part]));
  };
  often(200, (dice) => {
    const [document, view] = [0, 1].map(() => Object.fromEntries(Array.from({ length: dice.below(6) }, (_, i) => [`${text(dice)}${i}`, value(dice, 3)])));
    const state = { format: 2, kind: text(dice), document, view };
    // Browsers take tabs and new lines out of an address: they have to be encoded.
    assert.deepEqual(fromAddress(through(toAddress(state, null)), () => undefined), state);
  });
});

test("a file holds the whole state, as text that people can read", () => {
  for (const { id } of engine.catalogue.presets) {
    const state = withExtras(stateOf(engine, id), { lesson: { title: "T", steps: [{ title: "1", text: "x" }] } });
    const text = toFile(state);
    assert.deepEqual(fromFile(text), JSON.parse(JSON.stringify(state)));
    assert.ok(text.startsWith("{\n  \"format\": 2,\n") && text.endsWith("}\n"));
    assert.deepEqual(engine.functions.readState(fromFile(text)).document, engine.functions.readState(state).document, id);
  }
});

test("a lesson and what is compared travel in an address, a picture does not", () => {
  const compared = { kind: "linkage", document: engine.catalogue.preset("jansen").document };
  const lesson = { title: "Legs", steps: [{ title: "", text: "a & b" }] };
  const state = withExtras(stateOf(engine, "mixer-a"), { lesson, compared, picture: { image: "data:," } });
  for (const address of [toAddress(state, null), toAddress(state, { id: "mixer-a", usual })]) {
    const found = fromAddress(through(address), preset);
    assert.deepEqual([found.lesson, found.compared, found.picture], [lesson, JSON.parse(JSON.stringify(compared)), undefined]);
  }
});

test("a short address of what moves leaves out where the driver stands", () => {
  const moving = initialState("linkage", engine.catalogue.preset("jansen").document, { phi_deg: 33, playing: true });
  assert.equal(toAddress(moving, { id: "jansen", usual }), "jansen");
  assert.equal(toAddress(withView(moving, { playing: false }), { id: "jansen", usual }), "jansen&v.phi_deg=33&v.playing=false");
});

test("what says nothing is left out, text stays legible", () => {
  const state = initialState("mixer", { l1: 0.37, note: null }, { against: null, plot: "C.x" });
  const address = toAddress(state, null);
  assert.ok(address.startsWith("2&kind=mixer&d.l1=0.37&v."), address);
  assert.ok(address.includes("&v.plot=C.x&") && !address.includes("against") && !address.includes("note"), address);
  assert.equal(toAddress(initialState("mixer", { title: "12" }, {}), null).split("&")[2], "d.title=%2212%22");
});

test("an address of the first version is read as it was written then", () => {
  const found = fromAddress("1&lesson=mixer&d.l1=0.37&v.phi_deg=75&x=1", () => undefined);
  assert.deepEqual(found, { format: 1, lesson: "mixer", document: { l1: 0.37 }, view: { phi_deg: 75 } });
});

test("an address that is none of ours is refused", () => {
  for (const hash of ["", "7&kind=mixer", "0", "1.0&", "janssen", "__proto__", "constructor&v.speed=1", "toString", "%E0%A4%A", "2&d.l1=%E0%A4%A", "jansen&d.title=Leg", "<b>", "-1&kind=mixer"]) {
    refused(() => fromAddress(hash, preset));
  }
  refused(() => fromAddress(`2&kind=mixer&d.x=${"9".repeat(MAX_LENGTH)}`, preset));
  refused(() => fromAddress(`2&kind=mixer&d.x=${"[".repeat(20)}${"]".repeat(20)}`, preset));
});

test("keys of an address that are names of a prototype are keys like others", () => {
  const found = fromAddress("2&kind=mixer&d.__proto__={\"hurt\":1}&v.constructor=1&__proto__=2", () => undefined);
  assert.ok(Object.hasOwn(found.document, "__proto__"));
  assert.equal(Object.getPrototypeOf(found.document), Object.prototype);
  assert.deepEqual([{}.hurt, found.view.constructor, Object.keys(found)], [undefined, 1, ["format", "kind", "document", "view"]]);
});

test("a file that is too long or too deep is refused; an image does not count for its length", () => {
  const nested = (depth) => ({ format: 2, deep: JSON.parse(`${"[".repeat(depth)}${"]".repeat(depth)}`) });
  assert.deepEqual(fromFile(JSON.stringify(nested(11))), nested(11));
  refused(() => fromFile(JSON.stringify(nested(12))), "no_mechanism");
  refused(() => fromFile(JSON.stringify({ format: 2, long: "x".repeat(MAX_LENGTH) })), "too_many_characters");
  for (const text of ["", "{", "undefined", "{\"format\":2,}", "<linkage2>", "[".repeat(90_000)]) refused(() => fromFile(text), "not_json");
  for (const text of ["null", "1", "[]", "{\"form\":2}"]) refused(() => fromFile(text), "no_mechanism");
  const image = "x".repeat(MAX_LENGTH);
  assert.equal(fromFile(JSON.stringify({ format: 2, picture: { image } })).picture.image, image);
  refused(() => fromFile(JSON.stringify({ format: 2, picture: { image, more: "x".repeat(MAX_LENGTH) } })), "too_many_characters");
});
