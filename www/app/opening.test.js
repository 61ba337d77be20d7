import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import test, { beforeEach } from "node:test";
import "assur/tests/document.js";
import { lineOf } from "assur/app/notices.js";
import { open, takeAddress, takeFile } from "assur/app/opening.js";
import { toAddress, toFile } from "assur/state/codec.js";
import { initialState, withDocument, withExtras, withView } from "assur/state/state.js";
import { newEngine, stateOf } from "assur/tests/engine.js";
import { shownOf } from "assur/tests/shown.js";
import { wordsOf } from "assur/tests/words.js";

const engine = newEngine();
const habits = { calm: false, lang: "en" };
const HOME = "https://assur.test/";
const LINKS = readFileSync(new URL("../../tests/links.txt", import.meta.url), "utf8").split("\n").filter((line) => line !== "" && !line.startsWith("# "));

/** Stand-in for the storage of the browser. */
const kept = new Map();
globalThis.localStorage = { getItem: (key) => kept.get(key) ?? null, setItem: (key, text) => kept.set(key, text), removeItem: (key) => kept.delete(key) };

const begin = (address = HOME, how = habits) => {
  globalThis.location = { href: address };
  return open(engine, how);
};

beforeEach(() => kept.clear());

for (const [number, line] of LINKS.entries()) {
  test(`link ${number + 1} of tests/links.txt opens and shows what it showed`, async () => {
    const [hash, values] = line.split("\t");
    const { state, failure } = await takeAddress(HOME + hash, engine, habits);
    assert.equal(failure, null);
    const { shown } = shownOf(engine, state);
    for (const pair of values.split(" ")) {
      const [, id, value] = /^out-(.+)=(.+)$/.exec(pair);
      const found = shown.find(id)?.value;
      assert.ok(Math.abs(found - Number(value)) <= 1e-9 * Math.max(1, Math.abs(Number(value))), `${pair}: ${found}`);
    }
  });
}

test("tests/links.txt has links of both versions", () => {
  assert.ok(LINKS.length >= 10 && LINKS.some((line) => line.startsWith("#1&")) && LINKS.some((line) => line.startsWith("#2&")));
});

test("every mechanism of the catalogue opens by its name, as it stands there", async () => {
  for (const { id, kind, document } of engine.catalogue.presets) {
    const { state } = await takeAddress(`${HOME}#${id}`, engine, habits);
    assert.deepEqual([state.kind, state.document, state.view.lang], [kind, engine.functions.readState(initialState(kind, document, {})).document, "en"], id);
    assert.equal(engine.catalogue.presetOf(state)?.id, id);
    assert.equal(engine.catalogue.fileName(state), id);
  }
});

test("a page opens with its address, else with what was kept, else with the first of the catalogue", async () => {
  const jansen = withView(stateOf(engine, "jansen", { phi_deg: 33 }), { lang: "uk" });
  kept.set("assur.state", toFile(jansen));
  assert.equal((await begin(`${HOME}#whitworth`)).state.document.origin, "whitworth");
  const again = (await begin()).state;
  assert.deepEqual([again.document.origin, again.view.phi_deg, again.view.lang], ["jansen", 33, "uk"]);
  kept.clear();
  const { state, failures } = await begin();
  const [first] = engine.catalogue.presets;
  assert.deepEqual([state.kind, state.document, state.view.playing, failures], [first.kind, first.document, true, []]);
});

test("nothing moves unasked where the reader wants it calm", async () => {
  const calm = { calm: true, lang: "kk" };
  assert.equal((await begin(HOME, calm)).state.view.playing, false);
  assert.equal((await takeAddress(`${HOME}#jansen`, engine, calm)).state.view.playing, false);
  assert.equal((await begin(HOME, calm)).state.view.lang, "kk");
});

test("a language that the page does not have gives way to the reader's", async () => {
  for (const [lang, found] of [["fr", "ru"], ["kk", "kk"], ["", "ru"], ["EN", "ru"]]) {
    const { state } = await takeAddress(`${HOME}#jansen&v.lang=${lang}`, engine, { calm: false, lang: "ru" });
    assert.equal(state.view.lang, found, lang);
  }
});

test("what was kept and cannot be read is put aside and said", async () => {
  kept.set("assur.state", "{\"format\":1,\"lesson\":\"<b>\"}");
  const { state, failures } = await begin();
  assert.equal(state.kind, engine.catalogue.presets[0].kind);
  assert.equal(kept.get("assur.state.unread"), "{\"format\":1,\"lesson\":\"<b>\"}");
  assert.deepEqual(failures.map(({ kind }) => kind), ["kept"]);
  assert.match(lineOf(failures[0], wordsOf("en")), /lesson/);
});

test("an address that cannot be read is said, and what was kept is shown", async () => {
  kept.set("assur.state", toFile(stateOf(engine, "jansen")));
  const { state, failures } = await begin(`${HOME}#janssen`);
  assert.equal(state.document.origin, "jansen");
  assert.deepEqual(failures, [{ kind: "address", problems: [{ code: "unreadable_link" }] }]);
  assert.equal(kept.has("assur.state.unread"), false);
});

test("in a frame of another page nothing that was kept is read", async () => {
  kept.set("assur.state", toFile(stateOf(engine, "jansen")));
  assert.equal((await begin(HOME, { ...habits, embedding: {} })).state.kind, engine.catalogue.presets[0].kind);
});

test("a link opens with the tools for drawing, but not in a frame where nothing is edited", async () => {
  for (const [embedding, drawing] of [[null, true], [{ edits: true }, true], [{ edits: false }, false]]) {
    const { state } = await takeAddress(`${HOME}#jansen&v.drawing=true`, engine, { ...habits, embedding });
    assert.equal(state.view.drawing, drawing, JSON.stringify(embedding));
  }
});

test("where the browser keeps nothing the page opens all the same", async (t) => {
  const forbidden = () => {
    throw new DOMException("", "SecurityError");
  };
  t.mock.method(localStorage, "getItem", forbidden);
  t.mock.method(localStorage, "setItem", forbidden);
  assert.equal((await begin()).state.kind, engine.catalogue.presets[0].kind);
});

test("a picture that was kept comes back behind the very same drawing, and behind no other", async () => {
  const image = `data:image/png;base64,${"A".repeat(200)}`;
  const picture = { image, at: [0, 0], width: 10, turn_deg: 0, opacity: 0.5 };
  const state = engine.functions.readState(withExtras(stateOf(engine, "jansen"), { picture }));
  const sign = `${image.length} ${image.slice(-48)}`;
  kept.set("assur.state", JSON.stringify({ ...state, picture: { ...state.picture, image: sign } }));
  kept.set("assur.image", image);
  assert.equal((await begin(`${HOME}#jansen`)).state.picture?.image, image);
  assert.equal((await begin()).state.picture?.image, image);
  assert.equal((await begin(`${HOME}#whitworth`)).state.picture, undefined);
  // The stored image is not the one that belongs to the state, for example because another tab has stored its own.
  kept.set("assur.image", image.replace("A", "B").slice(1));
  for (const address of [HOME, `${HOME}#jansen`]) {
    const { state: found, failures } = await begin(address);
    assert.equal(found.picture, undefined);
    assert.deepEqual(failures.map((one) => lineOf(one, wordsOf("en"))), ["The picture behind the drawing is missing: this browser did not store it. Open the file that contains it, or choose the picture again."]);
  }
  assert.deepEqual((await begin(`${HOME}#whitworth`)).failures, []);
});

test("a file is opened as it was saved, whatever is in it", async () => {
  const state = withView(withDocument(stateOf(engine, "mixer-a", { phi_deg: 123.25, traces: false, speed: 0.5 }), { l2: 0.9, mesh: "internal", assembly: 2 }), { lang: "ru" });
  const text = toFile(state);
  assert.ok(text.includes("\n    \"l2\": 0.9,\n"), text);
  const opened = await takeFile(new File([text], "mixer.assur.json"), engine, habits);
  assert.equal(opened.failure, null);
  assert.deepEqual(opened.state, state);
});

test("a broken file is said by its name, with what is wrong in it", async () => {
  const text = toFile(stateOf(engine, "mixer-a"));
  const words = wordsOf("en");
  for (const [broken, part] of [
    [text.replace("0.85,", "\"<img src=x>\","), "document.l2"],
    [text.replace("\"l1\": 0.37", "\"l1\": -1"), "l₁"],
    [text.replace("\"l1\": 0.37", "\"l1\": 0.37, \"l1\": 0.38"), "l1"],
    [text.slice(0, text.length / 2), "JSON"],
    ["[".repeat(90_000), "JSON"],
    ["", "JSON"],
  ]) {
    assert.notEqual(broken, text);
    const { state, failure } = await takeFile(new File([broken], "<i>broken.assur.json"), engine, habits);
    assert.equal(state, null);
    const said = lineOf(failure, words);
    assert.ok(said.includes(part) && said.includes("<i>broken.assur.json"), said);
  }
});

test("a file of another kind is named, with the kinds that can be opened", async () => {
  const long = { format: 2, long: "x".repeat(449_978) };
  const opens = "Assur opens its own files (.assur.json), Linkage files (.linkage2) and PMKS+ links.";
  const start = "The file a.b could not be opened; nothing has changed. ";
  for (const [content, type, said] of [
    ["x".repeat(25_000_000), "", "It is too large: 25 MB. No more than 20 MB can be read."],
    [JSON.stringify(long), "", "Apart from a picture it has 450000 characters. No more than 400000 can be read."],
    ["{\"format\":2,", "", `It is not valid JSON, or part of it is missing. ${opens}`],
    ["{\"speed\":2}", "", `It is JSON, but not a mechanism that Assur saved. ${opens}`],
    ["[2]", "", `It is JSON, but not a mechanism that Assur saved. ${opens}`],
    ["null", "", `It is JSON, but not a mechanism that Assur saved. ${opens}`],
    ["\x89PNG", "image/png", `It is a picture: turn on the drawing tools (the pencil or D), take the tool “Picture behind the drawing”, and choose the picture there or drop it on the drawing. ${opens}`],
  ]) {
    const { state, failure } = await takeFile(new File([content], "a.b", { type }), engine, habits);
    assert.equal(state, null);
    assert.equal(lineOf(failure, wordsOf("en")), start + said);
  }
});

test("an unreadable link may lack a part, and the message says so", async () => {
  const good = toAddress(stateOf(engine, "jansen"), null);
  for (const hash of ["janssen", good.slice(0, good.indexOf("&d.links=") + 40)]) {
    const { failure } = await takeAddress(`${HOME}#${hash}`, engine, habits);
    assert.match(lineOf(failure, wordsOf("en")), /Part of the link may be missing: ask for it again\.$/);
  }
});

test("a link that was damaged by hand or by a program is a sentence", async () => {
  const words = wordsOf("en");
  const good = toAddress(stateOf(engine, "mixer-a", { phi_deg: 75, lang: "en" }), null);
  assert.equal((await takeAddress(`${HOME}#${good}`, engine, habits)).failure, null);
  const markup = "%3Cimg%20src=x%20onerror=%22window.hurt=1%22%3E";
  const all = Array.from({ length: 15 }, (_, i) => good.slice(0, Math.floor(((i + 1) * (good.length - 40)) / 16)));
  for (const pair of good.split("&").slice(1)) {
    const [key] = pair.split("=");
    // Any text is accepted as a language, so this field gets an object instead.
    for (const bad of [`${key}=${key === "v.lang" ? "{}" : markup}`, `${key}=[[null]]`, key]) all.push(good.replace(pair, bad));
  }
  for (const [from, to] of [
    ["d.l1=0.37", "d.l1=1e999"], ["d.l1=0.37", "d.__proto__={\"l1\":0.37}"], ["d.l1=0.37", "d.constructor=0.37"], ["d.l1=0.37", "__proto__={\"l1\":0.37}"],
    ["d.l1=0.37", "d.l1=%E0%A4%A"], ["d.l4=0.85", "d.l4=2"], ["v.phi_deg=75", "v.phi_deg=1e300"], ["v.speed=1", "v.speed=1e300"], ["2&", "7&"],
  ]) {
    assert.ok(good.includes(from), from);
    all.push(good.replace(from, to));
  }
  all.push(`${good}&d.l1=${"9".repeat(110_000)}`, `${good}&d.x=${"[".repeat(20_000)}${"]".repeat(20_000)}`);
  all.push("__proto__", "constructor&v.speed=1", "janssen", "jansen&v.speed=1e300", "jansen&v.phi_deg=[[null]]", "jansen&d.title=Leg", "%E0%A4%A");
  assert.ok(all.length >= 60);
  for (const hash of all) {
    const { state, failure } = await takeAddress(`${HOME}#${hash}`, engine, habits);
    assert.equal(state, null, hash.slice(0, 900));
    const said = lineOf(failure, words);
    assert.ok(said.length > 30 && !said.includes("{"), said);
  }
});

test("a file is named after the lesson or the mechanism that it holds", () => {
  const jansen = stateOf(engine, "jansen");
  const { catalogue } = engine;
  const lesson = { title: "Тест № 2: «кривошип»/ползун?", steps: [] };
  assert.equal(catalogue.fileName(withExtras(jansen, { lesson })), "Тест-2-кривошип-ползун");
  assert.equal(catalogue.fileName(withExtras(jansen, { lesson: { ...lesson, title: " " } })), "jansen");
  const own = withDocument(jansen, { origin: "", title: "Crank, of week 3" });
  assert.equal(catalogue.fileName(own), "Crank-of-week-3");
  assert.equal(catalogue.fileName(withDocument(own, { title: "" })), "linkage");
});
