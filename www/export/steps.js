// A step of a lesson on paper: its text and formula, then its question with room for an answer.
import { make } from "assur/core/dom.js";
import { marked, withSubscripts } from "assur/core/subscripts.js";

/**
 * @param {Readonly<{ title: string, text: string, formula: string, question: Readonly<{ text: string, options: readonly string[] }> | null }>} step `options`: the answers to
 * choose from; if there are none, the sheet has lines to write on
 * @param {readonly HTMLElement[]} [shown] elements between the formula and the question
 * @returns {HTMLElement}
 */
export function stepOnPaper({ title, text, formula, question }, shown = []) {
  const paragraphs = text.split("\n").map((line) => make("p", {}, marked(line)));
  const written = formula ? [make("p", { class: "formula" }, withSubscripts(formula))] : [];
  const parts = [make("b", { class: "title" }, [title]), ...paragraphs, ...written, ...shown];
  if (question) {
    const choices = question.options.map((option) => make("p", { class: "choice" }, marked(option)));
    const room = choices.length > 0 ? choices : [make("p", { class: "blank" }), make("p", { class: "blank" })];
    parts.push(make("div", { class: "asked" }, [make("p", {}, [make("b", {}, marked(question.text))]), ...room]));
  }
  return make("li", {}, parts);
}
