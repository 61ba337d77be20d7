// The engine as compiled wasm, for the page and its workers, in two parts: the functions of a first view, and all others.
import { fetched } from "assur/core/fetched.js";
import { isDivided, matching, start } from "assur/core/parts.js";

/** @typedef {import("assur/core/parts.js").Parts} Parts */

const FIRST = "assur/pkg/first.wasm";
const SECOND = "assur/pkg/second.wasm";

/** Shortest time between blocking requests, in milliseconds. */
const PAUSE = 5000;

/** @type {Map<string, Promise<WebAssembly.Module>>} parts that are loading or have loaded */
const parts = new Map();

/** @type {WebAssembly.Module | null} the second part, once it has loaded */
let second = null;

/** Time of the last blocking request. */
let asked = -Infinity;

/** Starts the engine on the page with its first part. */
export async function startEngine() {
  const first = await part(FIRST);
  await start(first, () => (second ??= matching(loadedBlocking(SECOND), first)));
}

/** @returns {Promise<Parts>} the engine, compiled once for the page and its workers; after a failure, the next call tries again */
export async function compiledWasm() {
  const first = await part(FIRST);
  if (isDivided(first)) second ??= matching(await part(SECOND), first);
  return { first, second };
}

/** @param {string} name of a part, which is loaded only once unless it fails to load */
function part(name) {
  const loading = parts.get(name) ?? fetched(name, "application/wasm").then(compile);
  parts.set(name, loading);
  loading.catch(() => parts.delete(name));
  return loading;
}

/**
 * Compiles wasm while it is loading if the server sends it with the media type of wasm, otherwise after loading.
 * @param {Response} response
 */
async function compile(response) {
  const streams = response.headers.get("Content-Type") === "application/wasm";
  return streams ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
}

/**
 * Loads a part by a blocking request, for a call that needs the part before it has loaded.
 * @param {string} name
 * @returns {WebAssembly.Module}
 */
function loadedBlocking(name) {
  if (performance.now() < asked + PAUSE) throw new Error(`${name} has just failed to load`);
  asked = performance.now();
  const request = new XMLHttpRequest();
  request.open("GET", import.meta.resolve(name), false);
  // A blocking request gives only text. In this character set, the low byte of each character is a byte of the file.
  request.overrideMimeType("text/plain; charset=x-user-defined");
  request.send();
  const { status, responseText: text } = request;
  if (status !== 200) throw new Error(`${status} ${name}`);
  const bytes = new Uint8Array(text.length);
  for (let at = 0; at < text.length; at++) bytes[at] = text.charCodeAt(at);
  return new WebAssembly.Module(bytes);
}
