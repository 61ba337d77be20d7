// Masses of the links, with their centres of mass and moments of inertia, and gravity.
import { sentence } from "assur/controls/problems.js";
import { make, write } from "assur/core/dom.js";
import { called } from "assur/core/names.js";
import { measured } from "assur/core/units.js";
import { linkageOf, put, putLink, reshape, tried } from "assur/forces/change.js";
import { Fields, replaced, unitText } from "assur/forces/fields.js";

/**
 * @typedef {import("assur/core/words.js").Words} Words
 * @typedef {import("assur/types/web.js").MassHere} Mass
 */

/** Free fall on the Earth, m/s². */
const EARTH = 9.81;

export class Masses {
  #page;
  /** @type {Fields | null} */
  #fields = null;
  /** @type {readonly Mass[]} */
  #masses = [];
  /** @type {HTMLElement[]} summaries of the links */
  #names = [];
  /** Section and density from which the mass of a bar is computed; they are not saved. */
  #bar = { section: 0, density: 7850 };
  /** Reason why there are no counterweights, for the document without them. */
  #refusal = { document: /** @type {unknown} */ (null), text: "" };
  /** Whether both components of gravity are given. */
  #own = false;
  element = make("div", { id: "masses" });

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    this.#page = page;
  }

  /** @returns the value on which the set of fields depends: whether gravity is given by its components */
  shape() {
    return this.#gravityChosen();
  }

  /**
   * @param {import("assur/state/state.js").LinkageDocument} document
   * @param {Words} words
   */
  build({ links }, words) {
    const fields = new Fields(this.#page, words);
    this.#fields = fields;
    this.#names = links.map(() => make("summary"));
    const of = (/** @type {number} */ index) => this.#masses[index] ?? { mass: 0, inertia: 0, centre: [0, 0], given: false, bar: false };
    const cards = links.map(({ name, points }, i) => {
      const n = called(name, words);
      const own = (/** @type {string} */ part) => `masses[${i}].${part}`;
      const centre = (/** @type {0 | 1} */ axis) => fields.number(own(axis === 0 ? "along" : "across"), { symbol: axis === 0 ? "x_S" : "y_S", unit: "length", n }, () => of(i).centre[axis], (value) => {
        const { centre, inertia, given } = of(i);
        const on = /** @type {[number, number]} */ (centre.with(axis, value));
        const made = reshape(this.#page, { edit: "centre", link: linkageOf(this.#page).links[i]?.name ?? name, on }, own(axis === 0 ? "along" : "across"));
        // With a centre of mass, the link no longer counts as a uniform bar. The moment of inertia of the bar is then
        // stored.
        if (made && !given && inertia > 0) putLink(this.#page, i, { inertia });
      });
      const rows = [
        fields.number(own("mass"), { symbol: "m", unit: "kg", n }, () => linkageOf(this.#page).links[i]?.mass_kg ?? 0, (value) => putLink(this.#page, i, { mass_kg: value })),
        fields.number(own("inertia"), { symbol: "J_S", unit: "inertia", n }, () => linkageOf(this.#page).links[i]?.inertia ?? of(i).inertia, (value) => putLink(this.#page, i, { inertia: value })),
        centre(0), centre(1),
      ];
      if (points.length > 1) rows.push(...this.#barOf(i, name, n, fields));
      return make("details", { id: `mass-${i}`, class: "fold within" }, [this.#names[i], ...rows, this.#why(i)]);
    });
    const balance = make("div", { class: "forces-acts" }, [fields.button("balance", "forces.balance", () => this.#balance())]);
    const note = make("p", { class: "forces-consistent" }, [words.text("forces.balance.note")]);
    replaced(this.element, [...this.#gravity(fields, words), ...cards, balance, note, make("p", { id: "balance-why", class: "forces-why", role: "status" })]);
  }

  #balance() {
    const page = this.#page;
    page.history.step(() => {
      const problems = tried(page, { edit: "balance" });
      const { document } = page.store.get();
      this.#refusal = { document, text: problems.map((problem) => sentence(problem, page.words, document)).join(" ") };
    });
    this.#said(linkageOf(page));
  }

  /** @param {import("assur/state/state.js").LinkageDocument} document */
  #said(document) {
    const why = this.element.querySelector("#balance-why");
    if (why) write(why, this.#refusal.document === document ? this.#refusal.text : "");
  }

  /**
   * @param {import("assur/state/state.js").LinkageDocument} document
   * @param {Words} words
   * @param {ReadonlySet<string>} wrong fields at fault
   * @param {(index: number) => string} reason why the masses of a link are refused; empty if they are not
   */
  show(document, words, wrong, reason) {
    const { links } = document;
    this.#said(document);
    this.#masses = this.#page.engine.simulator.masses();
    links.forEach(({ name, mass_kg: mass }, i) => {
      const kilograms = mass ? `: ${measured(words.numbers.short(mass), unitText("kg", words))}` : "";
      if (this.#names[i]) write(this.#names[i], called(name, words) + kilograms);
      const why = this.element.querySelector(`#mass-${i}-why`);
      if (why) write(why, reason(i));
    });
    this.#fields?.show(wrong);
  }

  /** @param {number} i */
  #why(i) {
    return make("p", { id: `mass-${i}-why`, class: "forces-why" });
  }

  /**
   * Fields and buttons that make a link a uniform bar.
   * @param {number} i
   * @param {string} link
   * @param {string} n the link in the reader's language
   * @param {Fields} fields
   */
  #barOf(i, link, n, fields) {
    const bar = this.#bar;
    const put = (/** @type {"section" | "density"} */ part) => (/** @type {number} */ value) => {
      bar[part] = value;
    };
    const number = (/** @type {"section" | "density"} */ part, /** @type {string} */ symbol, /** @type {"area" | "density"} */ unit) =>
      fields.number(`bars[${i}].${part}`, { symbol, unit, n: n }, () => bar[part], put(part));
    return [
      make("div", { class: "forces-acts" }, [
        fields.button(`mass-${i}-uniform`, "forces.mass.uniform", () => this.#page.history.step(() => putLink(this.#page, i, { centre_of_mass: undefined, inertia: undefined }))),
      ]),
      number("section", "A", "area"), number("density", "ρ", "density"),
      make("div", { class: "forces-acts" }, [
        fields.button(`mass-${i}-bar`, "forces.mass.from_section", () => this.#page.history.step(() => reshape(this.#page, { edit: "uniform", link, ...bar }, `masses[${i}].mass`))),
      ]),
    ];
  }

  #gravityChosen() {
    const { gravity } = linkageOf(this.#page);
    if (this.#own) return "own";
    if (!gravity) return "off";
    return gravity[0] === 0 && gravity[1] === -EARTH ? "down" : "own";
  }

  /**
   * @param {Fields} fields
   * @param {Words} words
   */
  #gravity(fields, words) {
    const chosen = () => this.#gravityChosen();
    const options = ["off", "down", "own"].map((name) => /** @type {const} */ ([name, words.text(`forces.gravity.${name}`, { g: measured(words.numbers.short(EARTH), unitText("free_fall", words)) })]));
    const choice = fields.choice("gravity", "forces.gravity", options, chosen, (value) => {
      this.#own = value === "own";
      this.#page.drafts.dropAll(["gravity_x", "gravity_y"]);
      put(this.#page, ({ gravity }) => ({ gravity: value === "off" ? null : value === "down" ? [0, -EARTH] : (gravity ?? [0, -EARTH]) }));
      this.#page.redraw();
    });
    if (chosen() !== "own") return [choice];
    const component = (/** @type {0 | 1} */ axis, /** @type {string} */ field, /** @type {string} */ symbol) =>
      fields.number(field, { symbol, unit: "free_fall" }, () => gravityOf(this.#page)[axis], (value) => {
        const other = gravityOf(this.#page)[1 - axis];
        put(this.#page, () => ({ gravity: axis === 0 ? [value, other] : [other, value] }));
      });
    return [choice, component(0, "gravity_x", "g_x"), component(1, "gravity_y", "g_y")];
  }

}

/** @param {import("assur/app/page.js").Page} page */
function gravityOf(page) {
  return linkageOf(page).gravity ?? [0, -EARTH];
}
