// The engine as compiled wasm, for the page and its workers, in two parts: what a first view needs, and the rest.
import { fetched } from "assur/core/fetched.js";
import { isDivided, start } from "assur/core/parts.js";

/** @typedef {import("assur/core/parts.js").Parts} Parts */

const FIRST = "assur/pkg/first.wasm";
const SECOND = "assur/pkg/second.wasm";

/** @type {Map<string, Promise<WebAssembly.Module>>} parts that are loading or have loaded */
const parts = new Map();

/** @type {WebAssembly.Module | null} the second part, once it has loaded */
let second = null;

/** Starts the engine on the page with its first part. */
export async function startEngine() {
  await start(await part(FIRST), () => (second ??= loadedAtOnce(SECOND)));
}

/** @returns {Promise<Parts>} the engine, compiled once for the page and its workers; after a failure, the next call tries again */
export async function compiledWasm() {
  const first = await part(FIRST);
  if (isDivided(first)) second ??= await part(SECOND);
  return { first, second };
}

/** @param {string} name of a part, which is loaded unless it is loading or has loaded */
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
 * Loads a part while the page waits, for a call that needs it before it has loaded.
 * @param {string} name
 * @returns {WebAssembly.Module}
 */
function loadedAtOnce(name) {
  const request = new XMLHttpRequest();
  request.open("GET", import.meta.resolve(name), false);
  // A request that the page waits for gives a text. In this character set, each byte is the low byte of a character.
  request.overrideMimeType("text/plain; charset=x-user-defined");
  request.send();
  if (request.status !== 200) throw new Error(`${request.status} ${name}`);
  return new WebAssembly.Module(Uint8Array.from(request.responseText, (character) => character.charCodeAt(0)));
}
