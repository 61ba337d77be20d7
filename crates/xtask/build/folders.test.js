import assert from "node:assert/strict";
import { cpSync, readFileSync, renameSync, rmSync, writeFileSync } from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { list } from "./files.js";
import { kinds, lessons, lists, words } from "./folders.js";
import { ROOT, temporary } from "./temporary.js";

const FIXTURE = path.join(ROOT, "tests/data/page/lessons/fixture");
const RUSSIAN = path.join(ROOT, "lang/ru.json");

/**
 * @param {import("node:test").TestContext} test
 * @returns {string} a folder with copies of the lessons and kinds of `www`
 */
function copy(test) {
  const folder = temporary(test);
  for (const part of ["lessons", "kinds"]) cpSync(path.join(ROOT, "www", part), path.join(folder, part), { recursive: true });
  return folder;
}

test("a folder more is a lesson more", (context) => {
  const www = copy(context);
  const before = lessons(list(www));
  assert.deepEqual(before.map(({ id }) => id), ["mixer", "class4-dwell", "synthesis", "mobility", "differential", "assemblies", "mixer-forces", "run-up", "poses-paths"]);
  cpSync(FIXTURE, path.join(www, "lessons/fixture"), { recursive: true });
  // The lesson has no `place`, so it comes last.
  assert.deepEqual(lessons(list(www)), [...before, { id: "fixture", about: ["chebyshev"], presets: true, paper: false, notes: false }]);
  const text = lists(list(www)).get("assur/lessons/index.js") ?? "";
  assert.ok(text.includes('"fixture": () => import("assur/lessons/fixture/lesson.js")'), text);
});

test("what is no lesson is a sentence", (context) => {
  /** @type {[RegExp, (folder: string) => void][]} */
  const faults = [
    [/the lesson fixture has no lesson\.js/, (folder) => rmSync(path.join(folder, "lesson.js"))],
    [/the lesson fixture has no words\.en\.json/, (folder) => rmSync(path.join(folder, "words.en.json"))],
    [/lessons\/fixture\/lesson\.json cannot be read/, (folder) => rmSync(path.join(folder, "lesson.json"))],
    [/lesson\.json does not say what it is about/, (folder) => writeFileSync(path.join(folder, "lesson.json"), "{}")],
    [/lesson\.json has an unknown field title/, (folder) => writeFileSync(path.join(folder, "lesson.json"), '{ "about": [], "title": 1 }')],
    [/small letters, digits and hyphens/, (folder) => renameSync(folder, path.join(folder, "../Fix ture"))],
    [/the name of one that is saved in the state/, (folder) => renameSync(folder, path.join(folder, "../own"))],
  ];
  for (const [sentence, spoil] of faults) {
    const www = temporary(context);
    const folder = path.join(www, "lessons/fixture");
    cpSync(FIXTURE, folder, { recursive: true });
    spoil(folder);
    assert.throws(() => lessons(list(www)), sentence);
  }
});

test("what lessons are called is in the words of the page", (context) => {
  const www = copy(context);
  const before = JSON.parse(readFileSync(RUSSIAN, "utf8"));
  const table = words(list(www), RUSSIAN, "ru");
  const own = JSON.parse(readFileSync(path.join(www, "lessons/mixer/words.ru.json"), "utf8"));
  assert.equal(table["lessons.mixer.title"], own.title);
  const ofKinds = kinds(list(www)).map(({ id }) => list(www).get(`kinds/${id}/words.ru.json`)).filter((file) => file !== undefined);
  const more = ofKinds.flatMap((file) => Object.keys(JSON.parse(readFileSync(file, "utf8"))));
  assert.equal(Object.keys(table).length, Object.keys(before).length + more.length + 2 * lessons(list(www)).length);
  assert.deepEqual(Object.keys(table), Object.keys(table).sort());
  writeFileSync(path.join(www, "lessons/mixer/words.ru.json"), "{}");
  assert.throws(() => words(list(www), RUSSIAN, "ru"), /the lesson mixer has no title in its words of ru/);
});

test("a folder more is a kind more", (context) => {
  const www = copy(context);
  assert.deepEqual(kinds(list(www)).filter(({ first }) => first), [{ id: "mixer", first: true }]);
  const folder = path.join(www, "kinds/another");
  cpSync(path.join(ROOT, "www/kinds/draft"), folder, { recursive: true });
  writeFileSync(path.join(folder, "words.ru.json"), '{ "kind.another": "Another" }');
  assert.deepEqual(kinds(list(www))[0], { id: "another", first: false });
  const text = lists(list(www)).get("assur/kinds/index.js") ?? "";
  assert.ok(text.includes('["another", () => import("assur/kinds/another/kind.js")]'), text);
  assert.equal(words(list(www), RUSSIAN, "ru")["kind.another"], "Another");
  writeFileSync(path.join(folder, "kind.json"), '{ "first": 1 }');
  assert.throws(() => kinds(list(www)), /kinds\/another\/kind\.json does not say whether it is first/);
  rmSync(path.join(folder, "kind.js"));
  assert.throws(() => kinds(list(www)), /the kind another has no kind\.js/);
});
