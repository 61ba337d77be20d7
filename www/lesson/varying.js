// Numbers of a lecturer's lesson that differ from reader to reader: their choice and their ranges.
import { fieldName } from "assur/controls/problems.js";
import { make, write } from "assur/core/dom.js";
import { parseNumber } from "assur/core/numbers.js";
import { attempt } from "assur/core/problem.js";
import { Seen } from "assur/core/seen.js";
import { withStep } from "assur/lesson/steps.js";
import { withoutExtras } from "assur/state/state.js";

/**
 * @typedef {import("assur/state/model.js").AnySnapshot} Snapshot
 * @typedef {Readonly<{ field: string, from: number, to: number, step: number }>} Range
 */

const BOUNDS = Object.freeze(/** @type {const} */ (["from", "to", "step"]));

/** Half the initial range of a number, relative to its value; half the range of a whole number is at least 1. */
const SHARE = 0.1;
/** Number of steps in the initial range. */
const STEPS = 20;

export class Varying {
  #page;
  #words;
  #change;
  #list = make("div", { class: "write-rows" });
  #add = make("select", { id: "write-vary", class: "control" });
  #row;
  #built = new Seen();
  element;

  /**
   * @param {import("assur/app/page.js").Page} page
   * @param {import("assur/core/words.js").Words} words
   * @param {import("assur/lesson/asking.js").Change} change
   */
  constructor(page, words, change) {
    this.#page = page;
    this.#words = words;
    this.#change = change;
    this.#add.addEventListener("change", () => this.#begin(this.#add.value));
    this.#row = make("div", { class: "write-row" }, [make("label", { for: "write-vary" }, [words.text("write.vary")]), this.#add]);
    this.element = make("div", { class: "write-rows" }, [this.#list, this.#row]);
  }

  /**
   * @param {Snapshot} snapshot
   * @param {import("assur/lesson/steps.js").Step} step
   */
  render({ state }, { shows }) {
    // Numbers can be added only while the page shows the step's own document.
    const own = shows && state.document === shows.document;
    const ranges = shows?.vary ?? [];
    this.#row.hidden = !own;
    const typing = this.#list.contains(document.activeElement) && ranges.length === this.#list.childElementCount;
    if (typing || this.#built.same(ranges, own, state.document, this.#words)) return;
    this.#list.replaceChildren(...ranges.map((range, i) => this.#entry(range, i, ranges, shows?.document)));
    const free = own ? this.#numbers().filter(({ field }) => !ranges.some((range) => range.field === field)) : [];
    const options = free.map(({ field }) => make("option", { value: field }, [fieldName(field, this.#words, shows?.document)]));
    this.#add.replaceChildren(make("option", { value: "" }, [this.#words.text("write.vary_none")]), ...options);
  }

  /**
   * @param {Range} range
   * @param {number} at
   * @param {readonly Range[]} ranges
   * @param {import("assur/state/state.js").State["document"] | undefined} shown
   */
  #entry(range, at, ranges, shown) {
    const words = this.#words;
    const said = fieldName(range.field, words, shown);
    const inputs = BOUNDS.map((bound) => {
      const input = make("input", { id: `write-vary-${at}-${bound}`, class: "control number", type: "text", inputmode: "decimal", "aria-label": `${said}: ${words.text(`write.vary.${bound}`)}` });
      input.value = words.numbers.exact(range[bound]);
      input.addEventListener("input", () => {
        const value = parseNumber(input.value);
        const now = this.#page.store.get();
        const taken = value !== null && this.#change((lesson, index) => {
          const shows = lesson.steps[index].shows;
          if (!shows) return lesson;
          return withStep(lesson, index, { shows: { ...shows, vary: (shows.vary ?? []).map((one, i) => (i === at ? { ...one, [bound]: value } : one)) } });
        });
        input.toggleAttribute("aria-invalid", false);
        if (!taken && now === this.#page.store.get()) input.setAttribute("aria-invalid", "true");
      });
      return make("label", { class: "write-bound" }, [make("span", {}, [words.text(`write.vary.${bound}`)]), input]);
    });
    const remove = make("button", { id: `write-vary-${at}-remove`, class: "control icon", type: "button" }, ["×"]);
    remove.ariaLabel = remove.title = words.text("write.vary_remove", { name: said });
    remove.addEventListener("click", () => {
      this.#put(ranges.filter((_, i) => i !== at));
      this.#add.focus();
    });
    const name = make("span");
    write(name, said);
    return make("div", { class: "write-varied" }, [name, ...inputs, remove]);
  }

  /** @returns {readonly import("assur/types/file.js").NumberField[]} numbers of the page's document that a lesson may vary */
  #numbers() {
    const { engine, store } = this.#page;
    return attempt(() => engine.functions.numbersOf(withoutExtras(store.get()))).value ?? [];
  }

  /** @param {string} field */
  #begin(field) {
    const found = this.#numbers().find((one) => one.field === field);
    if (!found) return;
    const { value: now, whole } = found;
    const size = Math.max(Math.abs(now), 0.1);
    const step = whole ? 1 : 10 ** Math.floor(Math.log10((2 * SHARE * size) / STEPS));
    const off = whole ? Math.max(SHARE * size, 1) : SHARE * size;
    const rounded = (/** @type {number} */ value) => Number((Math.round(value / step) * step).toPrecision(12));
    const range = { field, from: rounded(now - off), to: rounded(now + off), step: Number(step.toPrecision(12)) };
    const { lesson } = this.#page.store.get();
    this.#page.history.step(() => this.#put(null, range));
    if (lesson) this.#add.focus();
  }

  /**
   * @param {readonly Range[] | null} ranges ranges to set; null for the step's current ones
   * @param {Range[]} more ranges to append
   */
  #put(ranges, ...more) {
    this.#change((lesson, index) => {
      const { shows } = lesson.steps[index];
      if (!shows) return lesson;
      return withStep(lesson, index, { shows: { ...shows, vary: [...(ranges ?? shows.vary ?? []), ...more] } });
    });
  }
}
