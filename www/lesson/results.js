// A lecturer's work with a class: worksheets for a list of names, and a table of the results that readers send back.
import { make } from "assur/core/dom.js";
import { download } from "assur/core/download.js";
import { rowsAsCsv } from "assur/export/csv.js";
import { fromCode } from "assur/lesson/code.js";
import { sheets } from "assur/lesson/sheets.js";
import { digestOf, verdictOn } from "assur/lesson/verdict.js";

/**
 * @typedef {import("assur/state/state.js").Written} Written
 * @typedef {{ sign: string, given: string, tries: number, right: boolean }} Answer
 */

/** Largest number of names and of codes: more than a class needs. */
const MAX_ENTRIES = 200;

/** Time for which codes are judged before control returns to the browser, in milliseconds. */
const SLICE = 12;

const SIGNS = Object.freeze({ right: "✓", wrong: "✗", shown: "◇", open: "–" });

export class Results {
  #page;
  #words;
  #codes = make("textarea", { id: "write-codes", class: "control", rows: "4", spellcheck: "false", oninput: () => this.#list() });
  #names = make("textarea", { id: "write-names", class: "control", rows: "4" });
  #table = make("div", { id: "write-table", class: "write-table", role: "status" });
  /** @type {Written | null} */
  #lesson = null;
  /** @type {Map<string, import("assur/lesson/panel.js").Verdict>} verdicts by step, answer and name, kept because the engine may have to build a mechanism for each */
  #verdicts = new Map();
  /** @type {string[][]} the cells of the table as they are saved: for each question the sign, the answer and the number of tries */
  #cells = [];
  #save = make("button", { id: "write-save_results", class: "control add", type: "button", hidden: "", onclick: () => this.#download() });
  /** Number of tables begun so far. */
  #begun = 0;
  element;

  /**
   * @param {import("assur/app/page.js").Page} page
   * @param {import("assur/core/words.js").Words} words
   */
  constructor(page, words) {
    this.#page = page;
    this.#words = words;
    const button = (/** @type {string} */ id, /** @type {() => void} */ act) => {
      return make("button", { id: `write-${id}`, class: "control", type: "button", onclick: act }, [words.text(`write.${id}`)]);
    };
    const print = (/** @type {boolean} */ answers) => () => {
      if (!this.#lesson) return;
      page.sheet = sheets(this.#lesson, lines(this.#names.value), answers, page, words);
      window.print();
      page.sheet = null;
    };
    this.element = make("details", { class: "write-results" }, [
      make("summary", { id: "write-class" }, [words.text("write.class")]),
      make("label", { for: "write-names" }, [words.text("write.names")]), this.#names,
      make("div", { class: "lesson-buttons" }, [button("print_tasks", print(false)), button("print_answers", print(true))]),
      make("label", { for: "write-codes" }, [words.text("write.codes")]), this.#codes,
      this.#table, this.#save,
    ]);
    this.#save.textContent = words.text("write.save_results");
  }

  #download() {
    download(rowsAsCsv(this.#cells, this.#words), `${this.#page.engine.catalogue.fileName(this.#page.store.get())}.csv`);
  }

  /** @param {Written} lesson */
  render(lesson) {
    if (lesson === this.#lesson) return;
    this.#lesson = lesson;
    this.#verdicts.clear();
    this.#list();
  }

  /** Writes the table of all codes row by row. It stops if another table is begun. */
  async #list() {
    const begun = ++this.#begun;
    const lesson = this.#lesson;
    const codes = lines(this.#codes.value);
    if (!lesson || codes.length === 0) {
      this.#table.replaceChildren();
      this.#save.hidden = true;
      return;
    }
    const words = this.#words;
    const asked = lesson.steps.flatMap(({ question }, i) => (question ? [i] : []));
    const heads = [words.text("write.result_name"), ...asked.map((i) => words.numbers.exact(i + 1)), words.text("write.result_right")];
    const parts = (/** @type {number} */ i) => ["", "write.result_answer", "write.result_tries"].map((key) => [words.numbers.exact(i + 1), key && words.text(key)].filter(Boolean).join(": "));
    this.#cells = [[words.text("write.result_name"), ...asked.flatMap(parts), words.text("write.result_right")]];
    this.#save.hidden = false;
    const own = digestOf(lesson, this.#page.engine);
    const rows = make("tbody");
    this.#table.replaceChildren(
      make("table", {}, [make("thead", {}, [make("tr", {}, heads.map((head) => make("th", { scope: "col" }, [head])))]), rows]),
      make("p", { class: "lesson-note" }, [words.text("write.signs", SIGNS)]),
    );
    let due = performance.now() + SLICE;
    for (const [line, code] of codes.entries()) {
      if (performance.now() > due) {
        await new Promise((done) => setTimeout(done));
        if (begun !== this.#begun) return;
        due = performance.now() + SLICE;
      }
      rows.append(this.#row(code, line, lesson, own, asked));
    }
  }

  /**
   * @param {Written} lesson
   * @param {number} step
   * @param {string} given
   * @param {string} name
   * @returns {boolean} whether the answer is right
   */
  #isRight(lesson, step, given, name) {
    const key = JSON.stringify([step, given, name]);
    const verdict = this.#verdicts.get(key) ?? verdictOn(lesson, step, given, name, this.#page.engine);
    this.#verdicts.set(key, verdict);
    return verdict === "right";
  }

  /**
   * @param {string} code
   * @param {number} line index of the line that the code is on, from 0
   * @param {Written} lesson
   * @param {string} own digest of the lesson
   * @param {readonly number[]} asked indices of the steps with a question
   */
  #row(code, line, lesson, own, asked) {
    const words = this.#words;
    const result = fromCode(code);
    const bad = (/** @type {string} */ key, name = "") => {
      const why = words.text(key, { line: words.numbers.exact(line + 1), name });
      this.#cells.push([why]);
      return make("tr", { class: "bad" }, [make("td", { colspan: String(asked.length + 2) }, [why])]);
    };
    if (!result) return bad("write.bad_code");
    if (result.lesson !== own || result.answers.length !== lesson.steps.length) return bad("write.other_lesson", result.name);
    /** @type {Answer[]} */
    const verdicts = asked.map((i) => {
      const { given = "", tries = 0, shown = false } = result.answers[i] ?? {};
      if (shown) return { sign: SIGNS.shown, given: "", tries, right: false };
      if (given === "") return { sign: SIGNS.open, given, tries, right: false };
      const right = this.#isRight(lesson, i, given, result.name);
      return { sign: right ? SIGNS.right : SIGNS.wrong, given: saidOf(lesson, i, given), tries, right };
    });
    const rightOnes = words.numbers.exact(verdicts.filter(({ right }) => right).length);
    const count = words.text("write.of", { right: rightOnes, all: words.numbers.exact(asked.length) });
    this.#cells.push([result.name, ...verdicts.flatMap(({ sign, given, tries }) => [sign, given, tries > 0 ? words.numbers.exact(tries) : ""]), rightOnes]);
    const brief = (/** @type {Answer} */ { sign, given, tries }) => [sign, given, tries > 0 ? `(${words.numbers.exact(tries)})` : ""].filter(Boolean).join(" ");
    return make("tr", {}, [
      make("th", { scope: "row" }, [result.name]),
      ...verdicts.map((answer) => make("td", { "data-right": String(answer.right) }, [brief(answer)])),
      make("td", {}, [count]),
    ]);
  }
}

/**
 * @param {Written} lesson
 * @param {number} index
 * @param {string} given
 * @returns {string} the given answer as the table shows it
 */
function saidOf({ steps }, index, given) {
  const { choice, reach } = steps[index].question ?? {};
  if (reach) return "";
  return choice ? (choice.options[Number(given)] ?? given) : given;
}

/**
 * @param {string} text
 * @returns {string[]} the lines that are not blank, at most {@link MAX_ENTRIES}
 */
function lines(text) {
  return text.split("\n").map((line) => line.trim()).filter((line) => line !== "").slice(0, MAX_ENTRIES);
}
