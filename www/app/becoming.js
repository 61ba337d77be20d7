// Conversion of the document into another kind: a button in the menu for each possible kind.
import { byId, make } from "assur/core/dom.js";
import { attempt } from "assur/core/problem.js";
import { inputNow } from "assur/state/change.js";

export class Becoming {
  #page;
  #entries = byId("menu-entries", HTMLElement);
  /** @type {Map<string, HTMLButtonElement>} buttons by the kind they convert to */
  #buttons = new Map();

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    this.#page = page;
  }

  /** @param {import("assur/state/model.js").AnySnapshot} snapshot */
  render({ summary, words, stale }) {
    const kinds = summary.moves ? summary.becomes : [];
    for (const kind of kinds) if (!this.#buttons.has(kind)) this.#add(kind, words);
    for (const [kind, button] of this.#buttons) {
      button.hidden = !kinds.some((one) => one === kind);
      button.disabled = stale;
    }
  }

  /**
   * @param {"scheme"} kind
   * @param {import("assur/core/words.js").Words} words
   */
  #add(kind, words) {
    const page = this.#page;
    const button = make("button", { id: `become-${kind}`, type: "button", "data-t": `become.${kind}` });
    button.addEventListener("click", () => {
      const made = attempt(() => page.engine.simulator.asKind(kind, inputNow(page))).value;
      if (made) page.choose(made.kind, made.document);
    });
    this.#buttons.set(kind, button);
    this.#entries.append(button);
    words.fill(this.#entries);
  }
}
