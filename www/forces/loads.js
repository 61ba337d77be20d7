// The fold with masses and loads: gravity, masses of the links, loads, springs, dampers and friction. Loaded when the fold is first opened.
import "assur/forces/style.js";
import { sentence } from "assur/controls/problems.js";
import { byId, make } from "assur/core/dom.js";
import { called, numberEntries } from "assur/core/names.js";
import { Seen } from "assur/core/seen.js";
import { linkageOf } from "assur/forces/change.js";
import { Loads, TERMS } from "assur/forces/load-list.js";
import { Masses } from "assur/forces/masses.js";
import { FrictionList } from "assur/forces/friction-list.js";
import { Springs } from "assur/forces/spring-list.js";
import { inputNow } from "assur/state/change.js";

/**
 * @typedef {import("assur/state/model.js").Snapshot} Snapshot
 * @typedef {import("assur/core/problem.js").Problem} Problem
 */

/** The field at fault, by the code of a problem of masses. */
const OF_MASSES = Object.freeze(/** @type {Readonly<Record<string, string>>} */ ({ negative_mass: "mass", impossible_inertia: "inertia" }));

export class LoadFold {
  #page;
  #masses;
  #loads;
  #springs;
  #dampers;
  #friction;
  #fold = byId("fold-loads", HTMLDetailsElement);
  #consistent = make("p", { class: "forces-consistent", "data-t": "forces.consistent" });
  #own;
  #others;
  #built = new Seen();
  #shown = new Seen();

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    this.#page = page;
    this.#masses = new Masses(page);
    this.#loads = new Loads(page);
    this.#springs = new Springs(page, "springs");
    this.#dampers = new Springs(page, "dampers");
    this.#friction = new FrictionList(page);
    const { words } = page;
    this.#own = make("div", {}, [
      this.#consistent,
      this.#masses.element,
      ...[this.#loads, this.#springs, this.#dampers, this.#friction].map(({ element, name }) => make("section", {}, [make("h2", { "data-t": `forces.${name}` }), element])),
    ]);
    const become = make("button", { id: "loads-become", type: "button", class: "control", "data-t": "forces.become", onclick: () => this.#become() });
    this.#others = make("div", {}, [make("p", { "data-t": "forces.only_linkage" }), become]);
    this.#fold.append(this.#own, this.#others);
    for (const list of ["masses", "bars"]) numberEntries(list, (index) => called(linkageOf(page).links[index]?.name ?? "", page.words));
    numberEntries("terms", (index) => String(Math.floor(index / TERMS) + 1));
    words.fill(this.#fold);
    this.#fold.addEventListener("focusout", () => {
      this.#shown = new Seen();
      page.redraw();
    });
  }

  /** @param {Snapshot} snapshot */
  render({ state, summary, words, problems }) {
    if (!this.#fold.open) return;
    const own = state.kind === "linkage";
    this.#own.hidden = !own;
    this.#others.hidden = own;
    if (state.kind !== "linkage") return;
    const { document } = state;
    this.#consistent.hidden = words.unit !== "";
    const wrong = new Set(problems.map(placeOf));
    if (this.#shown.same(document, summary, words, problems.map((one) => JSON.stringify(one)).join())) return;
    const parts = [this.#masses, this.#loads, this.#springs, this.#dampers, this.#friction];
    const shape = JSON.stringify([document.links.map(({ name, points }) => [name, points]), document.tracers?.map(({ name, link }) => [name, link]), ...parts.map((part) => part.shape(document))]);
    // A field must stay in the page while a person types into it, so the fold is rebuilt only when the field is left.
    if (!this.#isTyping() && !this.#built.same(words, shape)) for (const part of parts) part.build(document, words);
    const said = (/** @type {readonly Problem[]} */ own) => own.map((problem) => sentence(problem, words, document)).join(" ");
    const ofLinks = document.links.map(({ name }, i) => problems.filter(({ link, code, field }) => (link === name && code in OF_MASSES) || field?.startsWith(`masses[${i}]`)));
    ofLinks.forEach((own, i) => own.forEach(({ code }) => wrong.add(`masses[${i}].${OF_MASSES[code]}`)));
    this.#masses.show(document, words, wrong, (i) => said(ofLinks[i]));
    for (const part of [this.#loads, this.#springs, this.#dampers, this.#friction]) {
      part.show(wrong, (i) => said(problems.filter((one) => placeOf(one).startsWith(`${part.name}[${i}]`))));
    }
  }

  #isTyping() {
    const at = document.activeElement;
    return at instanceof HTMLInputElement && at.type !== "checkbox" && this.#fold.contains(at);
  }

  /** Makes the mechanism a linkage, whose links may have masses. An edit that moves nothing does so. */
  #become() {
    const page = this.#page;
    const { kind, document } = page.engine.simulator.edit({ edit: "move", points: [], by: [0, 0] }, inputNow(page));
    page.choose(kind, document);
  }
}

/**
 * @param {Problem} problem
 * @returns {string} the field at fault or the path of the entry at fault; empty if there is neither
 */
function placeOf({ field, path }) {
  return field ?? String(path ?? "");
}
