// Controls for a lecturer's question: its kind, the quantity asked for, the right option.
import { make, write } from "assur/core/dom.js";
import { html, render } from "assur/core/html.js";
import { Seen } from "assur/core/seen.js";
import { measured } from "assur/core/units.js";
import { withQuantity, withRight, withShown } from "assur/lesson/fields.js";
import { quantityName, secrets, unitOf } from "assur/lesson/quantity.js";
import { QUESTIONS, sortOf, withStep } from "assur/lesson/steps.js";
import { answerOf, quantities } from "assur/lesson/tasks.js";

/**
 * @typedef {import("assur/lesson/steps.js").Written} Written
 * @typedef {import("assur/state/model.js").AnySnapshot} Snapshot
 * @typedef {(change: (lesson: Written, index: number) => Written) => boolean} Change
 */

export class Asking {
  #page;
  #words;
  #sort = make("select", { id: "write-sort", class: "control" });
  #quantity = make("select", { id: "write-quantity", class: "control" });
  #hidden = make("input", { id: "write-hidden", type: "checkbox" });
  #right = make("select", { id: "write-right", class: "control" });
  #rows;
  #now = make("p", { id: "write-now", class: "lesson-note" });
  #listed = new Seen();
  #told = new Seen();

  /**
   * @param {import("assur/app/page.js").Page} page
   * @param {import("assur/core/words.js").Words} words
   * @param {Change} change
   */
  constructor(page, words, change) {
    this.#page = page;
    this.#words = words;
    this.#sort.append(...Object.keys(QUESTIONS).map((sort) => make("option", { value: sort }, [words.text(`write.sort.${sort}`)])));
    this.#sort.addEventListener("change", () => change((lesson, index) => {
      const { question } = lesson.steps[index];
      const quantity = question?.number?.quantity ?? question?.reach?.quantity ?? (this.#quantity.options[0]?.value || "input");
      return withStep(lesson, index, { question: QUESTIONS[this.#sort.value](question?.text ?? "", question?.hint, quantity) });
    }));
    this.#quantity.addEventListener("change", () => change((lesson, index) => withQuantity(lesson, index, this.#quantity.value)));
    this.#hidden.addEventListener("change", () => change((lesson, index) => withShown(lesson, index, !this.#hidden.checked)));
    this.#right.addEventListener("change", () => change((lesson, index) => withRight(lesson, index, Number(this.#right.value))));
    const row = (/** @type {string} */ id, /** @type {HTMLElement} */ control) =>
      make("div", { class: "write-row" }, [make("label", { for: `write-${id}` }, [words.text(`write.${id}`)]), control]);
    const hidden = make("label", { class: "check" }, [this.#hidden, " ", make("span", {}, [words.text("write.hidden")])]);
    this.#rows = { quantity: row("quantity", this.#quantity), hidden, right: row("right", this.#right) };
    this.element = make("div", { class: "write-rows" }, [row("sort", this.#sort), this.#rows.quantity, hidden]);
    this.below = make("div", { class: "write-rows" }, [this.#rows.right, this.#now]);
  }

  /**
   * @param {Snapshot} snapshot
   * @param {Written} lesson
   * @param {number} index
   * @returns {string} the kind of the question
   */
  render(snapshot, lesson, index) {
    const { question } = lesson.steps[index];
    const sort = sortOf(question);
    this.#sort.value = sort;
    this.#rows.quantity.hidden = sort !== "number" && sort !== "reach";
    this.#rows.right.hidden = sort !== "choice";
    const wanted = question?.number?.quantity ?? question?.reach?.quantity ?? "";
    this.#rows.hidden.hidden = sort !== "number" || secrets(question?.number).length === 0;
    this.#hidden.checked = !question?.number?.shown;
    this.#list(snapshot, wanted);
    this.#options(question?.choice?.options ?? [], question?.choice?.answer ?? 0);
    this.#tell(lesson, index, sort);
    return sort;
  }

  /**
   * @param {Snapshot} snapshot
   * @param {string} wanted quantity to list even if the mechanism lacks it
   */
  #list(snapshot, wanted) {
    const { summary, readouts, state } = snapshot;
    if (!this.#listed.same(summary, readouts !== null, state.view.axes, wanted)) {
      const names = quantities(snapshot);
      const all = wanted === "" || names.includes(wanted) ? names : [wanted, ...names];
      render(all.map((name) => html`<option value=${name}>${quantityName(name, snapshot, this.#words)}</option>`), this.#quantity);
    }
    if (wanted !== "") this.#quantity.value = wanted;
  }

  /**
   * @param {readonly string[]} options
   * @param {number} answer
   */
  #options(options, answer) {
    render(options.map((option, i) => html`<option value=${i}>${option}</option>`), this.#right);
    this.#right.value = String(answer);
  }

  /**
   * Writes the engine's answer to a question for a number, or a note that the engine has no answer.
   * @param {Written} lesson
   * @param {number} index
   * @param {string} sort
   */
  #tell(lesson, index, sort) {
    if (this.#told.same(lesson, index)) return;
    this.#now.hidden = sort !== "number";
    if (sort !== "number") return;
    const { numbers } = this.#words;
    const value = answerOf(lesson, index, "", this.#page.engine);
    const unit = unitOf(lesson.steps[index].question?.number);
    write(this.#now, value === null ? this.#words.text("write.no_answer") : this.#words.text("write.answer_now", { value: measured(numbers.upTo(value, 4), unit) }));
  }
}
