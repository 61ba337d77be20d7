// How the state travels: in an address and in a file. Only the wrapping is read here; what is in it the engine checks.
import { Refusal } from "assur/core/problem.js";

/**
 * @typedef {import("assur/state/state.js").State} State
 */

/**
 * The version of the address: `#2&kind=mixer&d.l1=0.37&…&v.phi_deg=62`. A value is JSON, or else text. Older versions, by
 * the name that the kind had in them, are read for ever; tests/links.txt holds links of each.
 */
const VERSION = "2";
const KINDS = Object.freeze(/** @type {Record<string, string | undefined>} */ ({ 1: "lesson", [VERSION]: "kind" }));
const PARTS = /** @type {const} */ ({ "d.": "document", "v.": "view" });

/** Longer and deeper ones are none of ours. */
const LONGEST = 100_000;
const DEEPEST = 8;

/** @returns {Refusal} the text is no state, whatever is in it */
function unreadable() {
  return new Refusal([{ code: "not_settings" }]);
}

/**
 * @param {State} state
 * @returns {string} what follows the # of an address
 */
export function toAddress(state) {
  const pairs = [`kind=${encode(state.kind)}`];
  for (const [prefix, part] of Object.entries(PARTS)) {
    const entries = Object.entries(state[part]).filter(([, value]) => value !== null && value !== undefined);
    for (const [key, value] of entries) pairs.push(`${prefix}${encodeURIComponent(key)}=${encode(value)}`);
  }
  return [VERSION, ...pairs].join("&");
}

/**
 * @param {string} hash what follows the #
 * @returns {unknown} for the engine to check
 */
export function fromAddress(hash) {
  if (hash.length > LONGEST) throw unreadable();
  const [version, ...pairs] = hash.split("&");
  const kind = Object.hasOwn(KINDS, version) ? KINDS[version] : undefined;
  if (kind === undefined) throw unreadable();
  const entries = pairs.map((pair) => {
    const at = pair.indexOf("=");
    return at < 0 ? [plain(pair), null] : [plain(pair.slice(0, at)), decode(pair.slice(at + 1))];
  });
  // fromEntries makes own properties of all keys, also of __proto__.
  const part = (/** @type {string} */ prefix) => {
    const own = entries.filter(([key]) => key.startsWith(prefix));
    return Object.fromEntries(own.map(([key, value]) => [key.slice(prefix.length), value]));
  };
  const named = Object.fromEntries(entries.filter(([key]) => key === kind));
  return shallow({ format: Number(version), ...named, document: part("d."), view: part("v.") });
}

/**
 * @param {State} state
 * @returns {string} what a file holds
 */
export function toFile(state) {
  return `${JSON.stringify(state, null, 2)}\n`;
}

/**
 * @param {string} text
 * @returns {unknown} for the engine to check
 */
export function fromFile(text) {
  if (text.length > LONGEST) throw unreadable();
  try {
    return shallow(JSON.parse(text));
  } catch {
    throw unreadable();
  }
}

/** @param {unknown} value */
function encode(value) {
  const text = typeof value === "string" && parsed(value) === undefined ? value : JSON.stringify(value);
  // A comma and brackets may stand in an address; text stays legible.
  return encodeURIComponent(text).replaceAll("%2C", ",");
}

/** @param {string} text */
function decode(text) {
  const value = plain(text);
  const json = parsed(value);
  return json === undefined ? value : json;
}

/** @param {string} text */
function plain(text) {
  try {
    return decodeURIComponent(text);
  } catch {
    throw unreadable();
  }
}

/** @param {string} text */
function parsed(text) {
  try {
    return JSON.parse(text);
  } catch {
    return undefined;
  }
}

/**
 * @param {unknown} value
 * @returns {unknown} the value itself
 */
function shallow(value) {
  const check = (/** @type {unknown} */ part, /** @type {number} */ left) => {
    if (typeof part !== "object" || part === null) return;
    if (left === 0) throw unreadable();
    for (const inner of Object.values(part)) check(inner, left - 1);
  };
  check(value, DEEPEST);
  return value;
}
