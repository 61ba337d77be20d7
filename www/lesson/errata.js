// The misprints of the paper that a lesson is about: a dialog with the entries of docs/errata.md. Loaded when it is asked for.
import { byId, make } from "assur/core/dom.js";
import { withSubscripts } from "assur/core/subscripts.js";
import { Words } from "assur/core/words.js";

const COLUMNS = Object.freeze(["equation", "printed", "right"]);

/**
 * Shows the dialog.
 * @param {string} lesson
 * @param {string} lang
 */
export async function openErrata(lesson, lang) {
  const words = await Words.load(lang, ["lang/*", `lessons/${lesson}/errata.*`]);
  document.getElementById("errata-dialog")?.remove();
  const row = (/** @type {string} */ of) => COLUMNS.map((column) => words.text(of + column));
  const rows = [];
  for (let entry = 1; words.has(`${entry}.${COLUMNS[0]}`); entry++) {
    const [equation, printed, right] = row(`${entry}.`).map(withSubscripts);
    rows.push(make("tr", {}, [make("th", { scope: "row" }, equation), make("td", {}, printed), make("td", {}, right)]));
  }
  const dialog = make("dialog", { id: "errata-dialog", class: "dialog", "aria-labelledby": "errata-title" }, [
    make("form", { method: "dialog" }, [
      // It takes the focus: the button at the end would have the dialog scrolled there.
      make("h2", { id: "errata-title", tabindex: "-1", autofocus: "" }, [words.text("title")]),
      make("p", {}, withSubscripts(words.text("text"))),
      make("table", { class: "errata" }, [
        make("thead", {}, [make("tr", {}, row("").map((name) => make("th", { scope: "col" }, [name])))]),
        make("tbody", {}, rows),
      ]),
      make("div", { class: "way-out" }, [make("button", { id: "errata-close", class: "control", "data-t": "dialog.close" })]),
    ]),
  ]);
  words.fill(dialog);
  byId("app", HTMLElement).append(dialog);
  dialog.addEventListener("close", () => dialog.remove());
  dialog.showModal();
}
