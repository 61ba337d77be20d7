import assert from "node:assert/strict";
import { hash } from "node:crypto";
import { test } from "node:test";
import { brotliDecompressSync, gunzipSync } from "node:zlib";
import { hosted, packed } from "./host.js";
import { inline } from "./page.js";

const PAGE = `<head><meta charset="utf-8">
<meta data-in="host" http-equiv="Content-Security-Policy" content=""><meta data-in="host" name="build" content="">
<script type="importmap">{}</script><script>1 < 2</script><link rel="modulepreload" href="app/main.js"><link rel="icon" href="data:,">
</head><body></body>`;

const SITE = Object.freeze({
  "app/main.js": "1",
  "lang/en.json": "{}",
  "assur-mechanism.js": "2",
  "docs/note.html": "<style>a {}</style>",
  "index.html": "as it is served",
  "offline/service-worker.js": "self.version.split(` `)",
});

/**
 * @param {Record<string, string>} [changes]
 * @param {string} [page]
 */
function host(changes = {}, page = PAGE) {
  const built = new Map(Object.entries({ ...SITE, ...changes }).map(([name, text]) => [name, Buffer.from(text)]));
  return new Map([...hosted(built, page)].map(([name, content]) => [name, String(content)]));
}

test("only the page says names with hashes", () => {
  const files = host();
  const [main, words] = ["1", "{}"].map((text) => hash("sha256", text).slice(0, 8));
  const names = [`files/${main}.js`, `files/${words}.json`];
  const fixed = ["_headers", "assur-mechanism.js", "docs/note.html", "index.html", "service-worker.js"];
  assert.deepEqual([...files.keys()].sort(), [...fixed, ...names].sort());
  const page = files.get("index.html") ?? "";
  assert.ok(page.includes(`"assur/app/main.js":"./files/${main}.js"`), page);
  assert.ok(page.includes(`"assur/lang/en.json":"./files/${words}.json"`), page);
  assert.ok(page.includes(`modulepreload" href="files/${main}.js"`), page);
  const kept = ["./", "assur-mechanism.js", "docs/note.html", ...names.sort()].join(" ");
  assert.match(files.get("service-worker.js") ?? "", new RegExp(`^self\\.version="[0-9a-f]{20} ${kept}";self\\.version\\.split`));
});

test("what is inline has its hash and nothing else runs", () => {
  const files = host();
  const page = files.get("index.html") ?? "";
  const [, policy] = /Content-Security-Policy" content="([^"]*)"/.exec(page) ?? [];
  assert.deepEqual(inline(page, "script").length, 2);
  for (const content of [...inline(page, "script"), "a {}"]) {
    assert.ok(policy.includes(`'sha256-${hash("sha256", content, "base64")}'`), content);
  }
  assert.equal(policy.split("'sha256-").length - 1, 3);
  assert.ok(!policy.includes("'unsafe-"), policy);
  assert.ok(files.get("_headers")?.includes(policy));
});

test("every change is another build", () => {
  const build = (/** @type {Record<string, string>} */ changes, page = PAGE) => {
    const files = host(changes, page);
    const [, name] = /name="build" content="([^"]*)"/.exec(files.get("index.html") ?? "") ?? [];
    assert.ok(files.get("service-worker.js")?.startsWith(`self.version="${name} ./ `));
    return name;
  };
  assert.equal(build({}), build({}));
  const all = ["app/main.js", "lang/en.json", "docs/note.html", "offline/service-worker.js"].map((name) => build({ [name]: "other" }));
  assert.equal(new Set([build({}), ...all, build({}, `${PAGE}<p>`)]).size, 6);
});

test("a file that is missing is a sentence", () => {
  assert.throws(() => host({}, PAGE.replace("app/main.js", "app/mine.js")), /links to app\/mine\.js, which the site does not hold/);
  assert.throws(() => hosted(new Map([["app/main.js", Buffer.from("1")]]), PAGE), /there is no offline\/service-worker\.js/);
});

test("what becomes smaller is packed beside itself", async () => {
  const long = "1".repeat(1000);
  const given = new Map([["a.js", long], ["b.js", "1"], ["files/c.js", long], ["_headers", long]]);
  const earlier = Buffer.from("packed");
  const files = await packed(given, new Map([["a.js.br", earlier], ["files/c.js.br", earlier]]));
  const more = [...files.keys()].filter((name) => !given.has(name));
  assert.deepEqual(more.sort(), ["a.js.br", "a.js.gz", "files/c.js.br", "files/c.js.gz"]);
  assert.equal(String(brotliDecompressSync(files.get("a.js.br") ?? "")), long);
  assert.equal(String(gunzipSync(files.get("files/c.js.gz") ?? "")), long);
  // An earlier copy is reused only if the name contains a hash, because only then is the content known to be the same.
  assert.equal(files.get("files/c.js.br"), earlier);
});
