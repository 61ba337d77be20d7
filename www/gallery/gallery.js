// The gallery: lessons and mechanisms as pictures to choose from. Loaded on demand.
import { byId, make, write } from "assur/core/dom.js";
import { LANGUAGES, Words } from "assur/core/words.js";
import { groups } from "assur/gallery/cards.js";
import { Pictures } from "assur/gallery/pictures.js";
import { found } from "assur/gallery/search.js";
import "assur/gallery/style.js";

/**
 * @typedef {import("assur/gallery/cards.js").Card} Card
 * @typedef {{ section: HTMLElement, cards: readonly Card[] }} Section
 */

/** Media query on which the colours of the pictures depend. */
const DARK = "(prefers-color-scheme: dark)";

/**
 * Shows the dialog in the page's language.
 * @param {import("assur/app/page.js").Page} page
 */
export async function openGallery(page) {
  const { words } = page;
  const tables = await Promise.all(LANGUAGES.map((lang) => Words.load(lang).catch(() => words)));
  document.getElementById("gallery-dialog")?.remove();
  const search = make("input", {
    id: "gallery-search", class: "control", type: "search", autocomplete: "off", spellcheck: "false",
    placeholder: words.text("gallery.search"), "aria-label": words.text("gallery.search"),
  });
  const close = make("button", { id: "gallery-close", class: "control icon", type: "button", "data-t-label": "dialog.close", "data-t-title": "dialog.close" }, ["×"]);
  const none = make("p", { id: "gallery-none", class: "note", role: "status" });
  const shelf = make("div", { class: "shelf" });
  const pictures = new Pictures(page, shelf);
  const sections = groups(page, pictures, tables).map(({ key, cards }) => ({ section: section(key, cards), cards }));
  shelf.append(...sections.map(({ section }) => section), none);
  const head = make("header", {}, [make("h2", { id: "gallery-title", "data-t": "gallery.open" }), search, close]);
  const dialog = make("dialog", { id: "gallery-dialog", class: "dialog gallery", "aria-labelledby": "gallery-title" }, [head, shelf]);
  words.fill(dialog);

  const over = new AbortController();
  const { signal } = over;
  const shown = () => sections.flatMap(({ cards }) => cards).filter(({ button }) => button.offsetParent !== null).map(({ button }) => button);
  close.addEventListener("click", () => dialog.close());
  for (const { button } of sections.flatMap(({ cards }) => cards)) button.addEventListener("click", () => dialog.close());
  search.addEventListener("input", () => {
    const some = filter(sections, search.value);
    write(none, some ? "" : words.text("gallery.none", { query: search.value.trim() }));
    shelf.scrollTop = 0;
  });
  search.addEventListener("keydown", (event) => {
    if (event.key !== "Enter" || search.value.trim() === "") return;
    // Otherwise Enter would also press the button that gets the focus next.
    event.preventDefault();
    // Enter chooses the first remaining card.
    shown()[0]?.click();
  });
  dialog.addEventListener("keydown", (event) => walk(event, search, shown()));
  // A click outside closes the dialog.
  dialog.addEventListener("click", ({ target }) => {
    if (target === dialog) dialog.close();
  });
  // Waits for a frame, so that the theme reads its colours first.
  const repaint = () => requestAnimationFrame(() => pictures.repaint());
  matchMedia(DARK).addEventListener("change", repaint, { signal });
  addEventListener("resize", repaint, { signal });
  dialog.addEventListener("close", () => {
    over.abort();
    pictures.close();
    dialog.remove();
  });

  byId("app", HTMLElement).append(dialog);
  dialog.showModal();
  shown()[0]?.focus();
}

/**
 * @param {string} key of the heading
 * @param {readonly Card[]} cards
 */
function section(key, cards) {
  const id = `${key.replaceAll(".", "-")}-title`;
  return make("section", { "aria-labelledby": id }, [
    make("h3", { id, "data-t": key }),
    make("div", { class: "tiles" }, cards.map(({ button }) => button)),
  ]);
}

/**
 * @param {readonly Section[]} sections
 * @param {string} query
 * @returns {boolean} whether any card is left
 */
function filter(sections, query) {
  for (const { section, cards } of sections) {
    for (const { button, words } of cards) button.hidden = !found(words, query);
    section.hidden = cards.every(({ button }) => button.hidden);
  }
  return sections.some(({ section }) => !section.hidden);
}

/**
 * Moves the focus by arrow keys between visible cards, and from the search field down to the first card.
 * @param {KeyboardEvent} event
 * @param {HTMLElement} search
 * @param {readonly HTMLElement[]} cards visible cards
 */
function walk(event, search, cards) {
  const at = cards.findIndex((card) => card === event.target);
  const next = at < 0 ? (event.target === search && event.key === "ArrowDown" ? cards[0] : undefined) : neighbour(cards, at, event.key);
  if (next === undefined) return;
  event.preventDefault();
  (next ?? search).focus();
}

/**
 * @param {readonly HTMLElement[]} cards
 * @param {number} at
 * @param {string} key
 * @returns {HTMLElement | null | undefined} the next card; null above the first row; undefined if the key leads nowhere
 */
function neighbour(cards, at, key) {
  if (key === "ArrowLeft") return cards[at - 1];
  if (key === "ArrowRight") return cards[at + 1];
  if (key === "Home") return cards[0];
  if (key === "End") return cards[cards.length - 1];
  if (key !== "ArrowUp" && key !== "ArrowDown") return undefined;
  const { left, top } = cards[at].getBoundingClientRect();
  const sense = key === "ArrowDown" ? 1 : -1;
  const places = cards.map((card) => ({ card, box: card.getBoundingClientRect() }));
  const beyond = places.filter(({ box }) => sense * (box.top - top) > 1);
  const row = beyond.length > 0 ? sense * Math.min(...beyond.map(({ box }) => sense * box.top)) : 0;
  const inRow = beyond.filter(({ box }) => Math.abs(box.top - row) < 1);
  const [nearest] = inRow.sort((one, other) => Math.abs(one.box.left - left) - Math.abs(other.box.left - left));
  return nearest?.card ?? (sense < 0 ? null : undefined);
}
