// Tests of lecturers' questions: readers' own numbers in every kind of document, answers, verdicts.
import assert from "node:assert/strict";
import test from "node:test";
import { attempt } from "assur/core/problem.js";
import { parseNumber } from "assur/core/numbers.js";
import { toCode, fromCode } from "assur/lesson/code.js";
import { degrees } from "assur/core/angles.js";
import { isAngle, quantityName, unitOf } from "assur/lesson/quantity.js";
import { QUESTIONS, changed, shownNow, sortOf, withMoved, withNewStep, withStep, withoutStep } from "assur/lesson/steps.js";
import { answerOf, quantities, shownBy, taskOf, valueOf } from "assur/lesson/tasks.js";
import { digestOf, verdictOn } from "assur/lesson/verdict.js";
import { initialState, withExtras } from "assur/state/state.js";
import { newEngine, stateOf } from "assur/tests/engine.js";
import { Page } from "assur/tests/page.js";
import { snapshotOf } from "assur/tests/shown.js";
import { wordsOf } from "assur/tests/words.js";

const engine = newEngine();
const words = wordsOf("en");

/**
 * Makes a lesson of one step that shows a document with varied numbers and asks for a quantity.
 * @param {{ kind: string, document: object }} shown
 */
function lessonOf({ kind, document }, vary, number) {
  return { title: "Own", steps: [{ title: "", text: "", shows: { kind, document, view: { phi_deg: 30 }, vary }, question: { text: "?", number: { within: 0.001, ...number } } }] };
}

/** The value of a field of a document, such as `wheels[0].z`. */
const at = (document, field) => field.split(/[.[\]]+/).filter(Boolean).reduce((part, key) => part[key], document);

/** A five-bar whose second crank turns at a fixed rate to the first. */
const FIVE_BAR = {
  points: [["A", 0, 0], ["B", 0.6, 0.8], ["C", 2.6, 3], ["D", 4.6, 0.8], ["E", 4, 0]].map(([name, ...at]) => ({ name, at })),
  frame: ["A", "E"],
  links: ["AB", "BC", "CD", "ED"].map((name) => ({ name, points: [...name] })),
  drivers: [{ crank: "AB" }, { crank: "ED", rate: 2 }],
};
const train = engine.catalogue.preset("train-magnets");
const driven = { ...train, document: { ...train.document, drives: [{ shaft: "sun", rpm: 60 }, { shaft: "ring", rpm: 0 }] } };
const positions = { kind: "synthesis", document: { frame: 10, positions: [{ output_deg: 240, input_deg: 45 }, { output_deg: 253, input_deg: 60 }] } };

for (const [what, shown, vary] of [
  ["a mixer", engine.catalogue.preset("mixer-a"), [
    { field: "wheels[0].z", from: 16, to: 30, step: 2 }, { field: "l1", from: 0.3, to: 0.4, step: 0.01 }, { field: "wheels[0].centre_line_deg", from: -60, to: 60, step: 15 },
  ]],
  ["a differential", driven, [{ field: "drives[0].rpm", from: 20, to: 80, step: 5 }, { field: "magnets.peak[1]", from: 2, to: 4, step: 0.5 }]],
  ["positions of a synthesis", positions, [{ field: "positions[1].output_deg", from: 250, to: 258, step: 1 }, { field: "frame", from: 8, to: 12, step: 0.5 }]],
  ["a linkage with a second crank", { kind: "linkage", document: FIVE_BAR }, [{ field: "points[0].y", from: -0.1, to: 0.1, step: 0.05 }, { field: "drivers[1].rate", from: 1, to: 3, step: 1 }]],
]) {
  test(`numbers of ${what} are one's own, and steps of their ranges`, () => {
    const lesson = lessonOf(shown, vary, { value: 1 });
    const all = ["Ann", "Bo", "Cai", "Dee", "Eve"].map((name) => {
      const { state, own } = taskOf(lesson, 0, name, engine);
      assert.deepEqual(own.map(({ field }) => field), vary.map(({ field }) => field));
      for (const [i, { field, value }] of own.entries()) {
        const { from, to, step } = vary[i];
        assert.ok(value >= from && value <= to && Math.abs((value - from) / step - Math.round((value - from) / step)) < 1e-6, `${field} ${value}`);
        // A coordinate of a hinge is found at its point, every other number by the path of its field.
        const [, point, axis] = /^points\[(\d+)\]\.([xy])$/.exec(field) ?? [];
        // A rate of 1 is the default and is not stored.
        const found = axis ? state.document.points[point].at["xy".indexOf(axis)] : (at(state.document, field) ?? 1);
        assert.ok(Math.abs(found - value) < 1e-9, `${field}: ${found} ${value}`);
      }
      engine.set(state);
      return JSON.stringify(own);
    });
    assert.ok(new Set(all).size >= 3, String(all));
    assert.equal(JSON.stringify(taskOf(lesson, 0, "  aNN ", engine).own), all[0]);
    // Without a name the lecturer's numbers stay.
    assert.deepEqual(taskOf(lesson, 0, "  ", engine).own, []);
  });
}

test("a length of one's own makes a mechanism, and the answer is that of the mechanism", () => {
  const jansen = engine.catalogue.preset("jansen");
  const crank = jansen.document.links[0].points.find((name) => !jansen.document.frame.includes(name));
  const lesson = lessonOf(jansen, [{ field: "links[0].length", from: 12, to: 18, step: 0.5 }], { quantity: `${crank}.y` });
  const lengths = ["Ann", "Carl", "  aNN "].map((name) => {
    const { own: [{ value }] } = taskOf(lesson, 0, name, engine);
    // The crank's pin is l₁ sin 30° above its pivot.
    assert.ok(Math.abs(answerOf(lesson, 0, name, engine) - value * 0.5) < 1e-9);
    assert.equal(verdictOn(lesson, 0, (value * 0.5).toFixed(3), name, engine), "right");
    assert.equal(verdictOn(lesson, 0, String(value * 0.5 + 0.01), name, engine), "not_yet");
    return value;
  });
  assert.notEqual(lengths[0], lengths[1]);
  assert.equal(lengths[0], lengths[2]);
});

test("the swing of a wheel is that of the rocker by the teeth that one has", () => {
  const mixer = engine.catalogue.preset("mixer-a");
  const vary = [{ field: "wheels[0].z", from: 16, to: 30, step: 2 }];
  const [wheel, rocker] = ["wheel5", "rocker"].map((link) => lessonOf(mixer, vary, { quantity: `${link}.angle:swing` }));
  for (const name of ["Ann", "Bo", "Cai"]) {
    const { state: { document } } = taskOf(wheel, 0, name, engine);
    const expected = (answerOf(rocker, 0, name, engine) * document.z4) / document.wheels[0].z;
    assert.ok(Math.abs(answerOf(wheel, 0, name, engine) - expected) < 1e-6);
  }
});

test("a speed of a differential is that of one's own drive", () => {
  const lesson = lessonOf(driven, [{ field: "drives[0].rpm", from: 20, to: 80, step: 5 }], { quantity: "sun.angle′" });
  const { own: [{ value }] } = taskOf(lesson, 0, "Ann", engine);
  assert.ok(Math.abs(answerOf(lesson, 0, "Ann", engine) - (value * Math.PI) / 30) < 1e-9);
});

test("numbers that make no mechanism are drawn again; where none do there is no task", () => {
  const mixer = engine.catalogue.preset("mixer-a");
  const some = lessonOf(mixer, [{ field: "l4", from: 0.5, to: 2, step: 0.1 }], { value: 1 });
  for (const name of ["Ann", "Bo", "Cai", "Dee", "Eve", "Fay"]) {
    const { state } = taskOf(some, 0, name, engine);
    assert.equal(engine.set(state).cycle.full, true, name);
  }
  assert.equal(taskOf(lessonOf(mixer, [{ field: "l4", from: 5, to: 9, step: 0.5 }], { value: 1 }), 0, "Ann", engine), null);
});

test("what a step shows may be what a step before it does", () => {
  const { steps: [step] } = lessonOf(engine.catalogue.preset("jansen"), [], { value: 1 });
  const lesson = { title: "", steps: [{ title: "", text: "" }, step, { title: "", text: "" }] };
  assert.deepEqual([0, 1, 2].map((index) => shownBy(lesson, index)?.index), [undefined, 1, 1]);
  assert.equal(taskOf(lesson, 0, "Ann", engine), null);
});

test("verdicts: numbers within a tolerance with comma or point, choices, what was reached", () => {
  const { shows } = lessonOf(engine.catalogue.preset("jansen"), [], {}).steps[0];
  const lesson = { title: "", steps: [
    { title: "", text: "", shows, question: { text: "", number: { quantity: "input", at: 40, within: 0.5 } } },
    { title: "", text: "", question: { text: "", choice: { options: ["II", "III", "IV"], answer: 1 } } },
    { title: "", text: "", question: { text: "", reach: { quantity: "input", value: 90, within: 2 } } },
    { title: "", text: "", question: { text: "", number: { quantity: "nobody.x", within: 1 } } },
  ] };
  const verdicts = [[0, "41", "not_yet"], [0, "forty", "unread"], [0, "", "unread"], [0, "40,4", "right"], [0, "40.5°", "right"], [0, "40.51", "not_yet"],
    [1, "", "unanswered"], [1, "0", "not_yet"], [1, "1", "right"], [2, "1", "right"], [2, "", "not_yet"], [3, "1", "none"]];
  for (const [step, given, verdict] of verdicts) assert.equal(verdictOn(lesson, step, given, "Ann", engine), verdict, `${step} ${given}`);
});

test("an angle may be told a turn more or less, a length may not", () => {
  const lesson = (quantity) => lessonOf(engine.catalogue.preset("crank-rocker"), [], { quantity });
  const angle = answerOf(lesson("rocker.angle"), 0, "", engine);
  for (const turns of [-2, 0, 1]) assert.equal(verdictOn(lesson("rocker.angle"), 0, String(angle + 360 * turns), "", engine), "right");
  const swing = answerOf(lesson("rocker.angle:swing"), 0, "", engine);
  assert.equal(verdictOn(lesson("rocker.angle:swing"), 0, String(swing + 360), "", engine), "not_yet");
});

test("a lesson is identified by its content, not by how it is written down", () => {
  const jansen = engine.catalogue.preset("jansen");
  const lesson = lessonOf(jansen, [], { quantity: "F.y" });
  const read = engine.functions.readState(withExtras(initialState(jansen.kind, jansen.document, {}), { lesson })).lesson;
  assert.equal(digestOf(read, engine), digestOf(lesson, engine));
  assert.notEqual(digestOf({ ...lesson, title: "Other" }, engine), digestOf(lesson, engine));
  // A code of one form of the lesson belongs to the other form, too.
  const code = toCode({ lesson: digestOf(lesson, engine), name: "Ann Lee", answers: [{ given: "40,4", tries: 1, shown: false }] });
  assert.equal(fromCode(code).lesson, digestOf(read, engine));
});

test("every quantity that is offered has a value, a name and a unit", () => {
  for (const id of ["crank-rocker", "mixer-a", "jansen", "train-gears", "whitworth"]) {
    const snapshot = snapshotOf(engine, stateOf(engine, id, { phi_deg: 62 }));
    const names = quantities(snapshot);
    assert.ok(names.length > 0, id);
    for (const name of names) {
      assert.ok(Number.isFinite(valueOf(name, snapshot)), `${id} ${name}`);
      const said = quantityName(name, snapshot, words);
      assert.ok(said.length > 0 && !/undefined|write\./.test(said), `${id} ${name}: ${said}`);
      const unit = unitOf({ quantity: name, within: 0 });
      assert.equal(unit, isAngle(name) || name === "input" ? "°" : "", name);
    }
    assert.equal(new Set(names.map((name) => quantityName(name, snapshot, words))).size, names.length, `${id}: two quantities have one name`);
  }
});

test("quantities are named by what their links are called in the reader’s language", () => {
  const russian = wordsOf("ru");
  const named = (id, quantity) => quantityName(quantity, snapshotOf(engine, stateOf(engine, id), russian), russian);
  assert.equal(named("crank-rocker", "rocker.angle′"), "φ′ коромысло");
  assert.equal(named("crank-rocker", "C.transmission"), "μ C");
  assert.equal(named("mixer-a", "rocker.angle"), "φ₃ (коромысло)");
  assert.equal(named("mixer-a", "wheel5.angle:swing"), "размах: ψ₅ (колесо 5)");
  assert.equal(named("mixer-a", "C2.x″"), "x″ (C₂)");
  // The range of an angle is called its swing, that of a length its stroke.
  assert.equal(named("slider-crank", "C.x:swing"), "ход: x (C)");
});

test("the angle between two links that a reader measures is asked for in degrees", () => {
  const measures = ["crank-rocker.between"];
  const snapshot = snapshotOf(engine, stateOf(engine, "crank-rocker", { phi_deg: 62, measures }));
  const [between] = quantities(snapshot).filter((name) => name.endsWith(".between"));
  assert.equal(unitOf({ quantity: between, within: 0 }), "°");
  assert.equal(valueOf(between, snapshot), degrees(snapshot.readouts.value(between)));
});

test("the unit of an answer is the one that its question gives", () => {
  assert.equal(unitOf({ unit: "mm", quantity: "rocker.angle" }), "mm");
});

test("steps of a lesson are put in, moved, changed and taken away; the last one stays, empty", () => {
  const empty = { title: "", text: "" };
  let lesson = { title: "", steps: [{ title: "a", text: "" }, { title: "b", text: "" }] };
  const titles = () => lesson.steps.map(({ title }) => title).join("");
  lesson = withStep(withNewStep(lesson, 0), 1, { title: "x" });
  assert.equal(titles(), "axb");
  lesson = withMoved(lesson, 1, 1);
  assert.equal(titles(), "abx");
  lesson = withoutStep(withoutStep(lesson, 0), 1);
  assert.equal(titles(), "b");
  assert.deepEqual(withoutStep(lesson, 0).steps, [empty]);
  assert.deepEqual(changed({ a: 1, b: 2 }, { b: undefined, c: null, d: 0 }), { a: 1, d: 0 });
});

test("a question of each sort is recognised by its parts, and the engine takes it", () => {
  const jansen = engine.catalogue.preset("jansen");
  for (const [sort, make] of Object.entries(QUESTIONS)) {
    const question = make("?", undefined, "F.y");
    assert.equal(sortOf(question), sort);
    engine.functions.readLesson({ title: "", steps: [{ title: "", text: "", shows: { kind: jansen.kind, document: jansen.document }, ...(question && { question }) }] });
  }
  assert.equal(sortOf(null), "none");
});

test("what is on the page becomes what a step shows, without what is the reader's", () => {
  const page = new Page("jansen", { phi_deg: 30, lang: "ru", projector: true, axes: "physical" });
  page.model.follow(page.store.get());
  const { kind, view, document } = shownNow(page);
  assert.deepEqual([kind, view], ["linkage", { phi_deg: 30, axes: "physical" }]);
  assert.equal(document, page.store.get().document);
});

test("a lesson that is none is refused by its place", () => {
  const jansen = engine.catalogue.preset("jansen");
  const good = lessonOf(jansen, [], { quantity: "F.y" });
  const refusal = (change) => {
    const lesson = structuredClone(good);
    change(lesson);
    return attempt(() => engine.functions.readState(withExtras(initialState(jansen.kind, jansen.document, {}), { lesson }))).problems.map((problem) => JSON.stringify(problem)).join();
  };
  assert.equal(refusal(() => {}), "");
  for (const [change, said] of [
    [(lesson) => (lesson.title = 7), "lesson.title"], [(lesson) => (lesson.steps = "all"), "lesson.steps"], [(lesson) => (lesson.steps = []), "steps"],
    [(lesson) => (lesson.steps[0].text = { html: "<b>" }), "lesson.steps[0].text"], [(lesson) => (lesson.steps[0].question.number.within = -1), "step"],
    [(lesson) => (lesson.steps[0].shows.document.links = []), "step"], [(lesson) => (lesson.steps[0].shows.vary = [{ field: "nothing", from: 0, to: 1, step: 1 }]), "step"],
  ]) {
    assert.ok(refusal(change).includes(said), refusal(change));
  }
});

test("every number that stands beside a drawing can be varied", () => {
  const fields = engine.functions.numbersOf(stateOf(engine, "mixer-a")).map(({ field }) => field);
  assert.deepEqual(fields, ["l1", "l2", "l3", "l4", "z4", "module", "wheels[0].z", "wheels[0].centre_line_deg"]);
  for (const { id } of engine.catalogue.presets) {
    const state = stateOf(engine, id);
    for (const { field, value } of engine.functions.numbersOf(state)) assert.ok(Number.isFinite(value), `${id} ${field}`);
  }
  assert.equal(parseNumber(words.numbers.exact(0.0165)), 0.0165);
});
