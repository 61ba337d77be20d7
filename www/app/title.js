// Title of the mechanism: in the header, where a tooltip gives the use of a preset, in the browser's tab and in the
// drawing's label.
import { byId, write } from "assur/core/dom.js";
import { Seen } from "assur/core/seen.js";
import { titleOf } from "assur/core/titles.js";

export class Title {
  #heading = byId("mechanism-name", HTMLElement);
  #named = byId("mechanism", HTMLElement);
  #engine;
  #shown = new Seen();

  /** @param {import("assur/app/page.js").Page} page */
  constructor({ engine }) {
    this.#engine = engine;
  }

  /** @param {import("assur/state/model.js").AnySnapshot} snapshot */
  render({ state, words }) {
    if (this.#shown.same(state.document, words)) return;
    const preset = this.#engine.catalogue.presetOf(state);
    const name = titleOf(state, this.#engine, words);
    write(this.#heading, name);
    document.title = `${name} · Assur`;
    const about = `about.${preset?.id}`;
    this.#heading.title = words.has(about) ? words.text(about) : "";
    this.#named.dataset.n = name;
    words.fill(this.#named.parentElement ?? this.#named);
  }
}
