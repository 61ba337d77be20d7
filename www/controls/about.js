// Of which link instant centre, centrodes and circles are drawn: chosen where any of them is shown.
import { byId, make } from "assur/core/dom.js";
import { called } from "assur/core/names.js";
import { withView } from "assur/state/state.js";

/** @typedef {import("assur/state/model.js").Snapshot} Snapshot */

export class AboutLink {
  #engine;
  #row = byId("about-link", HTMLElement);
  #select = byId("about", HTMLSelectElement);
  /** @type {readonly unknown[]} what the entries were made of */
  #built = [];

  /** @param {import("assur/app/page.js").Page} page */
  constructor({ engine, store }) {
    this.#engine = engine;
    this.#select.addEventListener("change", () => store.update((state) => withView(state, { about: this.#select.value })));
  }

  /** @param {Snapshot} snapshot */
  render({ state: { view }, words }) {
    const { links } = this.#engine;
    this.#row.hidden = !(view.instant_centres || view.centrodes || view.curvature);
    if (this.#row.hidden) return;
    const built = [links, words];
    if (built.some((part, i) => part !== this.#built[i])) {
      const entry = (/** @type {string} */ value, /** @type {string} */ text) => make("option", { value }, [text]);
      this.#select.replaceChildren(entry("", words.text("show.about_first")), ...links.map((link) => entry(link, called(link, words))));
      this.#built = built;
    }
    // A link of another mechanism: what is drawn then is the first coupler's.
    const value = links.includes(view.about) ? view.about : "";
    if (this.#select.value !== value) this.#select.value = value;
  }
}
