// The equations of equilibrium of a free body as an exercise: the student chooses the sense of each unknown and the point of
// moments, and fills in the signs and arms. The engine gives the addends in these choices and judges the answers.
import { degrees } from "assur/core/angles.js";
import { make, write } from "assur/core/dom.js";
import { html, render } from "assur/core/html.js";
import { parseNumber } from "assur/core/numbers.js";
import { numberField } from "assur/controls/number-box.js";
import { equilibriumOf, SUMS } from "assur/force-plan/equations.js";

/**
 * @typedef {import("assur/types/web.js").EquilibriumHere} Equilibrium
 * @typedef {import("assur/types/web.js").AddendHere} Addend
 * @typedef {import("assur/types/web.js").StudentSheet} Answers
 * @typedef {import("assur/force-plan/equations.js").Units} Units
 * @typedef {{ sense: HTMLSelectElement | null, signs: HTMLSelectElement[], arm: HTMLInputElement }} Row fields of an addend
 * @typedef {Readonly<{ input: number, link: number, name: string, units: Units }>} Asked the free body: its input, and the link with its name
 */

/** Choices for a sign, with their values; the first stands for no answer. */
const CHOICES = Object.freeze(/** @type {Map<string, number | null>} */ (new Map([["", null], ["+", 1], ["−", -1], ["0", 0]])));
/** Arrows of the directions along the axes, every quarter turn. */
const AXES = Object.freeze(["→", "↑", "←", "↓"]);

export class Exercise {
  #page;
  #about = make("select", { id: "force-exercise-about", class: "control", "aria-labelledby": "force-exercise-point", onchange: () => this.#change() });
  #rows = make("tbody");
  #said = make("p", { id: "force-exercise-said", role: "status" });
  #found = make("div", { id: "force-exercise-found" });
  /** Link and forces for which the fields are made. */
  #made = "";
  /** @type {Row[]} */
  #fields = [];
  /** @type {Set<number>} numbers of the unknowns whose senses are reversed; they hold for both links of a pair */
  #reversed = new Set();
  /** @type {Asked | null} */
  #asked = null;
  /** @type {Equilibrium | null} */
  #here = null;

  /** @param {Pick<import("assur/app/page.js").Page, "words" | "engine" | "redraw">} page */
  constructor(page) {
    this.#page = page;
    const point = make("div", { class: "bar" }, [make("span", { id: "force-exercise-point", "data-t": "force_plan.exercise.about" }), this.#about]);
    const heads = [make("th", { "data-t": "force_plan.force" }), make("th", { "data-t": "force_plan.exercise.sense" }), ...[...SUMS, "h"].map((sum) => make("th", {}, [sum]))];
    const table = make("div", { class: "amounts" }, [make("table", {}, [make("thead", {}, [make("tr", {}, heads)]), this.#rows])]);
    const check = make("button", { type: "button", class: "control", id: "force-exercise-check", "data-t": "force_plan.exercise.check", onclick: () => this.#judge() });
    this.element = make("details", { id: "force-exercise" }, [
      make("summary", { "data-t": "force_plan.exercise" }),
      make("p", { class: "note", "data-t": "force_plan.exercise.note" }), point, table, check, this.#said, this.#found,
    ]);
  }

  /** Whether the exercise is open. The numbers beside it must then be hidden, because they contain its answers. */
  get open() {
    return this.element.open;
  }

  /**
   * @param {Asked} asked
   * @returns {import("assur/types/web.js").ForcePictureHere | null} the link with the unknowns in the chosen senses
   */
  show(asked) {
    const moved = this.#asked?.input !== asked.input;
    this.#asked = asked;
    const here = this.#ask([]);
    this.#here = here;
    if (!here) return null;
    const { lang } = this.#page.words;
    const made = JSON.stringify([asked.name, here.points, here.addends.map(({ symbol }) => symbol), lang]);
    if (made !== this.#made) {
      this.#made = made;
      this.#build(here);
    }
    here.addends.forEach((addend, row) => this.#written(addend, this.#fields[row]));
    if (moved) this.#clear();
    return here.picture;
  }

  /**
   * @param {Answers["answers"]} answers
   * @returns {Equilibrium | null}
   */
  #ask(answers) {
    if (!this.#asked) return null;
    const { input, link } = this.#asked;
    return this.#page.engine.simulator.equilibrium(input, { link, about: Math.max(this.#about.selectedIndex, 0), reversed: [...this.#reversed], answers });
  }

  /** @param {Equilibrium} here */
  #build({ points, addends }) {
    const chosen = this.#about.value;
    this.#about.replaceChildren(...points.map((point) => make("option", {}, [point])));
    this.#about.selectedIndex = Math.max(points.indexOf(chosen), 0);
    const { words } = this.#page;
    const choice = (/** @type {string} */ label, /** @type {readonly string[]} */ values) => {
      const field = make("select", { class: "control", "aria-label": label });
      field.append(...values.map((value) => make("option", { value }, [value])));
      return field;
    };
    this.#fields = addends.map(({ symbol, unknown, direction }) => {
      const signs = SUMS.map((sum, k) => {
        const field = choice(`${symbol}, ${sum}`, [...CHOICES.keys()]);
        field.addEventListener("change", () => this.#clear());
        field.disabled = direction === null && k < 2;
        return field;
      });
      const arm = numberField({ "aria-label": `${symbol}, h` });
      arm.addEventListener("input", () => this.#clear());
      arm.disabled = direction === null;
      if (unknown === null) return { sense: null, signs, arm };
      const sense = choice(`${symbol}, ${words.text("force_plan.exercise.sense")}`, ["", "reversed"]);
      sense.addEventListener("change", () => {
        if (sense.value) this.#reversed.add(unknown);
        else this.#reversed.delete(unknown);
        this.#change();
      });
      return { sense, signs, arm };
    });
    this.#rows.replaceChildren(...this.#fields.map(({ sense, signs, arm }, row) => make("tr", {}, [
      make("td", {}, [addends[row].symbol]), make("td", {}, sense ? [sense] : []), ...[...signs, arm].map((field) => make("td", {}, [field])),
    ])));
    this.#clear();
  }

  /**
   * Writes the sense of an addend, which follows the pose.
   * @param {Addend} addend
   * @param {Row} row
   */
  #written(addend, { sense }) {
    if (!sense || addend.unknown === null) return;
    const reversed = this.#reversed.has(addend.unknown);
    const text = (/** @type {boolean} */ opposite) => senseText(addend, opposite, this.#page.words);
    sense.value = reversed ? "reversed" : "";
    const [first, second] = sense.options;
    write(first, text(reversed));
    write(second, text(!reversed));
  }

  /** Shows the picture for the new choices, and clears the judgement of the earlier answers. */
  #change() {
    this.#clear();
    this.#page.redraw();
  }

  #clear() {
    write(this.#said, "");
    render(html``, this.#found);
    for (const { signs, arm } of this.#fields) for (const field of [...signs, arm]) field.removeAttribute("aria-invalid");
  }

  #judge() {
    const given = this.#fields.map(({ signs, arm }) => [...signs.map(({ value }) => CHOICES.get(value) ?? null), parseNumber(arm.value)]);
    const judged = this.#ask(/** @type {Answers["answers"]} */ (given));
    if (!judged || !this.#asked) return;
    const { words } = this.#page;
    let [wrong, missing] = [0, 0];
    this.#fields.forEach(({ signs, arm }, row) => {
      const verdicts = [...judged.addends[row].signs, arm.value.trim() !== "" && parseNumber(arm.value) === null ? false : judged.addends[row].arm];
      [...signs, arm].forEach((field, k) => {
        if (field.disabled) return;
        const isWrong = verdicts[k] === false;
        wrong += isWrong ? 1 : 0;
        missing += k < SUMS.length && verdicts[k] === null ? 1 : 0;
        if (isWrong) field.setAttribute("aria-invalid", "true");
        else field.removeAttribute("aria-invalid");
      });
    });
    const right = wrong + missing === 0;
    const exact = (/** @type {number} */ count) => words.numbers.exact(count);
    write(this.#said, right ? words.text("force_plan.exercise.right") : words.text("force_plan.exercise.wrong", { wrong: exact(wrong), missing: exact(missing) }));
    render(right ? equilibriumOf(judged.addends, this.#about.value, this.#asked.units, words) : html``, this.#found);
  }

  /** @returns {HTMLElement} the printed sheet in the chosen senses: the answers filled in so far, and blanks */
  onPaper() {
    const { words } = this.#page;
    const addends = this.#here?.addends ?? [];
    const row = (/** @type {Row} */ { signs, arm }, /** @type {number} */ k) => make("tr", {}, [
      make("td", {}, [addends[k].symbol]), make("td", {}, [addends[k].unknown === null ? "" : senseText(addends[k], false, words)]),
      ...[...signs, arm].map(({ value }) => make("td", { class: "cell" }, [value])),
    ]);
    const heads = [words.text("force_plan.force"), words.text("force_plan.exercise.sense"), ...SUMS, "h"];
    const table = make("table", {}, [make("thead", {}, [make("tr", {}, heads.map((head) => make("th", {}, [head])))]), make("tbody", {}, this.#fields.map(row))]);
    const found = this.#found.childElementCount > 0 ? [this.#found.cloneNode(true)] : SUMS.map((sum) => make("p", { class: "blank" }, [`${sum} =`]));
    const about = `${words.text("force_plan.exercise.about")} ${this.#about.value}`;
    return make("div", {}, [make("p", {}, [words.text("force_plan.exercise.note")]), make("p", {}, [about]), table, ...found]);
  }
}

/**
 * @param {Addend} addend
 * @param {boolean} opposite
 * @param {import("assur/core/words.js").Words} words
 * @returns {string} arrow of the sense of an addend or, for an inclined force, its direction
 */
function senseText({ direction, factors: [, , turn] }, opposite, words) {
  if (direction === null) return (turn > 0) === opposite ? "↻" : "↺";
  const angle = (degrees(direction) + (opposite ? 540 : 360)) % 360;
  const quarter = Math.round(angle / 90);
  return Math.abs(angle - 90 * quarter) < 1e-6 ? AXES[quarter % 4] : `∠\u00a0${words.numbers.fixed(angle, 1)}°`;
}
