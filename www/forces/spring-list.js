// The list of springs, or that of dampers: between two points, or between two links at a hinge.
import { make } from "assur/core/dom.js";
import { called } from "assur/core/names.js";
import { card, writeReasons } from "assur/forces/card.js";
import { linkageOf, putList, without } from "assur/forces/change.js";
import { Fields, replaced } from "assur/forces/fields.js";
import { pointsOf } from "assur/forces/load-list.js";

/**
 * @typedef {import("assur/state/state.js").LinkageDocument} Document
 * @typedef {import("assur/types/file.js").SpringDocument} SpringFields
 * @typedef {import("assur/types/file.js").DamperDocument} DamperFields
 * @typedef {Partial<SpringFields> & Partial<DamperFields>} Part a spring or a damper
 * @typedef {import("assur/core/words.js").Words} Words
 */

/** Stiffness and damping of a new spring or damper, in the units of the document. */
const USUAL = 100;

export class Springs {
  name;
  element;
  #page;
  #amount;
  /** @type {Fields | null} */
  #fields = null;

  /**
   * @param {import("assur/app/page.js").Page} page
   * @param {"springs" | "dampers"} name of the list
   */
  constructor(page, name) {
    this.#page = page;
    this.name = name;
    this.#amount = /** @type {"stiffness" | "damping"} */ (name === "springs" ? "stiffness" : "damping");
    this.element = make("div", { id: name });
  }

  /**
   * @param {Document} document
   * @returns {readonly Part[]}
   */
  #list(document) {
    return /** @type {readonly Part[]} */ (document[this.name] ?? []);
  }

  /** @param {Document} document */
  shape(document) {
    return this.#list(document).map(({ ends, links }) => [ends?.map(({ link }) => link), links]);
  }

  /**
   * @param {Document} document
   * @param {Words} words
   */
  build(document, words) {
    const fields = new Fields(this.#page, words);
    this.#fields = fields;
    const cards = this.#list(document).map((part, i) => this.#card(document, part, i, fields, words));
    replaced(this.element, [...cards, fields.button(`${this.name}-add`, this.name === "springs" ? "forces.springs.add" : "forces.dampers.add", () => this.#add())]);
  }

  /**
   * @param {ReadonlySet<string>} wrong fields at fault
   * @param {(index: number) => string} reason why a part is refused; empty if it is not
   */
  show(wrong, reason) {
    this.#fields?.show(wrong);
    writeReasons(this.element, this.name, this.#list(linkageOf(this.#page)).length, reason);
  }

  #add() {
    const document = linkageOf(this.#page);
    const link = document.links.at(-1)?.name ?? "";
    /** @type {Part} */
    const part = { ends: [{ link, point: pointsOf(document, link).at(-1) ?? "" }, { link: "frame", point: document.frame[0] ?? "" }], [this.#amount]: USUAL };
    this.#page.history.step(() => this.#change((parts) => [...parts, part]));
  }

  /** @param {(parts: readonly Part[]) => readonly Part[]} change */
  #change(change) {
    putList(this.#page, this.name, (parts) => /** @type {typeof parts} */ (change(/** @type {readonly Part[]} */ (parts))));
  }

  /**
   * @param {number} i
   * @param {Part} change; an undefined field is removed
   */
  #put(i, change) {
    this.#change((parts) => parts.map((part, k) => (k === i ? without({ ...part, ...change }) : part)));
  }

  /**
   * @param {Document} document
   * @param {Part} part
   * @param {number} i
   * @param {Fields} fields
   * @param {Words} words
   */
  #card(document, part, i, fields, words) {
    const { name } = this;
    const now = () => this.#list(linkageOf(this.#page))[i] ?? part;
    const id = (/** @type {string} */ end) => `${name}-${i}-${end}`;
    const step = (/** @type {Part} */ change) => this.#page.history.step(() => this.#put(i, change));
    const links = [["frame", called("frame", words)], ...document.links.map((link) => [link.name, called(link.name, words)])].map(([value, text]) => /** @type {const} */ ([value, text]));
    const torsion = !!part.links;
    const both = /** @type {const} */ ([0, 1]);
    const content = [
      fields.choice(id("kind"), "forces.springs.kind", [["ends", words.text("forces.springs.ends")], ["links", words.text("forces.springs.links")]], () => (now().links ? "links" : "ends"), (value) => this.#turn(i, value === "links")),
    ];
    for (const end of both) {
      const values = { n: words.numbers.exact(end + 1) };
      if (torsion) {
        content.push(fields.choice(id(`link-${end}`), "forces.springs.link", links, () => now().links?.[end] ?? "", (link) => step({ links: paired(now().links ?? ["", ""], end, link) }), values));
        continue;
      }
      const ends = () => now().ends ?? [{ link: "", point: "" }, { link: "", point: "" }];
      const points = pointsOf(document, part.ends?.[end].link ?? "").map((one) => /** @type {const} */ ([one, one]));
      content.push(
        fields.choice(id(`link-${end}`), "forces.springs.link", links, () => ends()[end].link, (link) => step({ ends: paired(ends(), end, { link, point: pointsOf(linkageOf(this.#page), link)[0] ?? "" }) }), values),
        fields.choice(id(`point-${end}`), "forces.springs.point", points, () => ends()[end].point, (point) => step({ ends: paired(ends(), end, { link: ends()[end].link, point }) }), values),
      );
    }
    const number = (/** @type {keyof Part & ("stiffness" | "damping" | "free_length" | "free_angle_deg")} */ of, /** @type {string} */ symbol, /** @type {import("assur/forces/fields.js").Unit} */ unit) =>
      fields.number(`${name}[${i}].${of}`, { symbol, unit, n: words.numbers.exact(i + 1) }, () => now()[of] ?? 0, (value) => this.#put(i, { [of]: value }));
    if (name === "springs") {
      content.push(number("stiffness", "k", torsion ? "torsion" : "stiffness"));
      content.push(torsion ? number("free_angle_deg", "θ_0", "degree") : number("free_length", "l_0", "length"));
    } else {
      content.push(number("damping", "c", torsion ? "torsion_damping" : "damping"));
    }
    const between = (part.links?.map((link) => called(link, words)) ?? part.ends?.map(({ point }) => point) ?? []).join(" – ");
    const remove = () => this.#page.history.step(() => this.#change((parts) => parts.filter((_, k) => k !== i)));
    return card({ list: name, i, title: between }, content, fields, remove);
  }

  /**
   * Changes a part between two points to one between two links, or back.
   * @param {number} i
   * @param {boolean} torsion
   */
  #turn(i, torsion) {
    const document = linkageOf(this.#page);
    const [one, other] = this.#list(document)[i]?.ends?.map(({ link }) => link) ?? this.#list(document)[i]?.links ?? ["", ""];
    const end = (/** @type {string} */ link) => ({ link, point: pointsOf(document, link)[0] ?? "" });
    const change = torsion ? { ends: undefined, free_length: undefined, links: /** @type {[string, string]} */ ([one, other]) } : { links: undefined, free_angle_deg: undefined, ends: /** @type {Part["ends"]} */ ([end(one), end(other)]) };
    this.#page.history.step(() => this.#put(i, change));
  }
}

/**
 * @template T
 * @param {readonly [T, T] | readonly T[]} pair
 * @param {0 | 1} at
 * @param {T} value
 * @returns {[T, T]}
 */
function paired([one, other], at, value) {
  return at === 0 ? [value, other] : [one, value];
}
