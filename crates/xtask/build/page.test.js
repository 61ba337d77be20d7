import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { Page, fill, inline } from "./page.js";
import { ROOT } from "./temporary.js";

/** @type {Record<string, import("./folders.js").Table>} */
const WORDS = {
  be: { name: "Assur", wait: "чакайце", odd: "?" },
  en: { name: "Assur", wait: 'wait <"&">', lone: "!" },
  ru: { name: "Ассур", wait: "подождите", odd: "?" },
};
const TABLES = new Map(Object.entries(WORDS));

test("a title is English and the rest is in every language", () => {
  const page = "<title>{{name}}</title><p>{{ name }}, {{version}}, {{languages}}</p>";
  assert.equal(fill(page, TABLES, "1.2.3"), "<title>Assur</title><p>Assur · Ассур, 1.2.3, be en ru</p>");
});

test("words are escaped", () => {
  assert.equal(fill('<p title="{{wait}}">', TABLES, "1"), '<p title="wait &lt;&quot;&amp;&quot;&gt; · чакайце · подождите">');
});

test("missing words name key and language", () => {
  assert.throws(() => fill("{{lone}}", TABLES, "1"), /`lone`, which be\.json lacks/);
  assert.throws(() => fill("{{odd}}", TABLES, "1"), /`odd`, which en\.json lacks/);
  assert.throws(() => fill("<title>{{odd}}</title>", TABLES, "1"), /`odd`, which en\.json lacks/);
  assert.throws(() => fill("<p>{{wait</p>", TABLES, "1"), /does not close/);
});

test("a page without places stays as it is", () => {
  assert.equal(fill("a } b { c {d}", TABLES, "1"), "a } b { c {d}");
});

test("an element with data-in is only in the outputs that it names", () => {
  const page = "<p data-in=\"site host\">1</p><!-- 0 -->\n  <p data-in='host'>2</p><p>3</p>";
  assert.equal(new Page(page, "site").text(), "<p>1</p>\n<p>3</p>\n");
  assert.equal(new Page(page, "host").text(), "<p>1</p>\n<p>2</p><p>3</p>\n");
  assert.equal(new Page(page, "file").text(), "<p>3</p>\n");
});

test("what is put in cannot end its element", () => {
  const page = new Page("<script type=importmap>{}</script><link rel=stylesheet href=a.css>", "file");
  page.setImportMap({ a: "</script><p>" });
  page.putStylesInside(() => "a::before{content:'</STYLE>'}");
  const script = '<script type=importmap>{"imports":{"a":"\\u003c/script>\\u003cp>"}}</script>';
  assert.equal(page.text(), `${script}<style>a::before{content:'<\\/STYLE>'}</style>\n`);
});

test("style sheets keep their order", () => {
  const page = new Page("<link rel=stylesheet href=a.css><link rel=stylesheet href=b.css>", "file");
  page.putStylesInside((name) => `/* ${name} */`);
  assert.equal(page.text(), "<style>/* a.css */</style><style>/* b.css */</style>\n");
});

test("a place that is missing, or there twice, is a sentence", () => {
  assert.throws(() => new Page("<p>", "file").setImportMap({}), /index\.html has no script\[type=importmap\]/);
  const twice = "<script type=importmap></script>".repeat(2);
  assert.throws(() => new Page(twice, "file").setImportMap({}), /index\.html has more than one script\[type=importmap\]/);
  assert.throws(() => new Page("<p>", "host").setMeta('name="build"', "1"), /index\.html has no meta\[name="build"\]/);
});

/** Indentation and quotes of the source have no effect on the built page. */
test("the page of the repository survives reformatting", () => {
  const page = readFileSync(path.join(ROOT, "www/index.html"), "utf8");
  const reformatted = page
    .replaceAll("<script ", "<script\n  ")
    .replaceAll(/(<meta|<link) ([^>]*)>/g, (_, tag, attributes) => `${tag}\n   ${attributes.replaceAll(/"([^"']*)"/g, "'$1'")}\n  >`)
    .replaceAll('type="importmap"', "type=importmap");
  assert.notEqual(reformatted, page);
  const outputs = [page, reformatted].map((text) => {
    const host = new Page(text, "host");
    host.setImportMap({ a: "b" });
    host.setLinks((name) => `files/${name}`);
    host.setMeta('http-equiv="Content-Security-Policy"', "policy");
    host.setMeta('name="build"', "build");
    // Only white space, and quotes within tags, may differ.
    return host.text().replaceAll("'", '"').replaceAll(/\s+/g, " ").replaceAll(/ ?> ?/g, ">").replaceAll('"importmap"', "importmap");
  });
  assert.equal(outputs[1], outputs[0]);
  for (const part of ['content="policy"', 'content="build"', 'href="files/app/main.js"', '{"imports":{"a":"b"}}', "serviceWorker"]) {
    assert.ok(outputs[0].includes(part), part);
  }
});

test("inline scripts and styles are read as they stand", () => {
  const page = "<script>1 < 2 && '<b>'</script><script src=a.js></script><style>a {}</style>";
  assert.deepEqual(inline(page, "script"), ["1 < 2 && '<b>'"]);
  assert.deepEqual(inline(page, "style"), ["a {}"]);
});
