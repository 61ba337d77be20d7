// The state as an address and as a file. Only their outer form is read here; the engine checks the content.
import { Refusal } from "assur/core/problem.js";
import { contains } from "assur/state/state.js";

/** @typedef {import("assur/state/state.js").State} State */

/**
 * Version of the address: `#2&kind=mixer&d.l1=0.37&…&v.phi_deg=62`. A value that is not JSON is text. Older versions, each
 * with its own key for the kind, are still read; tests/links.txt contains links of each version. An unchanged mechanism of
 * the catalogue is written as its name, followed by the fields of the view that are not as usual: `#jansen&v.speed=2`.
 */
const VERSION = "2";
const KINDS = Object.freeze(/** @type {Record<string, string | undefined>} */ ({ 1: "lesson", [VERSION]: "kind" }));
/**
 * Parts of a state, other than kind, document and view, that an address can hold. In version 1, the key `lesson` held
 * the kind instead.
 */
const EXTRAS = Object.freeze(/** @type {const} */ (["lesson", "compared"]));
const PREFIXES = Object.freeze({ document: "d.", view: "v." });

/**
 * Limits of a state. `MAX_LENGTH`: number of characters, not counting an image, whose length the engine checks.
 * `MAX_DEPTH`: depth of nesting.
 */
export const MAX_LENGTH = 400_000;
const MAX_DEPTH = 12;

/** Fields of the view that hold the input. A short address omits them if the mechanism is in motion. */
const PLACES = Object.freeze(["phi_deg", "s", "t"]);

/** @returns {Refusal} refusal of an address that contains no state */
function unreadable() {
  return new Refusal([{ code: "unreadable_link" }]);
}

/**
 * @param {State} state
 * @param {{ id: string, usual: State["view"] } | null} preset `id`: name in the catalogue; `usual`: view whose fields are left out
 * @returns {string} the part of an address after #
 */
export function toAddress(state, preset) {
  const { kind, document, view } = state;
  const extras = EXTRAS.filter((name) => state[name] !== undefined).map((name) => `${name}=${encode(state[name])}`);
  if (!preset) return [VERSION, `kind=${encode(kind)}`, ...pairs("document", document), ...pairs("view", view), ...extras].join("&");
  const usual = /** @type {Record<string, unknown>} */ (preset.usual);
  const unusual = Object.entries(view).filter(([key, value]) => !contains(usual, { [key]: value }) && !(view.playing && PLACES.includes(key)));
  return [encodeURIComponent(preset.id), ...pairs("view", Object.fromEntries(unusual)), ...extras].join("&");
}

/**
 * @param {"document" | "view"} part
 * @param {object} values
 */
function pairs(part, values) {
  const entries = Object.entries(values).filter(([, value]) => value !== null && value !== undefined);
  return entries.map(([key, value]) => `${PREFIXES[part]}${encodeURIComponent(key)}=${encode(value)}`);
}

/**
 * @param {string} hash the part of an address after #
 * @param {(id: string) => { kind: string, document: unknown, view: object } | undefined} preset gives a mechanism of the catalogue and its view
 * @returns {unknown} the state, which the engine has yet to check
 */
export function fromAddress(hash, preset) {
  if (hash.length > MAX_LENGTH) throw unreadable();
  const [version, ...pairs] = hash.split("&");
  const kind = Object.hasOwn(KINDS, version) ? KINDS[version] : undefined;
  const named = kind === undefined ? preset(plain(version)) : undefined;
  if (kind === undefined && !named) throw unreadable();
  const entries = pairs.map((pair) => {
    const at = pair.indexOf("=");
    return at < 0 ? [plain(pair), null] : [plain(pair.slice(0, at)), decode(pair.slice(at + 1))];
  });
  // `Object.fromEntries` makes every key an own property, even `__proto__`.
  const part = (/** @type {string} */ prefix) => {
    const own = entries.filter(([key]) => key.startsWith(prefix));
    return Object.fromEntries(own.map(([key, value]) => [key.slice(prefix.length), value]));
  };
  const own = (/** @type {readonly (string | undefined)[]} */ names) => Object.fromEntries(entries.filter(([key]) => names.includes(key)));
  const [document, view] = [part(PREFIXES.document), part(PREFIXES.view)];
  if (named) {
    // An address that names a preset may not have fields of a document: they would be ignored silently.
    if (Object.keys(document).length > 0) throw unreadable();
    return shallow({ format: Number(VERSION), ...named, view: { ...named.view, ...view }, ...own(EXTRAS) }, unreadable());
  }
  return shallow({ format: Number(version), ...own(EXTRAS), ...own([kind]), document, view }, unreadable());
}

/**
 * @param {State} state
 * @returns {string} content of a file
 */
export function toFile(state) {
  return `${JSON.stringify(state, null, 2)}\n`;
}

/**
 * @param {string} text
 * @returns {unknown} the state, which the engine has yet to check
 */
export function fromFile(text) {
  const value = parsed(text);
  if (value === undefined) throw new Refusal([{ code: "not_json" }]);
  const other = new Refusal([{ code: "no_mechanism" }]);
  if (value?.format === undefined) throw other;
  const image = value.picture?.image;
  const size = text.length - (typeof image === "string" ? image.length : 0);
  if (size > MAX_LENGTH) throw new Refusal([{ code: "too_many_characters", size, max: MAX_LENGTH }]);
  return shallow(value, other);
}

/** @param {unknown} value */
function encode(value) {
  const text = typeof value === "string" && parsed(value) === undefined ? value : JSON.stringify(value);
  // Commas are allowed in an address, and keep the text legible.
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
 * Checks the depth of nesting.
 * @param {unknown} value
 * @param {Refusal} deep thrown if the value is nested too deeply
 * @returns {unknown} the value itself
 */
function shallow(value, deep) {
  const check = (/** @type {unknown} */ part, /** @type {number} */ left) => {
    if (typeof part !== "object" || part === null) return;
    if (left === 0) throw deep;
    for (const inner of Object.values(part)) check(inner, left - 1);
  };
  check(value, MAX_DEPTH);
  return value;
}
