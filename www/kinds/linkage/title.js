// The name of the linkage, where the mixer's would stand.
import { byId, write } from "assur/core/dom.js";

/** @typedef {import("assur/core/words.js").Words} Words */

/** What is called otherwise of a linkage: element, attribute, the key of its words of the mixer, and of a linkage. */
const CALLED = Object.freeze([
  ["mechanism", "data-t-label", "stage.canvas", "stage.linkage"],
  ["reset", "data-t", "edit.reset", "reset.linkage"],
]);

export class LinkageTitle {
  #place = byId("linkage-name", HTMLElement);
  #engine;
  /** @type {readonly unknown[]} what was shown last */
  #shown = [];

  /** @param {import("assur/app/page.js").Page} page */
  constructor({ engine }) {
    this.#engine = engine;
  }

  /** @param {import("assur/state/model.js").Snapshot} snapshot */
  render({ state, words }) {
    const mixer = state.kind === "mixer";
    const name = mixer ? "" : nameOf(this.#engine, state, words);
    const shown = [mixer, name, words];
    if (shown.every((part, i) => part === this.#shown[i])) return;
    this.#shown = shown;
    write(this.#place, name);
    for (const [id, attribute, ofMixer, ofLinkage] of CALLED) {
      const element = byId(id, HTMLElement);
      element.setAttribute(attribute, mixer ? ofMixer : ofLinkage);
      element.dataset.n = name;
      words.fill(element.parentElement ?? element);
    }
  }
}

/**
 * @param {import("assur/engine.js").Engine} engine
 * @param {import("assur/state/state.js").State<"linkage">} state
 * @param {Words} words
 * @returns {string} its name in the gallery, else the title it has itself
 */
function nameOf(engine, state, words) {
  const preset = engine.presetOf(state);
  return preset ? words.text(`gallery.${preset.id}`) : state.document.title || words.text("gallery.own");
}
