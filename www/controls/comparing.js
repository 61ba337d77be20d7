// Comparison of the current mechanism B with an earlier one, A: buttons to keep B as A, exchange both, and remove A.
import { byId, make } from "assur/core/dom.js";
import { Seen } from "assur/core/seen.js";
import { withExtras, withMechanism } from "assur/state/state.js";

/** @typedef {import("assur/state/state.js").State} State */

/**
 * @param {State} state
 * @returns {import("assur/state/state.js").Document} the mechanism of the state
 */
function mechanism({ kind, document }) {
  return /** @type {import("assur/state/state.js").Document} */ (Object.freeze({ kind, document }));
}

/**
 * @param {State} state
 * @returns {State} the state with A and B exchanged
 */
function exchanged(state) {
  const { compared } = state;
  return compared ? withExtras(withMechanism(state, compared.kind, compared.document), { compared: mechanism(state) }) : state;
}

/** Changes of the state, by the names of the buttons that make them. */
const ACTS = Object.freeze({
  freeze: (/** @type {State} */ state) => withExtras(state, { compared: mechanism(state) }),
  swap: exchanged,
  remove: (/** @type {State} */ state) => withExtras(state, { compared: undefined }),
});

export class Comparing {
  #section = byId("compare", HTMLElement);
  #said = byId("compare-said", HTMLElement);
  #seen = new Seen();
  #buttons;

  /** @param {import("assur/app/page.js").Page} page */
  constructor({ history, store }) {
    const names = /** @type {(keyof typeof ACTS)[]} */ (Object.keys(ACTS));
    this.#buttons = Object.fromEntries(names.map((name) => {
      const button = make("button", { id: `compare-${name}`, class: "control", type: "button", "data-t": `compare.${name}` });
      button.addEventListener("click", () => {
        history.step(() => store.update(ACTS[name]));
        // The button disappears, so its focus moves to another one.
        if (name === "remove") this.#buttons.freeze.focus();
      });
      return [name, button];
    }));
    byId("compare-acts", HTMLElement).append(...Object.values(this.#buttons));
  }

  /** @param {import("assur/state/model.js").Snapshot} snapshot */
  render({ state, summary, compared, compares, words }) {
    const none = !(summary.moves === "angle" || summary.moves === "length") && !state.compared;
    if (this.#section.hidden !== none) this.#section.hidden = none;
    if (none) return;
    const is = !state.compared ? "none" : !compares ? "otherwise" : compared ? "shown" : "apart";
    if (this.#seen.same(is, words)) return;
    this.#buttons.freeze.hidden = false;
    for (const name of ["swap", "remove"]) this.#buttons[name].hidden = is === "none";
    this.#said.dataset.t = `compare.${is}`;
    words.fill(this.#section);
  }
}
