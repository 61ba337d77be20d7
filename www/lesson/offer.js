// The list of lessons, and the lesson offered with a document. The build writes the list from the folders of www/lessons.
import { fetched } from "assur/core/fetched.js";
import { LESSONS, SCRIPTS } from "assur/lessons/index.js";

/**
 * @typedef {import("assur/state/state.js").State} State
 * @typedef {Readonly<{ id: string, about: readonly string[], presets: boolean, paper: boolean, notes: boolean }>} Entry
 * A lesson. `id`: name of its folder, or `own` for the lecturer's lesson. `about`: origins or kinds of the documents with which it is offered.
 * `presets`, `paper`, `notes`: whether it has presets, a paper, notes for teachers.
 */

/** Id of the lecturer's lesson, which is stored in the state; no folder has this name. */
export const OWN = "own";

/** @type {Entry} */
const WRITTEN = Object.freeze({ id: OWN, about: [], presets: false, paper: false, notes: false });

/**
 * @param {State} state
 * @returns {Entry | undefined} the open lesson, or undefined if the state opens none or one that does not exist
 */
export function opened({ view: { lesson }, lesson: written }) {
  if (lesson?.id === OWN) return written && WRITTEN;
  return LESSONS.find(({ id }) => id === lesson?.id);
}

/**
 * @param {State} state
 * @returns {Entry | undefined} the open lesson, or else the lecturer's, or else the first lesson about the document's origin or kind
 */
export function offered(state) {
  return opened(state) ?? (state.lesson && WRITTEN) ?? first(originOf(state)) ?? first(state.kind);
}

/**
 * @param {string} id of a lesson
 * @returns {Entry | undefined} the next lesson
 */
export function next(id) {
  return LESSONS[LESSONS.findIndex((lesson) => lesson.id === id) + 1];
}

/** @param {string} subject */
function first(subject) {
  return LESSONS.find(({ about }) => about.includes(subject));
}

/**
 * @param {Pick<State, "document">} state
 * @returns {string} id of the catalogue's mechanism from which the document was made; empty if there is none
 */
export function originOf({ document }) {
  return ("origin" in document && document.origin) || "";
}

/**
 * @param {Entry} entry
 * @returns {Promise<{ lesson: { kind: import("assur/state/state.js").Kind, steps: readonly import("assur/lesson/folder.js").Step[] }, presets: import("assur/lesson/folder.js").OwnPresets }>}
 * steps of the lesson and its own presets
 */
export async function readLesson({ id, presets }) {
  const [{ LESSON: lesson }, own] = await Promise.all([SCRIPTS[id](), presets ? fileOf(id, "presets.json") : {}]);
  return { lesson, presets: wholePresets(own) };
}

/**
 * @param {Record<string, { kind?: string, from?: string, document: object }>} own presets as in the lesson's folder. Each is whole, or a list of changes to an earlier preset, `from`
 * @returns {import("assur/lesson/folder.js").OwnPresets}
 */
export function wholePresets(own) {
  /** @type {Record<string, any>} */
  const presets = {};
  for (const [name, { from, ...preset }] of Object.entries(own)) {
    const base = from && presets[from];
    presets[name] = base ? { kind: base.kind, document: { ...base.document, ...preset.document } } : preset;
  }
  return presets;
}

/**
 * @param {Entry} entry
 * @returns {Promise<readonly import("assur/lesson/paper.js").Item[]>} items of the lesson's paper; empty if it has none
 */
export async function readPaper({ id, paper }) {
  return paper ? fileOf(id, "paper.json") : [];
}

/**
 * @param {string} lesson
 * @param {string} file name of a file in the lesson's folder
 */
async function fileOf(lesson, file) {
  const response = await fetched(`assur/lessons/${lesson}/${file}`);
  return response.json();
}
