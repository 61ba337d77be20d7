// Pseudorandom numbers that depend only on a given text. They are the same in every browser, and must never change.

/** Constants of the 32-bit hash FNV-1a. */
const BASIS = 0x811c9dc5;
const PRIME = 0x01000193;

/** Significant digits to which a value of a range is rounded. */
const DIGITS = 12;

/**
 * @param {string} text
 * @param {number} [seed]
 * @returns {number} an unsigned integer of 32 bits
 */
export function hash(text, seed = 0) {
  let state = BASIS ^ seed;
  for (const byte of new TextEncoder().encode(text)) state = Math.imul(state ^ byte, PRIME);
  return mixed(state);
}

/**
 * @param {number} state
 * @returns {number} 32 bits, each of which depends on all bits of the state
 */
function mixed(state) {
  let bits = state;
  bits = Math.imul(bits ^ (bits >>> 16), 0x85ebca6b);
  bits = Math.imul(bits ^ (bits >>> 13), 0xc2b2ae35);
  return (bits ^ (bits >>> 16)) >>> 0;
}

/**
 * @param {number} seed
 * @returns {() => number} gives the next number, at least 0 and less than 1
 */
export function generator(seed) {
  let state = seed;
  return () => {
    state = (state + 0x9e3779b9) | 0;
    return mixed(state) / 2 ** 32;
  };
}

/**
 * @param {string} name as typed
 * @returns {string} key of the name, which ignores differences of case, spaces and Unicode form
 */
export function nameKey(name) {
  return name.normalize("NFKC").trim().replace(/\s+/g, " ").toLowerCase();
}

/**
 * @param {string} name of a reader
 * @param {number} step of a lesson
 * @returns {() => number} gives the next random number for this reader and step, at least 0 and less than 1
 */
export function ownNumbers(name, step) {
  return generator(hash(`${step} ${nameKey(name)}`));
}

/**
 * @param {{ readonly from: number, readonly to: number, readonly step: number }} range
 * @param {number} share position of the value in the range, at least 0 and less than 1
 * @returns {number} a value of the range, a whole number of steps from its start
 */
export function valueIn({ from, to, step }, share) {
  // The allowance keeps the last value in the range despite rounding.
  const count = Math.floor((to - from) / step + 1e-9) + 1;
  return Number((from + Math.floor(share * count) * step).toPrecision(DIGITS));
}

/**
 * @param {unknown} value that JSON can express
 * @returns {string} sixteen hexadecimal digits that identify the value
 */
export function digest(value) {
  const text = canonical(value);
  return [1, 2].map((seed) => hash(text, seed).toString(16).padStart(8, "0")).join("");
}

/**
 * @param {unknown} value
 * @returns {string} the value as text, independent of the order of keys
 */
function canonical(value) {
  if (Array.isArray(value)) return `[${value.map(canonical).join()}]`;
  if (typeof value !== "object" || value === null) return JSON.stringify(value) ?? "null";
  const entries = Object.entries(value).filter(([, one]) => one !== undefined).sort(([one], [other]) => (one < other ? -1 : 1));
  return `{${entries.map(([key, one]) => `${JSON.stringify(key)}:${canonical(one)}`).join()}}`;
}
