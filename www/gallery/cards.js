// Cards of the gallery: one for each lesson and each mechanism of the catalogue, in groups.
import { begin } from "assur/lesson/begin.js";
import { readLesson } from "assur/lesson/offer.js";
import { Progress } from "assur/lesson/progress.js";
import { opens } from "assur/lesson/show.js";
import { make } from "assur/core/dom.js";
import { findable, findableMechanism } from "assur/gallery/search.js";
import { LESSONS } from "assur/lessons/index.js";
import { initialState } from "assur/state/state.js";

/**
 * @typedef {import("assur/app/page.js").Page} Page
 * @typedef {import("assur/core/words.js").Words} Words
 * @typedef {{ button: HTMLButtonElement, words: import("assur/gallery/search.js").Findable }} Card card with its search words
 * @typedef {{ key: string, cards: Card[] }} Group group with the key of its heading
 */

/** Groups of the catalogue, in the order of teaching. */
const GROUPS = Object.freeze(["four_bars", "six_bars", "guides", "geared", "higher", "tasks", "schemes"]);

/**
 * @param {Page} page
 * @param {import("assur/gallery/pictures.js").Pictures} pictures
 * @param {readonly Words[]} tables words of all languages: cards are found by their names in each of them
 * @returns {Group[]}
 */
export function groups(page, pictures, tables) {
  const shelves = page.engine.functions.shelves();
  const kinds = [...new Set([...GROUPS, ...shelves.map(({ group }) => group)])];
  const mechanisms = kinds.map((kind) => {
    const key = `gallery.group.${kind}`;
    const among = shelves.filter(({ group }) => group === kind);
    return { key, cards: among.flatMap((shelf) => mechanismCard(shelf, page, pictures, tables)) };
  });
  return [{ key: "gallery.lessons", cards: LESSONS.map((entry) => lessonCard(entry, page, pictures, tables)) }, ...mechanisms];
}

/**
 * @param {import("assur/types/file.js").Shelf} shelf
 * @param {Page} page
 * @param {import("assur/gallery/pictures.js").Pictures} pictures
 * @param {readonly Words[]} tables
 * @returns {Card[]} one card, or none if the catalogue lacks the mechanism
 */
function mechanismCard(shelf, page, pictures, tables) {
  const { id, class: highest } = shelf;
  const { words, store, engine } = page;
  const preset = engine.catalogue.preset(id);
  if (!preset) return [];
  const { kind, document } = preset;
  const key = `gallery.${id}`;
  const line = highest ? words.text("gallery.class", { class: highest }) : words.text(`kind.${kind}`);
  const about = make("small", { class: "about" }, [words.text(`about.${id}`)]);
  const button = card(`gallery-${id}`, pictures.add(async () => initialState(kind, document, {})), words.text(key), line, about);
  if (engine.catalogue.presetOf(store.get())?.id === id) button.setAttribute("aria-current", "true");
  button.addEventListener("click", () => page.choose(kind, document));
  return [{ button, words: findableMechanism(shelf, kind, tables) }];
}

/**
 * @param {import("assur/lesson/offer.js").Entry} entry
 * @param {Page} page
 * @param {import("assur/gallery/pictures.js").Pictures} pictures
 * @param {readonly Words[]} tables
 * @returns {Card}
 */
function lessonCard(entry, page, pictures, tables) {
  const { words, engine } = page;
  const { id } = entry;
  const [title, line] = [`lessons.${id}.title`, `lessons.${id}.line`];
  const done = make("small", { class: "done" });
  const picture = pictures.add(async () => {
    const { lesson: { steps }, presets } = await readLesson(entry);
    const { solved } = new Progress(id, steps);
    if (solved > 0) done.textContent = words.counted("lesson.solved", solved);
    const opened = opens(steps[0].shows[0], presets, engine);
    return opened ? initialState(opened.kind, opened.document, {}) : null;
  });
  const button = card(`gallery-lesson-${id}`, picture, words.text(title), words.text(line), done);
  button.addEventListener("click", () => begin(page, entry));
  const inAll = (/** @type {string} */ key) => tables.map((table) => table.text(key));
  return { button, words: findable({ names: inAll(title), headings: inAll("gallery.lessons"), about: inAll(line) }) };
}

/**
 * @param {string} id
 * @param {HTMLCanvasElement} picture
 * @param {string} title
 * @param {string} line text below the title
 * @param {...HTMLElement} more
 */
function card(id, picture, title, line, ...more) {
  const text = make("span", { class: "text" }, [make("b", {}, [title]), make("small", {}, [line]), ...more]);
  return make("button", { id, class: "tile", type: "button" }, [picture, text]);
}
