// The name of the mechanism in the header, and what is called by it.
import { byId, write } from "assur/core/dom.js";
import { Seen } from "assur/core/seen.js";

export class Title {
  #place = byId("mechanism-name", HTMLElement);
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
    const name = this.#name(state, words);
    write(this.#place, name);
    this.#named.dataset.n = name;
    words.fill(this.#named.parentElement ?? this.#named);
  }

  /**
   * @param {import("assur/state/state.js").State} state
   * @param {import("assur/core/words.js").Words} words
   * @returns {string} its name in the catalogue, else the title it has itself, else what its kind is called
   */
  #name(state, words) {
    const preset = this.#engine.presetOf(state);
    if (preset) return words.text(`gallery.${preset.id}`);
    const title = "title" in state.document && state.document.title;
    return title || words.text(`kind.${state.kind}`);
  }
}
