// Help: pointer and keys, the source papers, notes for teachers, how to cite. Loaded on demand.
import { combinations } from "assur/app/keys.js";
import { byId, make } from "assur/core/dom.js";
import { notesOf, served } from "assur/core/served.js";
import { LESSONS } from "assur/lessons/index.js";

/** Keys of the texts for gestures of the pointer and for their effects. */
const GESTURES = Object.freeze([
  ["gesture.hinge", "gesture.hinge.does"],
  ["gesture.plot", "gesture.plot.does"],
  ["gesture.title", "gesture.title.does"],
  ["gesture.edge", "gesture.edge.does"],
  ["gesture.paper", "gesture.paper.does"],
  ["gesture.zoom", "gesture.zoom.does"],
  ["gesture.fit", "gesture.fit.does"],
]);

/** Keys of the citations of the source papers. */
const PAPERS = Object.freeze(["papers.mixer", "papers.class4", "papers.synthesis", "papers.mobility", "papers.differential"]);

/** @param {import("assur/core/words.js").Words} words */
export function openHelp(words) {
  document.getElementById("help")?.remove();
  const heading = (/** @type {string} */ key) => make("h3", {}, [words.text(key)]);
  const dialog = make("dialog", { id: "help", class: "dialog help", "aria-labelledby": "help-title" }, [
    make("form", { method: "dialog" }, [
      // The title takes the focus: focusing the button at the end would scroll the dialog down.
      make("h2", { id: "help-title", tabindex: "-1", autofocus: "" }, [words.text("help.label")]),
      make("p", {}, [words.text("welcome.text")]),
      heading("help.pointer"),
      table(GESTURES.map(([gesture, effect]) => row([words.text(gesture)], words.text(effect)))),
      heading("help.keys"),
      table(combinations(words).map(({ name, keys }) => row(keys, name))),
      heading("help.papers"),
      make("ul", {}, PAPERS.map((paper) => make("li", {}, [words.text(paper)]))),
      ...(served() ? [make("p", {}, [words.text("help.notes"), " ", ...notes(words)])] : []),
      heading("help.cite"),
      make("p", {}, [citation(words)]),
      make("div", { class: "way-out" }, [make("button", { id: "help-close", class: "control" }, [words.text("dialog.close")])]),
    ]),
  ]);
  byId("app", HTMLElement).append(dialog);
  dialog.addEventListener("close", () => dialog.remove());
  dialog.showModal();
}

/**
 * Makes links to the notes for teachers, in the reader's language, and to the list of misprints, in English.
 * @param {import("assur/core/words.js").Words} words
 */
function notes(words) {
  const link = (/** @type {string} */ href, /** @type {string} */ name, /** @type {string} */ hreflang) => (
    make("a", { href, target: "_blank", rel: "noopener", hreflang }, [words.text(name)])
  );
  const ofLessons = LESSONS.filter(({ notes }) => notes).map(({ id }) => link(notesOf(id, words.lang), `lessons.${id}.title`, words.lang));
  const links = [...ofLessons, link("docs/errata.html", "notes.errata", "en")];
  return links.flatMap((link, i) => (i > 0 ? [", ", link] : [link]));
}

/** @param {import("assur/core/words.js").Words} words */
function citation(words) {
  const version = byId("version", HTMLElement).textContent ?? "";
  return words.text("cite.text", { version, address: served() ? ` ${location.href.split("#")[0]}` : "" });
}

/** @param {readonly HTMLElement[]} rows */
function table(rows) {
  return make("table", {}, [make("tbody", {}, rows)]);
}

/**
 * @param {readonly (Node | string)[]} head
 * @param {string} text
 */
function row(head, text) {
  return make("tr", {}, [make("th", { scope: "row" }, head), make("td", {}, [text])]);
}
