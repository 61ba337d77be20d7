// Checkboxes that show and hide the overlays of the drawing and the plots, and the panels beside them.
import { byId } from "assur/core/dom.js";
import { SWITCHES, withView } from "assur/state/state.js";

/** @typedef {import("assur/state/state.js").State} State */

export class Switches {
  #switches = SWITCHES.map((name) => ({ name, input: byId(name, HTMLInputElement) }));

  /** @param {import("assur/state/store.js").Store<State>} store */
  constructor(store) {
    for (const { name, input } of this.#switches) {
      input.addEventListener("change", () => store.update((state) => withView(state, { [name]: input.checked })));
    }
  }

  /** @param {{ state: State }} snapshot */
  render({ state: { view } }) {
    for (const { name, input } of this.#switches) if (input.checked !== view[name]) input.checked = !!view[name];
  }
}
