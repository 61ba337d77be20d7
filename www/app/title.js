// The name of the mechanism in the header, and what is called by it.
import { byId, write } from "assur/core/dom.js";

export class Title {
  #place = byId("mechanism-name", HTMLElement);
  #named = byId("mechanism", HTMLElement);
  #engine;
  /** @type {readonly unknown[]} what was shown last */
  #shown = [];

  /** @param {import("assur/app/page.js").Page} page */
  constructor({ engine }) {
    this.#engine = engine;
  }

  /** @param {import("assur/state/model.js").AnySnapshot} snapshot */
  render({ state, words }) {
    const shown = [state.document, words];
    if (shown.every((part, i) => part === this.#shown[i])) return;
    this.#shown = shown;
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
