// Tests of the sentences for the engine's problems.
import assert from "node:assert/strict";
import test from "node:test";
import { fieldName, sentence } from "assur/controls/problems.js";
import { attempt } from "assur/core/problem.js";
import { called } from "assur/core/names.js";
import { parseNumber } from "assur/core/numbers.js";
import { Words } from "assur/core/words.js";
import { withDocument, withExtras, withView } from "assur/state/state.js";
import { Page } from "assur/tests/page.js";
import { LANGUAGES, tableOf, wordsOf } from "assur/tests/words.js";

const [en, ru] = ["en", "ru"].map((lang) => wordsOf(lang));

/** Sentences for the problems of a mechanism of the catalogue after a change. */
function said(id, change, words = en) {
  const page = new Page(id, { phi_deg: 75 });
  page.store.update((state) => change(state));
  const { problems, state, coordinate } = page.now();
  return problems.map((problem) => sentence(problem, words, state.document, (angle) => coordinate.onto(angle))).join(" ");
}

test("an impossible length is named with its excess in the unit of lengths", () => {
  const long = (state) => withDocument(state, { l4: 2 });
  assert.match(said("mixer-a", long), /(l₄|frame).*0\.23/);
  assert.match(said("mixer-a", (state) => withDocument(state, { l1: 3, unit: "cm" }), en.measured("cm")), /0\.75\u00a0cm/);
  assert.match(said("mixer-a", long, ru), /0,23/);
});

test("an angle in a sentence is on the scale of its field", () => {
  for (const [typed, expected] of [[-165.5, "194.5°"], [170, "170°"], [555.25, "195.25°"]]) {
    const page = new Page("mixer-a", { phi_deg: 10 });
    for (const lengths of [{ l1: 0.8 }, { l2: 0.4 }]) {
      page.store.update((state) => withDocument(state, lengths));
      page.now();
    }
    page.store.update((state) => withView(state, { phi_deg: typed }));
    const { problems, state, coordinate } = page.now();
    assert.ok(problems.length > 0);
    const text = problems.map((problem) => sentence(problem, en, state.document, (angle) => coordinate.onto(angle))).join(" ");
    assert.ok(text.includes(expected), `${typed}: ${text}`);
  }
});

test("an angle is said as the scale of readers has it", () => {
  const problem = { code: "no_pose", phi: (-165.5 / 180) * Math.PI };
  const words = new Words("en", new Map([["problem.no_pose", "at {phi}"]]));
  assert.equal(sentence(problem, words, undefined, (angle) => angle + 360), "at 194.5°");
  assert.equal(sentence(problem, words), "at −165.5°");
});

test("fields are called by what they are of: a link, a point, the number of an entry", () => {
  const { document } = new Page("jansen").store.get();
  const first = document.links[0].name;
  assert.ok(fieldName("links[0].length", en, document).includes(called(first, en)));
  assert.ok(fieldName("points[2].x", en, document).includes(document.points[2].name));
  for (const words of LANGUAGES.map((lang) => wordsOf(lang))) {
    for (const field of ["l1", "z4", "module", "wheels[1].z", "wheels[0].centre_line_deg", "omega", "links[3].length", "points[0].y"]) {
      const name = fieldName(field, words, document);
      assert.ok(name.length > 1 && !/field\.|[{}]|undefined/.test(name), `${words.lang} ${field}: ${name}`);
    }
  }
  // If the document has no such link, the index replaces its name.
  assert.ok(fieldName("links[7].length", en, undefined).includes("7"));
});

test("links in a problem are called in the reader's language, lists one after the other", () => {
  const words = new Words("ru", new Map([...tableOf("ru"), ["problem.apart", "{links}; {shaft}"]]));
  assert.equal(sentence({ code: "apart", links: ["crank", "rocker"], shaft: "coupler" }, words), `${called("crank", ru)}, ${called("rocker", ru)}; ${called("coupler", ru)}`);
});

test("a code that nobody knows is said by its name", () => {
  assert.ok(sentence({ code: "something_new" }, en).includes("something_new"));
});

test("every refusal of a changed mechanism is a whole sentence in every language", () => {
  const changes = [
    (state) => withDocument(state, { l1: 0 }), (state) => withDocument(state, { z4: 1.5 }), (state) => withDocument(state, { module: -1 }), (state) => withDocument(state, { mesh: "internal", wheels: [{ z: 36, centre_line_deg: 0 }] }),
    (state) => withDocument(state, { wheels: [] }), (state) => withDocument(state, { tracers: [{ link: "nobody", x: 0, y: 0 }] }), (state) => withView(state, { plot: "nothing" }), (state) => withView(state, { omega: 2e4, axes: "physical" }),
    (state) => withView(state, { omega: 0, true_time: true }), (state) => withDocument(state, { l1: 0, l4: 9, z4: 0 }),
  ];
  for (const lang of LANGUAGES) {
    for (const change of changes) {
      const text = said("mixer-a", change, wordsOf(lang));
      assert.ok(text.length > 15 && !/[{}]|undefined|NaN|problem\.|field\./.test(text), `${lang}: ${text}`);
    }
  }
});

test("concentric wheels and several faults at once are all said", () => {
  const page = new Page("mixer-a", { phi_deg: 75 });
  const update = (change) => {
    page.store.update((state) => withDocument(state, change));
    return page.now().problems;
  };
  const wheels = (z) => [{ z, centre_line_deg: -40 }];
  const concentric = update({ mesh: "internal", wheels: wheels(36) });
  assert.equal(concentric.length, 1);
  const both = update({ l1: 0 });
  assert.ok(both.length >= 2 && both.some(({ field }) => field === "l1"), JSON.stringify(both));
  update({ l1: 0.37 });
  assert.deepEqual(update({ wheels: wheels(18) }), []);
});

test("what is wrong with a lesson is said by its place and its step", () => {
  const page = new Page("jansen");
  const { kind, document } = page.store.get();
  const good = { title: "Own", steps: [{ title: "", text: "", shows: { kind, document }, question: { text: "?", number: { quantity: "F.y", within: 0.1 } } }] };
  for (const [change, part] of [
    [(lesson) => (lesson.title = 7), "lesson.title"], [(lesson) => (lesson.steps = "all"), "lesson.steps"], [(lesson) => (lesson.steps = []), "Steps in the lesson"],
    [(lesson) => (lesson.steps[0].text = { html: "<b>" }), "lesson.steps[0].text"], [(lesson) => (lesson.steps[0].question.number.within = -1), "In step 1 of the lesson"],
    [(lesson) => (lesson.steps[0].shows.document.links = []), "In step 1 of the lesson"],
  ]) {
    const lesson = structuredClone(good);
    change(lesson);
    const { problems } = attempt(() => page.engine.functions.readState(withExtras(page.store.get(), { lesson })));
    const text = problems.map((problem) => sentence(problem, en)).join(" ");
    assert.ok(text.includes(part), text);
  }
});

test("numbers of a sentence have the sign of the language", () => {
  const text = said("mixer-a", (state) => withDocument(state, { l4: 2 }), wordsOf("uk"));
  const [number] = /\d+,\d+/.exec(text);
  assert.ok(Math.abs(parseNumber(number) - 0.23) < 1e-9, text);
});

test("what keeps a linkage from moving is said with what can be done about it", () => {
  for (const words of LANGUAGES.map((lang) => wordsOf(lang))) {
    for (const code of ["unsupported", "open", "underdriven", "locked", "instant", "no_driver", "loose", "misdrawn", "train_undetermined", "constraint_broken", "coincident", "with_itself"]) {
      const text = sentence({ code, links: ["crank", "rocker"], link: "crank", point: "A", points: ["A", "B"], mobility: 0, by: 0.5 }, words);
      const [what, ...remedy] = text.split(/(?<=[.])\s+(?=\p{Lu})/u);
      assert.ok(what.length > 20 && remedy.join(" ").length > 20, `${words.lang} ${code}: ${text}`);
    }
  }
});

test("a length is too long or too short, an angle or an offset too large or too small", () => {
  const document = { links: [{ name: "crank", points: ["A", "B"] }, { name: "plate", points: ["B", "C", "E"] }], slides: [], points: [] };
  const told = (code, field) => sentence({ code, field, links: ["coupler", "rocker"], by: 33.5, last: 4 }, wordsOf("en"), document);
  assert.equal(told("too_large", "links[0].length"), "Length of link crank is too long by 33.5; these links can no longer be joined: coupler, rocker. The last possible value is 4.");
  for (const [field, large, small] of [["links[0].length", "long", "short"], ["links[1].side[0][2]", "long", "short"], ["links[1].corner_deg[2]", "large", "small"], ["slides[0].offset", "large", "small"]]) {
    assert.ok(told("too_large", field).includes(` too ${large} by `) && told("too_small", field).includes(` too ${small} by `), field);
  }
  for (const words of LANGUAGES.map((lang) => wordsOf(lang))) {
    const [first] = sentence({ code: "too_large", field: "links[0].length", links: ["coupler"], by: 33.5, last: 4 }, words, document).split(/[.] /);
    assert.ok(first.split(":").length <= 2, first);
  }
});

test("what is locked without a driver is not told of too many drivers", () => {
  for (const words of LANGUAGES.map((lang) => wordsOf(lang))) {
    const told = (drivers) => sentence({ code: "locked", links: ["AB"], mobility: 0 }, words, { links: [], drivers });
    assert.notEqual(told([]), told([{ crank: "AB" }]));
    assert.equal(told([]), words.text("problem.locked_undriven", { mobility: "0", links: "AB" }));
  }
});

test("sides and angles of links are called by their points, offsets of slides by their lines, in degrees what is an angle", () => {
  const links = [{ name: "crank", points: ["A", "B"] }, { name: "plate", points: ["B", "C", "E"] }];
  const document = { links, slides: [{ link: "slider", point: "E", on: "frame", line: ["F", "G"] }], points: [] };
  for (const words of LANGUAGES.map((lang) => wordsOf(lang).measured("mm"))) {
    for (const [field, kind, n] of [
      ["slides[0].offset", "slides.offset", `${called("slider", words)}, E → F\u2060–\u2060G`],
      ["links[0].length", "links.length", called("crank", words)],
      ["links[1].length", "links.side", "plate, B\u2060–\u2060C"],
      ["links[1].side[0][2]", "links.side", "plate, B\u2060–\u2060E"],
      ["links[1].side[1][2]", "links.side", "plate, C\u2060–\u2060E"],
      ["links[1].corner_deg[2]", "links.corner", "plate, C\u2060–\u2060B\u2060–\u2060E"],
    ]) {
      assert.equal(fieldName(field, words, document), words.text(`field.${kind}`, { n }));
      const text = sentence({ code: "too_large", field, links: [], by: 1.5, last: 20 }, words, document);
      assert.equal(text.includes("20°"), kind === "links.corner", text);
      assert.equal(text.includes(words.unit), kind !== "links.corner", text);
    }
  }
});
