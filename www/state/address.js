// The address bar: the address contains the state, and the browser's Back returns to the previous mechanism.
import { MAX_LENGTH, toAddress } from "assur/state/codec.js";
import { orNull } from "assur/state/storage.js";
import { EXTRAS, usualView } from "assur/state/state.js";

/** @typedef {import("assur/state/state.js").State} State */

/**
 * @param {string} address
 * @returns {string} the part after #, or an empty string
 */
export function addressed(address) {
  return address.split("#").slice(1).join("#");
}

export class Address {
  #engine;
  #usual;

  /**
   * @param {import("assur/engine.js").Engine} engine
   * @param {string} lang language of the reader, left out of a short address
   */
  constructor(engine, lang) {
    this.#engine = engine;
    this.#usual = usualView({ lang });
  }

  /**
   * @param {State} state
   * @returns {string} address of the page with the state; in short form if the mechanism is an unchanged one of the catalogue
   */
  link(state) {
    const preset = this.#presetOf(state);
    const hash = toAddress(state, preset ? { id: preset.id, usual: this.#usual } : null);
    return `${location.href.split("#")[0]}#${hash}`;
  }

  /**
   * @param {State} state
   * @returns {boolean} true if the state contains more than an unchanged mechanism of the catalogue
   */
  isOwn(state) {
    return !this.#presetOf(state) || EXTRAS.some((name) => state[name]);
  }

  /** @param {State} state */
  #presetOf(state) {
    const preset = this.#engine.catalogue.presetOf(state);
    return preset && JSON.stringify(preset.document) === JSON.stringify(state.document) ? preset : null;
  }

  /** @param {State} state */
  show(state) {
    orNull(() => history.replaceState(null, "", this.#shown(state)));
  }

  /**
   * Adds another mechanism to the browser's history, so that Back returns to the previous one.
   * @param {State} before
   * @param {State} now
   */
  enter(before, now) {
    if (before.kind === now.kind && before.document === now.document) return;
    this.show(before);
    orNull(() => history.pushState(null, "", this.#shown(now)));
  }

  /**
   * Tests whether the link of a state is short enough to be opened. A state with a long lesson needs a file.
   * @param {State} state
   */
  holds(state) {
    return addressed(this.link(state)).length <= MAX_LENGTH;
  }

  /** @param {State} state */
  #shown(state) {
    const link = this.link(state);
    return addressed(link).length <= MAX_LENGTH ? link : link.split("#")[0];
  }
}
