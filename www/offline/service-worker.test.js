// Tests of the service worker, with stand-ins for the storage, the network and versions of the page.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import test, { beforeEach } from "node:test";

const SCOPE = "https://assur.test/app/";
const SOURCE = readFileSync(new URL("service-worker.js", import.meta.url), "utf8");

/** @type {Map<string, Map<string, Response>>} */
const stores = new Map();
const storeOf = (name) => ({
  put: async (url, response) => void stores.get(name).set(url, response),
  match: async (url) => stores.get(name)?.get(url.url ?? url)?.clone(),
});
globalThis.caches = {
  open: async (name) => {
    if (!stores.has(name)) stores.set(name, new Map());
    return storeOf(name);
  },
  has: async (name) => stores.has(name),
  keys: async () => [...stores.keys()],
  delete: async (name) => stores.delete(name),
  match: async (url) => [...stores.values()].find((store) => store.has(url.url ?? url))?.get(url.url ?? url).clone(),
};

/** Responses of the network, by path; a function makes its own response. */
let net = {};
let asked = [];
globalThis.fetch = async (request, { cache = "default" } = {}) => {
  const url = request.url ?? request;
  asked.push(`${cache} ${url.slice(SCOPE.length)}`);
  const answer = net[url.slice(SCOPE.length)];
  if (answer === undefined) return new Response("", { status: 404 });
  if (answer instanceof Error) throw answer;
  return typeof answer === "function" ? answer(cache) : new Response(answer);
};

let events;
let skipped;
globalThis.self = { registration: { scope: SCOPE }, clients: { claim: async () => {} }, skipWaiting: async () => void (skipped += 1) };
globalThis.addEventListener = (type, listener) => (events[type] = listener);

/**
 * Starts a version of the worker, as the build writes it.
 * @param {string} build
 * @param {...string} files
 */
async function version(build, ...files) {
  events = {};
  const script = `self.version=${JSON.stringify([build, ...files].join(" "))};${SOURCE}`;
  await import(`data:text/javascript,${encodeURIComponent(`${script}\n// ${Math.random()}`)}`);
  const own = events;
  const step = (type) => new Promise((done, fail) => own[type]({ waitUntil: (promise) => promise.then(done, fail) }));
  const get = async (path, method = "GET", base = SCOPE) => {
    let answer = null;
    own.fetch({ request: new Request(base + path, { method }), respondWith: (promise) => (answer = promise) });
    return answer && (await (await answer).text());
  };
  return { install: () => step("install"), activate: () => step("activate"), get };
}

beforeEach(() => {
  stores.clear();
  asked = [];
  skipped = 0;
  net = { "": "page of b1", "./": "page of b1", "files/a.js": "a", "files/b.js": "b", "notes.html": "n" };
});

test("a version that is whole answers without a network, the page under both of its names", async () => {
  const worker = await version("b1", "./", "files/a.js", "notes.html");
  await worker.install();
  assert.equal(skipped, 1);
  await worker.activate();
  net = {};
  for (const [path, text] of [["", "page of b1"], ["index.html", "page of b1"], ["?embed=stage", "page of b1"], ["files/a.js", "a"], ["notes.html", "n"]]) assert.equal(await worker.get(path), text, path);
});

test("a version that is not whole is none", async () => {
  for (const change of [{ "files/b.js": undefined }, { "files/b.js": new TypeError("no net") }, { "": "page of b0" }]) {
    Object.assign(net, { "": "page of b1", "files/b.js": "b" }, change);
    const worker = await version("b1", "./", "files/a.js", "files/b.js");
    await assert.rejects(worker.install());
    assert.deepEqual([[...stores.keys()], skipped], [[], 0]);
  }
});

test("a version that is whole outlives an install that fails", async () => {
  const worker = await version("b1", "./", "files/a.js");
  await worker.install();
  net = { "": new TypeError("no net") };
  const again = await version("b1", "./", "files/a.js");
  await assert.rejects(again.install());
  assert.equal(await worker.get("files/a.js"), "a");
  assert.equal(await worker.get(""), "page of b1");
});

test("a file that any version kept is taken from there, all else is asked for anew", async () => {
  await (await version("b1", "./", "files/a.js", "notes.html")).install();
  asked = [];
  net[""] = "page of b2";
  await (await version("b2", "./", "files/a.js", "files/b.js", "notes.html")).install();
  assert.deepEqual(asked.toSorted(), ["default files/b.js", "no-cache ", "no-cache notes.html"]);
});

test("what was kept as missing by the browser is asked for once more", async () => {
  net["files/a.js"] = (cache) => (cache === "reload" ? new Response("a") : new Response("", { status: 404 }));
  const worker = await version("b1", "./", "files/a.js");
  await worker.install();
  net = {};
  assert.equal(await worker.get("files/a.js"), "a");
});

test("of old versions one is kept: an open page of it may ask for more of its parts", async () => {
  for (const build of ["b1", "b2", "b3"]) {
    net[""] = `page of ${build}`;
    net[`files/${build}.js`] = build;
    const worker = await version(build, "./", `files/${build}.js`);
    await worker.install();
    await worker.activate();
  }
  const last = await version("b3", "./");
  net = {};
  assert.deepEqual([...stores.keys()].map((name) => name.split(" ").at(-1)), ["b2", "b3"]);
  assert.equal(await last.get("files/b2.js"), "b2");
  assert.equal(await last.get(""), "page of b3");
});

test("stores of other pages are let alone", async () => {
  await caches.open(`assur https://assur.test/ b0`);
  await caches.open("somebody else's");
  for (const build of ["b1", "b2", "b3"]) {
    net[""] = `page of ${build}`;
    const worker = await version(build, "./");
    await worker.install();
    await worker.activate();
  }
  assert.deepEqual([...stores.keys()].slice(0, 2), ["assur https://assur.test/ b0", "somebody else's"]);
});

test("what is not kept comes from the network; what is not asked of this page, or not read, is not answered", async () => {
  const worker = await version("b1", "./");
  await worker.install();
  net["more.json"] = "more";
  assert.equal(await worker.get("more.json"), "more");
  assert.equal(await worker.get("more.json", "POST"), null);
  assert.equal(await worker.get("x", "GET", "https://elsewhere.test/"), null);
  assert.equal(await worker.get("other/", "GET", "https://assur.test/"), null);
});
