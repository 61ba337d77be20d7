// Tests of the worksheets of a class: each has all that is needed to solve it on paper, and no answer.
import assert from "node:assert/strict";
import test from "node:test";
import { all } from "assur/tests/document.js";
import { Context } from "assur/tests/canvas.js";
import { numberEntries } from "assur/core/names.js";
import { given } from "assur/lesson/given.js";
import { sheets } from "assur/lesson/sheets.js";
import { answerOf } from "assur/lesson/tasks.js";
import { initialState } from "assur/state/state.js";
import { Page } from "assur/tests/page.js";

globalThis.OffscreenCanvas = class OffscreenCanvas {
  getContext() {
    return Object.assign(new Context(), { getImageData: () => ({ data: [0, 0, 0, 255] }) });
  }
};

const page = new Page("mixer-a");
// The rail of the mixer sets the same numbers.
numberEntries("wheels", (index) => String(index + 5));

/** Worksheet with a task about a mechanism of the catalogue, and the answer of the task. */
function printed(id, vary = [], quantity = "input", name = "Ann") {
  const { kind, document } = page.engine.catalogue.preset(id);
  const lesson = { title: "Own", steps: [{ title: "Task", text: "", shows: { kind, document, view: { phi_deg: 30 }, vary }, question: { text: "How much?", number: { quantity, within: 0.001 } } }] };
  const sheet = sheets(lesson, [name], false, page, page.words);
  return { said: all(sheet, "p").map(({ textContent }) => textContent).join("\n"), answer: answerOf(lesson, 0, name, page.engine) };
}

for (const [id, wanted] of [
  ["crank-rocker", ["lAB = 2", "lBC = 6", "lBM = 3.605551", "lCM = 3.605551", "lDC = 4.5", "xA = 0", "yA = 0", "xD = 6", "yD = 0"]],
  ["class4-dwell", ["lAB = 1", "yD = −4.78"]],
  // D is the pivot of the lever; G and H are on the guide of the ram.
  ["shaper", ["lAB = 1.25", "lDE = 7", "lEF = 2.5", "xD = 0", "yD = −4", "yG = 2.825", "yH = 2.825"]],
  ["geared-five-bar", ["lBC = 3.2", "crank: z = 40", "follower: z = 20"]],
  ["mixer-a", ["Crank l₁ = 0.37\u00a0m", "Module m = 0.0165\u00a0m", "Number of teeth z₄ = 36", "Wheel 5, number of teeth = 18", "Wheel 5, centre-line angle = −40"]],
  ["train-magnets", ["Sun, z₁ = 20", "Input shaft 1 (sun), speed, min⁻¹ = 60", "Input shaft 2 (ring), speed, min⁻¹ = 12"]],
]) {
  test(`a sheet has every given number of ${id}`, () => {
    const { said } = printed(id);
    for (const one of wanted) assert.ok(said.includes(one), `${one}: ${said}`);
    assert.doesNotMatch(said, /undefined|NaN|field\.|damping|inertia|working member|factor c|tolerance/);
  });
}

test("points that links carry are given where they are on them", () => {
  const { kind, document } = page.engine.catalogue.preset("crank-rocker");
  const tracers = [{ name: "P", link: "rocker", at: [1.5, -2] }];
  const said = given(initialState(kind, { ...document, tracers, unit: "m" }, {}), page.engine, page.words.measured("m"));
  assert.ok(said.includes("P (rocker): x = 1.5\u00a0m, y = −2\u00a0m"), said.join("; "));
});

test("lengths and coordinates go by symbols with the points as subscripts, or by words where a point has a longer name", () => {
  const { kind, document } = page.engine.catalogue.preset("crank-rocker");
  const renamed = JSON.parse(JSON.stringify(document).replaceAll('"A"', '"bearing"'));
  const said = (its) => given(initialState(kind, its, {}), page.engine, page.words);
  assert.deepEqual(said(document).slice(0, 1), ["l_AB = 2"]);
  assert.ok(said(document).includes("x_D = 6"));
  assert.deepEqual(said(renamed).slice(0, 2), ["length of bearing-B = 2", "l_BC = 6"]);
  assert.ok(said(renamed).includes("x of bearing = 0"));
  const subscripts = all(sheets({ title: "Own", steps: [{ title: "Task", text: "", shows: { kind, document } }] }, [], false, page, page.words), "sub");
  assert.equal(subscripts[0].textContent, "AB");
});

test("lengths are those of the reader, and the answer is none of them", () => {
  const vary = [{ field: "links[0].length", from: 1, to: 2, step: 0.05 }];
  const [ann, bo] = ["Ann", "Bo"].map((name) => printed("crank-rocker", vary, "rocker.angle", name));
  const length = ({ said }) => Number(/lAB = ([\d.]+)/.exec(said)[1]);
  assert.notEqual(length(ann), length(bo));
  for (const one of [ann, bo]) {
    assert.ok(one.said.includes(`= ${length(one)}`) && length(one) >= 1 && length(one) <= 2);
    assert.ok(!one.said.includes(one.answer.toFixed(2)), one.said);
  }
});

for (const [id, field, [from, to], wanted, unit = "none"] of [
  ["jansen", "links[2].corner_deg[2]", [89, 91], /Angle of link .+ = \d\d(\.\d+)?°$/m],
  ["mixer-a", "wheels[0].centre_line_deg", [-50, -30], /centre-line angle = −\d\d(\.5)?°$/m],
  ["crank-rocker", "links[0].length", [1.5, 2], /Length of link crank = [\d.]+\u00a0mm$/m, "mm"],
  ["crank-rocker", "links[0].length", [1.5, 2], /Length of link crank = [\d.]+$/m],
  ["mixer-a", "l1", [0.3, 0.4], /Crank l₁ = [\d.]+\u00a0m$/m],
]) {
  test(`a reader's own number has its unit: ${field} in ${unit}`, () => {
    const { kind, document } = page.engine.catalogue.preset(id);
    const shows = { kind, document: kind === "linkage" ? { ...document, unit } : document, view: { phi_deg: 30 }, vary: [{ field, from, to, step: 0.5 }] };
    const lesson = { title: "Own", steps: [{ title: "Task", text: "", shows, question: { text: "How much?", number: { quantity: "input", within: 0.001 } } }] };
    for (const answers of [false, true]) {
      const [{ textContent }] = all(sheets(lesson, ["Ann"], answers, page, page.words), ".own");
      assert.match(textContent, wanted);
    }
  });
}

/** Worksheet with a question about a mechanism, and the answer of the question. */
function asking(id, number, { text = "How much?", unit, view = {}, question = { text, number } } = {}) {
  const { kind, document } = page.engine.catalogue.preset(id);
  const shows = { kind, document: unit ? { ...document, unit } : document, view: { phi_deg: 30, ...view } };
  const lesson = { title: "Own", steps: [{ title: "Task", text: "", shows, question }, { title: "Again", text: "", question }] };
  const [tasks, answers] = [false, true].map((told) => sheets(lesson, [], told, page, page.words));
  const of = (sheet, selector) => all(sheet, selector).map(({ textContent }) => textContent);
  return { asked: of(tasks, "b")[1], given: of(tasks, ".given"), drawn: of(tasks, "figure"), answers: of(answers, ".answer") };
}

test("the tolerance of an answer stands before the mark that ends the question", () => {
  const number = { quantity: "rocker.angle", within: 0.001 };
  for (const [text, wanted] of [
    ["How much?", "How much (to within 0.001°)?"], ["Find it, at 60°.", "Find it, at 60° (to within 0.001°)."], ["The angle", "The angle (to within 0.001°)"],
  ]) assert.equal(asking("crank-rocker", number, { text }).asked, wanted);
});

test("a number of freedoms is whole: it has no tolerance", () => {
  assert.equal(asking("crank-rocker", { quantity: "W", within: 0.1 }).asked, "How much?");
});

test("a driver position of a question is drawn and said, also where nothing else is shown", () => {
  const { drawn, given: said } = asking("crank-rocker", { quantity: "rocker.angle", within: 0.5, at: 120 });
  assert.match(drawn[0], /φ₁ = 120\.0°/);
  assert.deepEqual(said.slice(1), ["φ₁ = 120°", "φ₁ = 120°"]);
  assert.ok(asking("crank-rocker", { quantity: "rocker.angle", within: 0.5 }).given.every((line) => !line.startsWith("φ₁")));
});

for (const [id, quantity, unit, more] of [
  ["crank-rocker", "C.x", "\u00a0mm", { unit: "mm" }],
  ["crank-rocker", "C.x", ""],
  ["crank-rocker", "C.x′", "\u00a0mm", { unit: "mm" }],
  ["crank-rocker", "C.x′", "\u00a0mm/s", { unit: "mm", view: { axes: "physical" } }],
  ["crank-rocker", "rocker.angle′", ""],
  ["crank-rocker", "rocker.angle″", "\u00a0rad/s²", { view: { axes: "physical" } }],
  ["crank-rocker", "rocker.angle:time_ratio", ""],
  ["crank-rocker", "rocker.angle:swing", "°"],
  ["slider-crank", "C.x:swing", "\u00a0m", { unit: "m" }],
  ["train-gears", "sun.angle′", "\u00a0rad/s"],
  ["mixer-a", "C2.x", "\u00a0m"],
]) {
  test(`an answer and its tolerance have their unit: ${quantity} of ${id}${unit && ","}${unit}`, () => {
    const { asked, answers } = asking(id, { quantity, within: 0.5 }, more);
    assert.equal(asked, `How much (to within 0.5${unit})?`);
    assert.equal(answers.length, 2);
    for (const answer of answers) assert.match(answer, new RegExp(`^[−\\d.]+${unit}$`));
  });
}

test("a value to be reached has its unit", () => {
  const reach = { quantity: "C.x", value: 3, within: 0.1 };
  assert.match(asking("crank-rocker", null, { unit: "mm", question: { text: "Go there.", reach } }).answers[0], /= 3\u00a0mm$/);
});
