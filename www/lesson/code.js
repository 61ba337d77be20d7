// The result of a lesson as a line of text: who answered what. Its check sum finds slips of copying; it proves nothing.
import { hash } from "assur/lesson/chance.js";

/** @typedef {Readonly<{ lesson: string, name: string, answers: readonly (string | null)[] }>} Result the digest of the lesson, and by step what was answered */

const VERSION = "assur1";

/** Longer ones are none of ours. */
const LONGEST = 20_000;
const LONGEST_ANSWER = 200;

/**
 * @param {Result} result
 * @returns {string}
 */
export function toCode({ lesson, name, answers }) {
  const bytes = new TextEncoder().encode(JSON.stringify([lesson, name, ...answers]));
  const packed = btoa(String.fromCharCode(...bytes)).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
  return `${VERSION}.${packed}.${checkSum(packed)}`;
}

/** @param {string} packed */
function checkSum(packed) {
  return hash(packed).toString(36);
}

/**
 * @param {string} text
 * @returns {Result | null} null where it is no code, or damaged
 */
export function fromCode(text) {
  const [version, packed, sum, ...more] = text.trim().split(".");
  if (text.length > LONGEST || version !== VERSION || !packed || more.length > 0 || sum !== checkSum(packed)) return null;
  try {
    const bytes = Uint8Array.from(atob(packed.replaceAll("-", "+").replaceAll("_", "/")), (char) => char.charCodeAt(0));
    /** @type {unknown} */
    const value = JSON.parse(new TextDecoder("utf-8", { fatal: true }).decode(bytes));
    if (!Array.isArray(value)) return null;
    const [lesson, name, ...answers] = value;
    const plain = (/** @type {unknown} */ one) => typeof one === "string" && one.length <= LONGEST_ANSWER;
    return plain(lesson) && plain(name) && answers.every((one) => one === null || plain(one)) ? { lesson, name, answers } : null;
  } catch {
    return null;
  }
}
