// The result of a lesson as a line of text: name, answers, and a check sum that finds copying errors, not forgery.
import { hash } from "assur/lesson/chance.js";

/**
 * @typedef {Readonly<{ given: string, tries: number, shown: boolean }>} Answer `given`: the last answer. `tries`: number of judged answers. `shown`:
 * whether the page has shown the right answer
 * @typedef {Readonly<{ lesson: string, name: string, answers: readonly (Answer | null)[] }>} Result `lesson`: digest of the lesson. `name`: name
 * of the reader. `answers`: one for each step, null for a step without a question
 */

/** Versions of the code: the present one, and an older one without numbers of tries. */
const [VERSION, WITHOUT_TRIES] = ["assur2", "assur1"];

/** Limits in characters. `MAX_CODE`: length of a code. `MAX_ANSWER`: length of an answer, a name or a digest in a code. */
const MAX_CODE = 20_000;
const MAX_ANSWER = 200;

/**
 * @param {Result} result
 * @returns {string}
 */
export function toCode({ lesson, name, answers }) {
  const plain = answers.map((answer) => answer && [answer.given, answer.tries, answer.shown ? 1 : 0]);
  const bytes = new TextEncoder().encode(JSON.stringify([lesson, name, ...plain]));
  const packed = btoa(String.fromCharCode(...bytes)).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
  return `${VERSION}.${packed}.${checkSum(packed)}`;
}

/** @param {string} packed */
function checkSum(packed) {
  return hash(packed).toString(36);
}

/**
 * @param {string} text
 * @returns {Result | null} null if the text is not a code or is damaged
 */
export function fromCode(text) {
  const [version, packed, sum, ...more] = text.trim().split(".");
  if (text.length > MAX_CODE || (version !== VERSION && version !== WITHOUT_TRIES) || !packed || more.length > 0 || sum !== checkSum(packed)) return null;
  try {
    const bytes = Uint8Array.from(atob(packed.replaceAll("-", "+").replaceAll("_", "/")), (char) => char.charCodeAt(0));
    /** @type {unknown} */
    const value = JSON.parse(new TextDecoder("utf-8", { fatal: true }).decode(bytes));
    if (!Array.isArray(value)) return null;
    const [lesson, name, ...rest] = value;
    const answers = rest.map((one) => (one === null ? null : answerIn(version === VERSION ? one : [one, 0, 0])));
    return isShort(lesson) && isShort(name) && !answers.includes(undefined) ? { lesson, name, answers: /** @type {(Answer | null)[]} */ (answers) } : null;
  } catch {
    return null;
  }
}

/**
 * @param {unknown} value
 * @returns {value is string}
 */
function isShort(value) {
  return typeof value === "string" && value.length <= MAX_ANSWER;
}

/**
 * @param {unknown} value
 * @returns {Answer | undefined} undefined if the value is not an answer
 */
function answerIn(value) {
  if (!Array.isArray(value) || value.length !== 3) return undefined;
  const [given, tries, shown] = value;
  if (!isShort(given) || !Number.isSafeInteger(tries) || tries < 0 || (shown !== 0 && shown !== 1)) return undefined;
  return { given, tries, shown: shown === 1 };
}
