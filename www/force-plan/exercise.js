// The equations of equilibrium of a free body as an exercise: a sign for each force in each equation, moments about a point
// of the student's choice. The engine gives the right signs; here they are compared.
import { make, write } from "assur/core/dom.js";

/** @typedef {import("assur/types/web.js").FreeBodyHere} FreeBody */

/** What can be chosen for a sign, with its value; the first is no answer. */
const CHOICES = Object.freeze(/** @type {Map<string, number | null>} */ (new Map([["", null], ["+", 1], ["−", -1], ["0", 0]])));
/** Equations, as they are written. The moments of the third are about the chosen point. */
const SUMS = Object.freeze(["ΣX", "ΣY", "ΣM"]);

export class Exercise {
  #words;
  #about = make("select", { id: "force-exercise-about", class: "control", "aria-labelledby": "force-exercise-point", onchange: () => this.#clear() });
  #rows = make("tbody");
  #said = make("p", { id: "force-exercise-said", role: "status" });
  /** Link and forces for which the fields are made. */
  #made = "";
  /** @type {HTMLSelectElement[][]} signs of each force in the equations */
  #fields = [];
  /** @type {FreeBody | null} */
  #body = null;

  /** @param {() => import("assur/core/words.js").Words} words words of the page now */
  constructor(words) {
    this.#words = words;
    const point = make("div", { class: "bar" }, [make("span", { id: "force-exercise-point", "data-t": "force_plan.exercise.about" }), this.#about]);
    const head = make("tr", {}, [make("th", { "data-t": "force_plan.force" }), ...SUMS.map((sum) => make("th", {}, [sum]))]);
    const table = make("div", { class: "amounts" }, [make("table", {}, [make("thead", {}, [head]), this.#rows])]);
    const check = make("button", { type: "button", class: "control", id: "force-exercise-check", "data-t": "force_plan.exercise.check", onclick: () => this.#judge() });
    this.element = make("details", { id: "force-exercise" }, [
      make("summary", { "data-t": "force_plan.exercise" }),
      make("p", { class: "note", "data-t": "force_plan.exercise.note" }), point, table, check, this.#said,
    ]);
  }

  /** Whether the exercise is open, so that the numbers beside it would give it away. */
  get open() {
    return this.element.open;
  }

  /**
   * @param {FreeBody} body
   * @param {string} link
   */
  show(body, link) {
    this.#body = body;
    const made = JSON.stringify([link, body.points, body.acting.map(({ symbol }) => symbol), this.#words().lang]);
    if (made === this.#made) return;
    this.#made = made;
    this.#about.replaceChildren(...body.points.map((point) => make("option", {}, [point])));
    this.#fields = body.acting.map(({ symbol, couple, signs }) => SUMS.map((sum, k) => {
      const field = make("select", { class: "control", "aria-label": `${symbol}, ${sum}`, onchange: () => this.#clear() });
      field.append(...[...CHOICES.keys()].map((choice) => make("option", { value: choice }, [choice])));
      field.disabled = signs === null || (couple && k < 2);
      return field;
    }));
    this.#rows.replaceChildren(...this.#fields.map((fields, row) => make("tr", {}, [
      make("td", {}, [body.acting[row].symbol]), ...fields.map((field) => make("td", {}, [field])),
    ])));
    this.#clear();
  }

  #clear() {
    write(this.#said, "");
    for (const field of this.#fields.flat()) field.removeAttribute("aria-invalid");
  }

  #judge() {
    const words = this.#words();
    const about = Math.max(this.#about.selectedIndex, 0);
    let [wrong, missing] = [0, 0];
    this.#fields.forEach((fields, row) => fields.forEach((field, k) => {
      const right = this.#body?.acting[row]?.signs?.[k < 2 ? k : 2 + about];
      const given = CHOICES.get(field.value) ?? null;
      if (field.disabled || right === undefined) return;
      const isWrong = given !== null && given !== right;
      missing += given === null ? 1 : 0;
      wrong += isWrong ? 1 : 0;
      if (isWrong) field.setAttribute("aria-invalid", "true");
      else field.removeAttribute("aria-invalid");
    }));
    const exact = (/** @type {number} */ count) => words.numbers.exact(count);
    const said = wrong + missing === 0 ? words.text("force_plan.exercise.right") : words.text("force_plan.exercise.wrong", { wrong: exact(wrong), missing: exact(missing) });
    write(this.#said, said);
  }

  /** @returns {HTMLElement} the exercise on paper, with blanks */
  onPaper() {
    const words = this.#words();
    const blank = () => make("td", { class: "cell" });
    const acting = this.#body?.acting ?? [];
    const rows = acting.map(({ symbol }) => make("tr", {}, [make("td", {}, [symbol]), ...SUMS.map(blank)]));
    const head = make("tr", {}, [make("th", {}, [words.text("force_plan.force")]), ...SUMS.map((sum) => make("th", {}, [sum]))]);
    const lines = SUMS.map((sum) => make("p", { class: "blank" }, [`${sum} =`]));
    return make("div", {}, [make("p", {}, [words.text("force_plan.exercise.note")]), make("table", {}, [make("thead", {}, [head]), make("tbody", {}, rows)]), ...lines]);
  }
}
