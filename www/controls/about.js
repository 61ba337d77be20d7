// Choice of two links: the link whose instant centre, centrodes and circles are drawn, and the link relative to which
// that instant centre is constructed. Shown if one of these overlays is on.
import { byId } from "assur/core/dom.js";
import { html, render } from "assur/core/html.js";
import { called } from "assur/core/names.js";
import { Seen } from "assur/core/seen.js";
import { withView } from "assur/state/state.js";

/** @typedef {import("assur/state/model.js").Snapshot} Snapshot */

/** Texts of the first entry of each list. In the state, an empty string stands for this entry. */
const FIRST = /** @type {const} */ ({ about: "show.about_first", relative_to: "link.frame" });
const CHOICES = /** @type {(keyof typeof FIRST)[]} */ (Object.keys(FIRST));

export class AboutLink {
  #engine;
  #row = byId("about-link", HTMLElement);
  #against = byId("about-against", HTMLElement);
  #selects = Object.freeze({ about: byId("about", HTMLSelectElement), relative_to: byId("relative_to", HTMLSelectElement) });
  #built = new Seen();

  /** @param {import("assur/app/page.js").Page} page */
  constructor({ engine, store }) {
    this.#engine = engine;
    for (const choice of CHOICES) {
      const select = this.#selects[choice];
      select.addEventListener("change", () => store.update((state) => withView(state, { [choice]: select.value })));
    }
  }

  /** @param {Snapshot} snapshot */
  render({ state: { view }, words }) {
    const { links } = this.#engine.names;
    this.#row.hidden = !(view.instant_centres || view.centrodes || view.curvature);
    if (this.#row.hidden) return;
    // Centrodes and circles are always those of the motion relative to the frame.
    this.#against.hidden = !view.instant_centres;
    const anew = !this.#built.same(links, words);
    const entry = (/** @type {string} */ value, /** @type {string} */ text) => html`<option value=${value}>${text}</option>`;
    for (const choice of CHOICES) {
      const select = this.#selects[choice];
      if (anew) render([entry("", words.text(FIRST[choice])), ...links.map((link) => entry(link, called(link, words)))], select);
      // If the mechanism lacks the chosen link, the first entry is shown.
      const value = links.includes(view[choice]) ? view[choice] : "";
      if (select.value !== value) select.value = value;
    }
  }
}
