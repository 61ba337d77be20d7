// Which lessons there are, and which is offered with a document. The list is written by the build from the folders of www/lessons.
import { fetched } from "assur/core/fetched.js";
import { LESSONS, SCRIPTS } from "assur/lessons/index.js";

/**
 * @typedef {import("assur/state/state.js").State} State
 * @typedef {Readonly<{ id: string, about: readonly string[], presets: boolean, paper: boolean, notes: boolean }>} Entry
 * A lesson: the name of its folder, or that of a lesson that a lecturer has written, the origins or the kinds of documents that it is about, whether it has presets of its own, a paper, and notes for teachers.
 */

/** What links call the lesson that is in the state itself: no folder has this name. */
export const OWN = "own";

/** @type {Entry} */
const WRITTEN = Object.freeze({ id: OWN, about: [], presets: false, paper: false, notes: false });

/**
 * @param {State} state
 * @returns {Entry | undefined} the lesson that is open; none where the state opens none, or one that there is not
 */
export function opened({ view: { lesson }, lesson: written }) {
  if (lesson?.id === OWN) return written && WRITTEN;
  return LESSONS.find(({ id }) => id === lesson?.id);
}

/**
 * @param {State} state
 * @returns {Entry | undefined} the lesson that is open, else the one that a lecturer has written, else the first about what the document came from, else about its kind
 */
export function offered(state) {
  return opened(state) ?? (state.lesson && WRITTEN) ?? first(originOf(state)) ?? first(state.kind);
}

/**
 * @param {string} id of a lesson
 * @returns {Entry | undefined} the lesson after it
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
 * @returns {string} the mechanism of the catalogue that its document came from, empty if from none
 */
export function originOf({ document }) {
  return ("origin" in document && document.origin) || "";
}

/**
 * @param {Entry} entry
 * @returns {Promise<{ lesson: { kind: import("assur/state/state.js").Kind, steps: readonly import("assur/lesson/folder.js").Step[] }, presets: import("assur/lesson/folder.js").OwnPresets }>}
 * its steps and the presets of its own
 */
export async function readLesson({ id, presets }) {
  const [{ LESSON: lesson }, own] = await Promise.all([SCRIPTS[id](), presets ? fileOf(id, "presets.json") : {}]);
  return { lesson, presets: wholePresets(own) };
}

/**
 * @param {Record<string, { kind?: string, from?: string, document: object }>} own presets of a lesson as its folder has them: whole, or as changes to an earlier one
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
 * @returns {Promise<readonly import("assur/lesson/paper.js").Item[]>} the items of its paper; none where it has no paper
 */
export async function readPaper({ id, paper }) {
  return paper ? fileOf(id, "paper.json") : [];
}

/**
 * @param {string} lesson
 * @param {string} file of its folder
 */
async function fileOf(lesson, file) {
  const response = await fetched(`assur/lessons/${lesson}/${file}`);
  return response.json();
}
