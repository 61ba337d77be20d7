// The engine of the built page without room on its stack: every call then overflows the stack, as too deep a recursion would.
import { readFileSync } from "node:fs";
import { initSync } from "assur/pkg/assur_web.js";
import { WASM } from "assur/tests/engine.js";

/** `GLOBALS`, `EXPORTS`: ids of these sections of a wasm module. `GLOBAL`: kind of an exported global. */
const GLOBALS = 6;
const EXPORTS = 7;
const GLOBAL = 3;
/** Index of the global in which compilers of the LLVM family keep the stack pointer. `NAME`: name under which it is exported here. */
const STACK_POINTER = 0;
const NAME = "stack_pointer";

/** @type {WebAssembly.Instance} the instance made last */
let running;
globalThis.WebAssembly.Instance = class extends WebAssembly.Instance {
  constructor(...args) {
    super(...args);
    running = this;
  }
};

/** Starts the module with its stack pointer as an additional export. The shipped module has no such export. */
export function begin() {
  initSync({ module: withExport(readFileSync(WASM)) });
}

/** Leaves no room on the stack, which begins at the lowest address. */
export function exhaust() {
  running.exports[NAME].value = 0;
}

/**
 * @param {Uint8Array} wasm
 * @returns {Uint8Array} the module with a stack of size 0, which every call overflows
 */
export function withoutStack(wasm) {
  const bytes = Uint8Array.from(wasm);
  let at = 8;
  for (let [size, begin] = leb(bytes, at + 1); bytes[at] !== GLOBALS; [size, begin] = leb(bytes, at + 1)) at = begin + size;
  // The first global follows the number of globals: i32, mutable, i32.const and its value. The value is overwritten by 0, in as many bytes.
  const [, first] = leb(bytes, leb(bytes, at + 1)[1]);
  const [, end] = leb(bytes, first + 3);
  bytes.fill(0x80, first + 3, end - 1);
  bytes[end - 1] = 0;
  return bytes;
}

/**
 * @param {Uint8Array} wasm
 * @returns {Uint8Array} the module with one more export
 */
function withExport(wasm) {
  let at = 8;
  while (at < wasm.length) {
    const [size, begin] = leb(wasm, at + 1);
    if (wasm[at] !== EXPORTS) {
      at = begin + size;
      continue;
    }
    const [count, first] = leb(wasm, begin);
    const name = new TextEncoder().encode(NAME);
    const body = [...toLeb(count + 1), ...wasm.subarray(first, begin + size), name.length, ...name, GLOBAL, STACK_POINTER];
    return Uint8Array.from([...wasm.subarray(0, at), EXPORTS, ...toLeb(body.length), ...body, ...wasm.subarray(begin + size)]);
  }
  throw new Error("the module exports nothing");
}

/**
 * @param {Uint8Array} bytes
 * @param {number} at
 * @returns {[number, number]} an unsigned number in LEB128, and the index after its end
 */
function leb(bytes, at) {
  let value = 0;
  for (let shift = 0; ; shift += 7, at++) {
    value |= (bytes[at] & 0x7f) << shift;
    if (bytes[at] < 0x80) return [value, at + 1];
  }
}

/** @param {number} value */
function toLeb(value) {
  return value < 0x80 ? [value] : [(value & 0x7f) | 0x80, ...toLeb(value >>> 7)];
}
