// The engine in two parts, on the page and in its workers. The first part calls the second only when it needs it.
import init, { initSync, second as loader } from "assur/pkg/assur_web.js";

/** @typedef {{ first: WebAssembly.Module, second: WebAssembly.Module | null }} Parts `second` is null if the first part is the whole engine */

/** Name of the section that is the same in both parts of one build. */
const BUILD = "build";

/** Exception of a call that needed the second part, which did not load. */
export class NotLoaded extends Error {}

/**
 * @param {WebAssembly.Module} first
 * @returns {boolean} whether there is a second part
 */
export function isDivided(first) {
  return WebAssembly.Module.imports(first).some(({ module }) => module === "second");
}

/**
 * @param {WebAssembly.Module} second
 * @param {WebAssembly.Module} first
 * @returns {WebAssembly.Module} the second part; throws if it is of another build than the first
 */
export function matching(second, first) {
  if (buildOf(second) !== buildOf(first)) throw new Error("the two parts of the engine are of different builds");
  return second;
}

/**
 * Starts the engine.
 * @param {WebAssembly.Module} first
 * @param {() => WebAssembly.Module | null} getSecond called by each instance of the first part when it first needs the second
 */
export async function start(first, getSecond) {
  loader.load = () => {
    const second = loadedBy(getSecond);
    // Once started, `initSync` only returns the exports of the present instance.
    new WebAssembly.Instance(second, { first: { ...initSync({ module: first }) } });
  };
  await init({ module_or_path: first });
}

/** @param {() => WebAssembly.Module | null} getSecond */
function loadedBy(getSecond) {
  try {
    const second = getSecond();
    if (second) return second;
  } catch (cause) {
    throw new NotLoaded("the second part of the engine did not load", { cause });
  }
  throw new NotLoaded("the engine has no second part");
}

/** @param {WebAssembly.Module} part */
function buildOf(part) {
  return WebAssembly.Module.customSections(part, BUILD).map((section) => new Uint8Array(section).join()).join();
}
