// The engine in two parts, on the page and in its workers. The first part calls the second only when it needs it.
import init, { initSync, second } from "assur/pkg/assur_web.js";

/** @typedef {{ first: WebAssembly.Module, second: WebAssembly.Module | null }} Parts `second` is null if the first part is the whole engine */

/** Name of the section that is the same in both parts of one build. */
const BUILD = "build";

/**
 * @param {WebAssembly.Module} first
 * @returns {boolean} whether there is a second part
 */
export function isDivided(first) {
  return WebAssembly.Module.imports(first).some(({ module }) => module === "second");
}

/** A call needed the second part, which did not load. */
export class NotLoaded extends Error {}

/**
 * Starts the engine.
 * @param {WebAssembly.Module} first
 * @param {() => WebAssembly.Module | null} getSecond called by each instance of the first part when it first needs the second
 */
export async function start(first, getSecond) {
  second.load = () => {
    try {
      const part = getSecond();
      if (!part || buildOf(part) !== buildOf(first)) throw new Error("the parts of the engine are of different builds");
      // After a start, this gives the exports of the running instance.
      new WebAssembly.Instance(part, { first: { ...initSync({ module: first }) } });
    } catch (cause) {
      throw new NotLoaded("the second part of the engine did not load", { cause });
    }
  };
  await init({ module_or_path: first });
}

/** @param {WebAssembly.Module} part */
function buildOf(part) {
  return WebAssembly.Module.customSections(part, BUILD).map((section) => new Uint8Array(section).join()).join();
}
