import assert from "node:assert/strict";
import { test } from "node:test";
import { gunzipSync } from "node:zlib";
import { single } from "./single.js";

const PAGE = `<link data-in="site host" rel="modulepreload" href="app/main.js"><link rel="stylesheet" href="style.css"><link rel="icon" href="data:,">
<script type="importmap">{"imports":{"assur/":"./"}}</script><script type="module">import "assur/app/main.js";</script>`;

/** @param {Record<string, string>} [changes] */
function file(changes = {}) {
  const site = {
    "app/main.js": "</script>",
    "docs/note.html": "<p>",
    "index.html": "as it is served",
    "lang/en.json": "{}",
    "linkage/style.css": "a { color: blue }",
    "offline/service-worker.js": "1",
    "assur-mechanism.js": "2",
    "pkg/first.wasm": "\0asm, first part",
    "pkg/second.wasm": "\0asm, second part",
    "style.css": "body { color: red }",
    ...changes,
  };
  return single(new Map(Object.entries(site).map(([name, text]) => [name, Buffer.from(text)])), PAGE, Buffer.from("\0asm"));
}

/** @param {string} page */
function imports(page) {
  const [, map] = /<script type="importmap">(.*?)<\/script>/.exec(page) ?? [];
  return JSON.parse(map).imports;
}

test("every script, table, late style sheet and the wasm is in the import map", () => {
  const map = imports(file());
  const names = ["app/main.js", "lang/en.json", "linkage/style.css", "pkg/first.wasm"];
  assert.deepEqual(Object.keys(map).sort(), names.map((name) => `assur/${name}`));
  assert.ok(map["assur/linkage/style.css"].startsWith("data:text/css;charset=utf-8;base64,"));
  assert.ok(map["assur/app/main.js"].startsWith("data:text/javascript;charset=utf-8;base64,"));
  const unpacked = (/** @type {string} */ name) => {
    const [, packed] = map[name].split("data:application/gzip;base64,");
    return gunzipSync(Buffer.from(packed, "base64")).toString();
  };
  assert.equal(unpacked("assur/pkg/first.wasm"), "\0asm");
  assert.equal(unpacked("assur/lang/en.json"), "{}");
});

test("nothing is left outside the file, and nothing that is in it is asked for", () => {
  const page = file();
  assert.ok(page.includes("<style>body { color: red }</style>"), page);
  assert.doesNotMatch(page, /stylesheet|preload|assur-mechanism/);
  assert.equal(page.split("</script>").length, PAGE.split("</script>").length);
});

test("what cannot go in is a sentence", () => {
  assert.throws(() => single(new Map(), PAGE, Buffer.from("")), /there is no style\.css/);
  assert.throws(() => file({ "picture.odd": "1" }), /no media type is known for picture\.odd/);
});
