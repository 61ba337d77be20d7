// Fields for the answer to a lesson's question: a number, or a choice of options.
import { make } from "assur/core/dom.js";
import { marked } from "assur/core/subscripts.js";

/** @typedef {Readonly<{ elements: readonly HTMLElement[], fill: (given: string) => void }>} Fields `fill`: writes a given answer into the fields */

/** @type {Fields} */
export const NO_FIELDS = Object.freeze({ elements: [], fill: () => {} });

/**
 * @param {import("assur/lesson/panel.js").Question} question
 * @param {(given: string) => void} note called with each answer given by hand
 * @returns {Fields}
 */
export function answerFields({ options, unit, reached }, note) {
  if (reached) return NO_FIELDS;
  if (!options) {
    const input = make("input", {
      id: "lesson-answer", class: "control number", type: "text", inputmode: "decimal", spellcheck: "false",
      "aria-labelledby": "lesson-question", "aria-describedby": "lesson-said",
    });
    input.addEventListener("input", () => note(input.value));
    return { elements: [make("div", { class: "lesson-answer" }, [input, unit])], fill: (given) => (input.value = given) };
  }
  const inputs = options.map(({ value }) => make("input", { id: `lesson-${value}`, type: "radio", name: "lesson-choice", value }));
  for (const input of inputs) input.addEventListener("change", () => note(input.value));
  return {
    elements: options.map(({ text }, k) => make("label", { class: "choice" }, [inputs[k], make("span", {}, marked(text))])),
    fill: (given) => inputs.forEach((input) => (input.checked = input.value === given)),
  };
}
