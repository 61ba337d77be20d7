// Read-outs: writing a value, and hiding a value that a lesson asks for.
import { make, write } from "assur/core/dom.js";

/**
 * @param {HTMLElement} output
 * @param {string | readonly (Node | string)[]} said
 * @param {number | undefined} value the number that the text shows
 */
export function writeReadout(output, said, value) {
  output.removeAttribute("data-asked");
  // An output with child elements is always rewritten: equal text may be marked up differently.
  if (typeof said === "string" && output.childElementCount === 0) write(output, said);
  else output.replaceChildren(...(typeof said === "string" ? [said] : said));
  if (value === undefined) output.removeAttribute("data-value");
  else output.dataset.value = String(value);
}

/**
 * @param {HTMLElement} output
 * @param {import("assur/core/words.js").Words} words
 */
export function withhold(output, words) {
  if (output.dataset.asked === words.lang) return;
  output.dataset.asked = words.lang;
  output.removeAttribute("data-value");
  output.replaceChildren("?", make("span", { class: "unseen" }, [` ${words.text("lesson.asked")}`]));
}
