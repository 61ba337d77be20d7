import assert from "node:assert/strict";
import { test } from "node:test";
import { list } from "./files.js";
import { bundle } from "./scripts.js";
import { temporary } from "./temporary.js";

const PAGE = Object.freeze({
  "app/main.js": `import { start } from "assur/core/start.js";
    import init, * as engine from "assur/pkg/assur_web.js";
    import { LESSONS, SCRIPTS } from "assur/lessons/index.js";
    import { HERE, LATER } from "assur/kinds/index.js";
    start(init, engine.role(), LESSONS, SCRIPTS, HERE, LATER, () => import("assur/late.js"), () => import("../later.js"));`,
  "core/start.js": "export function start(...all) { globalThis.started = all; }\nexport const shared = (n) => n + 41;",
  "pkg/assur_web.js": "export default function init() {}\nexport function role() { return 'ROLE'; }",
  "late.js": `import * as start from "assur/core/start.js";
    import common, { more } from "./common.js";
    export const late = [start.shared(1), common, more];`,
  "later.js": 'export * from "./common.js";\nexport { default } from "./common.js";',
  "common.js": "const common = { here: 1 };\nexport default common;\nexport const more = Math.random();",
  "worker.js": 'import { role } from "assur/pkg/assur_web.js";\npostMessage(role());',
  "late.test.js": 'import "node:test";',
  "kinds/first/kind.js": "export const views = () => [];",
  "kinds/first/kind.json": '{ "first": true }',
  "kinds/second/kind.js": "export const views = () => [2];",
  "lessons/one/lesson.js": "export const LESSON = { steps: [1] };",
  "lessons/one/lesson.json": '{ "about": [] }',
  "lessons/one/words.en.json": "{}",
  "lessons/two/lesson.js": "export const LESSON = { steps: [2] };",
  "lessons/two/lesson.json": '{ "about": [] }',
  "lessons/two/words.en.json": "{}",
});

/**
 * @param {import("node:test").TestContext} test
 * @param {Record<string, string>} [changes]
 */
const bundled = (test, changes) => bundle(list(temporary(test, { ...PAGE, ...changes })));

test("the first view is one chunk, each part that is loaded later another", async (context) => {
  const scripts = await bundled(context);
  const parts = ["common.js", "kinds/second/kind.js", "late.js", "later.js", "lessons/one/lesson.js", "lessons/two/lesson.js"];
  assert.deepEqual([...scripts.keys()].sort(), ["app/main.js", ...parts, "pkg/assur_web.js", "worker.js"]);
  const main = scripts.get("app/main.js") ?? "";
  for (const name of ["late.js", "later.js", "lessons/one/lesson.js", "kinds/second/kind.js"]) {
    assert.match(main, new RegExp(`import\\([\`"']assur/${name}[\`"']\\)`));
  }
  // The engine is a separate module with all its exports. The page imports it by its bare name, as other pages may.
  assert.doesNotMatch(main, /ROLE/);
  assert.match(main, /from"assur\/pkg\/assur_web\.js"/);
  const { default: init, role } = await import(`data:text/javascript,${encodeURIComponent(scripts.get("pkg/assur_web.js") ?? "")}`);
  assert.deepEqual([init(), role()], [undefined, "ROLE"]);
});

test("chunks import each other by bare names", async (context) => {
  const scripts = await bundled(context);
  for (const [name, script] of scripts) assert.doesNotMatch(script, /(from|import\(?)\s*["'`]\.{1,2}\//, name);
  assert.match(scripts.get("late.js") ?? "", /from"assur\/app\/main\.js"/);
  // Import maps do not apply in workers, so the script of a worker contains everything that it imports.
  assert.doesNotMatch(scripts.get("worker.js") ?? "", /\bimport\b/);
  assert.match(scripts.get("worker.js") ?? "", /ROLE/);
});

test("a file more at the head of the alphabet changes one chunk", async (context) => {
  const before = await bundled(context);
  const after = await bundled(context, {
    "aaa/first.js": "export const first = (n) => 3 * n;",
    "lessons/one/lesson.js": 'import { first } from "assur/aaa/first.js";\nexport const LESSON = { steps: [first(globalThis.n)] };',
  });
  assert.deepEqual([...after.keys()].sort(), [...before.keys()].sort());
  const changed = [...after].filter(([name, script]) => script !== before.get(name)).map(([name]) => name);
  assert.deepEqual(changed, ["lessons/one/lesson.js"]);
});

test("of the comments only notices of licences stay", async (context) => {
  const scripts = await bundled(context, { "worker.js": "// Ours.\n/*! Notice of a library. */\n/** @param {number} n */\nconst ours = (n) => n + 1;\npostMessage(ours(globalThis.n));" });
  const worker = scripts.get("worker.js") ?? "";
  assert.match(worker, /Notice of a library/);
  assert.doesNotMatch(worker, /Ours|@param/);
});

test("what cannot be bundled is a sentence", async (context) => {
  for (const [name, script, sentence] of /** @type {const} */ ([
    ["late.js", "const = 1;", /late\.js/],
    ["late.js", 'import { nothing } from "assur/core/start.js"; nothing();', /nothing/],
    ["late.js", 'import "assur/nowhere.js";', /nowhere\.js/],
    ["lost.js", 'import "assur/common.js";', /lost\.js is imported by no other script/],
  ])) {
    await assert.rejects(bundled(context, { [name]: script }), sentence);
  }
});
