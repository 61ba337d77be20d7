import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { once } from "node:events";
import { connect } from "node:net";
import path from "node:path";
import { createInterface } from "node:readline";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { brotliCompressSync } from "node:zlib";
import { write } from "./files.js";
import { temporary } from "./temporary.js";

const FILES = Object.freeze({
  "index.html": "the page",
  "a b.js": "export {};",
  "docs/note.html": "<p>",
  "pkg/engine.wasm": "\0asm",
  "../outside.js": "1",
});

/**
 * @param {import("node:test").TestContext} context
 * @param {string[]} options
 * @param {Record<string, string>} [more]
 */
async function started(context, options = [], more = {}) {
  const root = path.join(temporary(context), "site");
  write(root, new Map(Object.entries({ ...FILES, ...more })));
  const server = spawn(process.execPath, [fileURLToPath(new URL("serve.js", import.meta.url)), root, ...options]);
  context.after(() => server.kill());
  const lines = createInterface({ input: server.stdout });
  const [url] = await once(lines, "line");
  const tell = async (/** @type {string} */ line) => {
    server.stdin.write(`${line}\n`);
    assert.equal((await once(lines, "line"))[0], line);
  };
  return { url, server, tell, root };
}

/**
 * @param {string} url
 * @param {string} request request line without the HTTP version
 * @param {string} [more] further header lines
 * @returns {Promise<string>} the raw answer. `fetch` is not used, because it would normalise the address
 */
async function ask(url, request, more = "") {
  const socket = connect(Number(new URL(url).port), "127.0.0.1");
  socket.setEncoding("latin1");
  socket.write(`${request} HTTP/1.1\r\nHost: x\r\nConnection: close\r\n${more}\r\n`);
  let answer = "";
  for await (const part of socket) answer += part;
  return answer;
}

test("a file is served with type, length and no caching", async (context) => {
  const { url } = await started(context);
  for (const [address, type] of [
    ["/", "text/html;charset=utf-8"],
    ["/index.html?x=1", "text/html;charset=utf-8"],
    ["/a%20b.js", "text/javascript"],
    ["/pkg/engine.wasm", "application/wasm"],
  ]) {
    const answer = await ask(url, `GET ${address}`);
    assert.match(answer, /^HTTP\/1\.1 200 /, address);
    assert.match(answer, new RegExp(`content-type: ${type}\r`, "i"));
    assert.match(answer, /content-length: \d+\r/i);
    assert.match(answer, /cache-control: no-store\r/i);
  }
  assert.match(await ask(url, "GET /"), /\r\n\r\nthe page$/);
  const head = await ask(url, "HEAD /");
  assert.match(head, /^HTTP\/1\.1 200 [^]*\r\n\r\n$/);
  assert.match(await ask(url, "POST /"), /^HTTP\/1\.1 405 /);
});

test("nothing leads out of the folder", async (context) => {
  const { url } = await started(context);
  const outside = ["/..", "/../outside.js", "/%2e%2e/outside.js", "/docs/..%2f..%2foutside.js", "/..%5coutside.js"];
  for (const address of [...outside, "//etc/passwd", "/%2fetc/passwd", "/%ff", "/docs", "/absent.html"]) {
    assert.match(await ask(url, `GET ${address}`), /^HTTP\/1\.1 404 /, address);
  }
});

/** Browsers open connections in advance and leave some of them idle. */
test("idle connections keep no one waiting", async (context) => {
  const { url } = await started(context);
  const idle = Array.from({ length: 20 }, () => connect(Number(new URL(url).port), "127.0.0.1"));
  context.after(() => idle.forEach((socket) => socket.destroy()));
  await Promise.all(idle.map((socket) => once(socket, "connect")));
  for (let times = 0; times < 20; times++) assert.match(await ask(url, "GET /"), /^HTTP\/1\.1 200 /);
});

test("a taken port gives the next one", async (context) => {
  const { url } = await started(context);
  const { port } = new URL(url);
  const next = new URL((await started(context, ["--port", port])).url);
  assert.ok(Number(next.port) > Number(port), next.href);
});

test("packed files and headers are sent as a folder asks", async (context) => {
  const rules = "/*\n  X-One: 1\n  Cache-Control: no-cache\n/files/*\n  ! X-One\n  Cache-Control: immutable\n";
  const { url, root } = await started(context, ["--below", "/courses/"], { _headers: rules, "files/a.js": "1".repeat(100) });
  assert.equal(new URL(url).pathname, "/courses/");
  assert.match(await ask(url, "GET /courses/"), /x-one: 1\r[^]*cache-control: no-cache\r/i);
  assert.match(await ask(url, "GET /files/a.js"), /^HTTP\/1\.1 404 /);
  write(root, new Map([["files/a.js.br", brotliCompressSync("1".repeat(100))]]));
  const plain = await ask(url, "GET /courses/files/a.js");
  assert.match(plain, /cache-control: immutable\r[^]*1{100}$/i);
  assert.doesNotMatch(plain, /x-one|content-encoding/i);
  const packed = await ask(url, "GET /courses/files/a.js", "Accept-Encoding: gzip, br\r\n");
  assert.match(packed, /content-type: text\/javascript\r/i);
  assert.match(packed, /content-encoding: br\r/i);
  assert.match(packed, /vary: accept-encoding\r/i);
});

test("it is steered line by line and ends with its input", async (context) => {
  const { url, server, tell } = await started(context);
  const other = temporary(context, { "index.html": "another version" });
  await tell(`serve ${other}`);
  assert.match(await ask(url, "GET /"), /another version$/);
  await tell("down");
  assert.equal(await ask(url, "GET /").catch(() => ""), "");
  await tell("up");
  assert.match(await ask(url, "GET /"), /another version$/);
  server.stdin.end();
  assert.deepEqual(await once(server, "exit"), [0, null]);
});
