// The form beside the page in which a lecturer writes a lesson: text, document and question of each step.
import { sentence } from "assur/controls/problems.js";
import { make, write } from "assur/core/dom.js";
import { attempt } from "assur/core/problem.js";
import { titleOf } from "assur/core/titles.js";
import { Asking } from "assur/lesson/asking.js";
import { FIELDS, valueTyped } from "assur/lesson/fields.js";
import { Results } from "assur/lesson/results.js";
import { shownNow, withMoved, withNewStep, withStep, withoutStep } from "assur/lesson/steps.js";
import { shownBy } from "assur/lesson/tasks.js";
import "assur/lesson/style.js";
import { Varying } from "assur/lesson/varying.js";
import { WRITTEN_HERE, digestOf } from "assur/lesson/verdict.js";
import { openShown } from "assur/lesson/written.js";
import { withExtras, withView } from "assur/state/state.js";
import { keep } from "assur/state/storage.js";

/**
 * @typedef {import("assur/lesson/steps.js").Written} Written
 * @typedef {import("assur/lesson/fields.js").FormField} FormField
 * @typedef {import("assur/state/model.js").AnySnapshot} Snapshot
 * @typedef {HTMLInputElement | HTMLTextAreaElement} Control
 */

export class Writer {
  #page;
  #words;
  /** @type {Map<FormField, { control: Control, row: HTMLElement }>} */
  #fields = new Map();
  #title = make("h2", { id: "write-heading", tabindex: "-1" });
  #walked = make("p", { id: "write-progress", role: "status" });
  #shown = make("p", { id: "write-shown" });
  #said = make("p", { id: "write-said", class: "problem-text", role: "alert" });
  #buttons;
  #asking;
  #varying;
  #results;
  /** Index of the step whose texts are in the form. */
  #at = -1;

  /**
   * @param {HTMLElement} container
   * @param {import("assur/app/page.js").Page} page
   * @param {import("assur/core/words.js").Words} words
   */
  constructor(container, page, words) {
    this.#page = page;
    this.#words = words;
    const button = (/** @type {string} */ id, /** @type {() => void} */ act, /** @type {string} */ sign = "") => {
      const said = words.text(`write.${id}`);
      const made = make("button", { id: `write-${id}`, type: "button", class: sign ? "control icon" : "control", onclick: act }, [sign || said]);
      if (sign) made.ariaLabel = made.title = said;
      return made;
    };
    const steps = (/** @type {(lesson: Written, index: number) => Written} */ change, by = 0) => () => this.#step(change, by);
    this.#buttons = {
      back: button("back", () => this.#go(-1), "‹"),
      on: button("on", () => this.#go(1), "›"),
      add: button("add", steps(withNewStep, 1)),
      remove: button("remove", steps(withoutStep)),
      earlier: button("earlier", steps((lesson, index) => withMoved(lesson, index, -1), -1)),
      later: button("later", steps((lesson, index) => withMoved(lesson, index, 1), 1)),
      show_now: button("show_now", steps((lesson, index) => withStep(lesson, index, { shows: shownNow(page) }))),
      show_open: button("show_open", () => this.#open()),
      show_none: button("show_none", steps((lesson, index) => withStep(lesson, index, { shows: undefined }))),
    };
    const { back, on, add, remove, earlier, later, show_now: now, show_open: open, show_none: none } = this.#buttons;
    const change = (/** @type {(lesson: Written, index: number) => Written} */ act) => this.#change(act);
    this.#asking = new Asking(page, words, change);
    this.#varying = new Varying(page, words, change);
    this.#results = new Results(page, words);
    const of = (/** @type {FormField["of"]} */ what) => FIELDS.filter((field) => field.of === what).map((field) => this.#row(field));
    write(this.#title, words.text("write.heading"));
    const form = make("form", { id: "write", autocomplete: "off" }, [
      ...of("lesson"),
      make("div", { class: "lesson-walk" }, [back, this.#walked, on]),
      make("div", { class: "lesson-buttons" }, [add, earlier, later, remove]),
      ...of("step"),
      make("fieldset", {}, [make("legend", {}, [words.text("write.shows")]), this.#shown, make("div", { class: "lesson-buttons" }, [now, open, none]), this.#varying.element]),
      make("fieldset", {}, [make("legend", {}, [words.text("write.question")]), this.#asking.element, ...of("question"), this.#asking.below]),
    ]);
    form.addEventListener("submit", (event) => event.preventDefault());
    const read = button("read", () => page.lesson.write(false));
    container.replaceChildren(this.#title, form, this.#said, read, this.#results.element);
  }

  focus() {
    this.#title.focus();
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    const { state } = snapshot;
    const { lesson } = state;
    if (!lesson) return;
    const index = indexOf(state);
    if (index !== this.#at) write(this.#said, "");
    const { numbers } = this.#words;
    const step = lesson.steps[index];
    write(this.#walked, this.#words.text("lesson.progress", { number: numbers.exact(index + 1), count: numbers.exact(lesson.steps.length) }));
    const last = lesson.steps.length - 1;
    const { back, on, earlier, later, show_none: none, show_open: open } = this.#buttons;
    // A button that becomes disabled passes the focus to the opposite button.
    const focused = document.activeElement;
    back.disabled = earlier.disabled = index === 0;
    on.disabled = later.disabled = index === last;
    if (focused === back && back.disabled) on.focus();
    if (focused === on && on.disabled) back.focus();
    none.disabled = !step.shows;
    const shown = shownBy(lesson, index);
    open.disabled = !shown;
    const key = !shown ? "write.shown.none" : step.shows ? "write.shown.own" : "write.shown.before";
    const title = shown ? titleOf(shown.shows, this.#page.engine, this.#words) : "";
    write(this.#shown, this.#words.text(key, { title }));
    const sort = this.#asking.render(snapshot, lesson, index);
    for (const [field, { control, row }] of this.#fields) {
      row.hidden = field.of === "question" && (sort === "none" || (field.sorts !== undefined && !field.sorts.includes(sort)));
      const value = field.get(lesson, step) ?? "";
      const text = typeof value === "number" ? numbers.exact(value) : value;
      // The text in the focused field is not overwritten, unless it belongs to another step.
      if ((control !== document.activeElement || index !== this.#at) && control.value !== text) {
        control.value = text;
        control.removeAttribute("aria-invalid");
      }
    }
    this.#varying.render(snapshot, step);
    this.#results.render(lesson);
    this.#at = index;
  }

  /** @param {FormField} field */
  #row(field) {
    const { id, rows = 0, most, numeric } = field;
    const shared = { id: `write-${id}`, class: numeric ? "control number" : "control", ...(most && { maxlength: String(most) }) };
    const control = rows > 0 ? make("textarea", { ...shared, rows: String(rows) }) : make("input", { ...shared, type: "text", spellcheck: String(!numeric), ...(numeric && { inputmode: "decimal" }) });
    control.addEventListener("input", () => this.#type(field, control));
    const row = make("div", { class: "write-row" }, [make("label", { for: `write-${id}` }, [this.#words.text(`write.${id}`)]), control]);
    this.#fields.set(field, { control, row });
    return row;
  }

  /**
   * @param {FormField} field
   * @param {Control} control
   */
  #type(field, control) {
    const typed = valueTyped(field, control.value);
    const taken = typed && this.#change((lesson, index) => field.put(lesson, index, typed.value));
    if (!typed) write(this.#said, this.#words.text("lesson.unread"));
    control.toggleAttribute("aria-invalid", false);
    if (!taken) control.setAttribute("aria-invalid", "true");
  }

  /**
   * @param {(lesson: Written, index: number) => Written} change of the lesson at the open step
   * @returns {boolean} whether the result is a valid lesson; if not, the reasons are shown
   */
  #change(change) {
    const { store, engine } = this.#page;
    const state = store.get();
    if (!state.lesson) return false;
    const next = change(state.lesson, indexOf(state));
    const { problems } = attempt(() => engine.functions.readLesson(next));
    write(this.#said, problems.map((problem) => sentence(problem, this.#words)).join(" "));
    if (problems.length > 0) return false;
    store.update((now) => withExtras(now, { lesson: next }));
    keep(WRITTEN_HERE, digestOf(next, engine));
    return true;
  }

  /**
   * Changes the steps of the lesson, in one undo step.
   * @param {(lesson: Written, index: number) => Written} change
   * @param {number} by number of steps by which the form then moves
   */
  #step(change, by) {
    this.#page.history.step(() => {
      if (this.#change(change)) this.#go(by);
    });
  }

  #open() {
    const state = this.#page.store.get();
    if (state.lesson) openShown(state.lesson, indexOf(state), "", this.#page);
  }

  /** @param {number} by */
  #go(by) {
    this.#page.store.update((state) => {
      const { lesson } = state.view;
      const number = indexOf(state) + 1 + by;
      return lesson && number >= 1 ? withView(state, { lesson: { ...lesson, step: number } }) : state;
    });
  }
}

/**
 * @param {import("assur/state/state.js").State} state
 * @returns {number} index of the open step; of the last step if a link opens one that no longer exists
 */
function indexOf({ view, lesson }) {
  return Math.min(view.lesson?.step ?? 1, lesson?.steps.length ?? 1) - 1;
}
