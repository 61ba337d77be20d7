// The engine as compiled wasm, for the page and its workers.
import { fetched } from "assur/core/fetched.js";

/** @type {Promise<WebAssembly.Module> | null} */
let compiled = null;

/** @returns {Promise<WebAssembly.Module>} the engine, compiled once for the page and its workers; after a failure, the next call tries again */
export function compiledWasm() {
  if (!compiled) {
    compiled = fetched("assur/pkg/assur_web_bg.wasm", "application/wasm").then(compile);
    compiled.catch(() => (compiled = null));
  }
  return compiled;
}

/**
 * Compiles wasm while it is loading if the server sends it with the media type of wasm, otherwise after loading.
 * @param {Response} response
 */
async function compile(response) {
  const streams = response.headers.get("Content-Type") === "application/wasm";
  return streams ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
}
