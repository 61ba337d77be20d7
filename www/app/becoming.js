// Conversion of the document into another kind: a button in the menu for each possible kind.
import { byId, make } from "assur/core/dom.js";
import { attempt } from "assur/core/problem.js";
import { inputNow } from "assur/state/change.js";

/** Field of the page that shows why a document cannot be converted, and how long it does, in milliseconds. */
const FIELD = "become";
const MESSAGE_PERIOD = 8000;

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
   * @param {"scheme" | "point-path"} kind
   * @param {import("assur/core/words.js").Words} words
   */
  #add(kind, words) {
    const page = this.#page;
    const button = make("button", { id: `become-${kind}`, type: "button", "data-t": `become.${kind}` });
    button.addEventListener("click", () => {
      const { value: made, problems } = attempt(() => page.engine.simulator.asKind(kind, inputNow(page)));
      if (made) page.choose(made.kind, made.document);
      else this.#refuse(problems);
    });
    this.#buttons.set(kind, button);
    this.#entries.append(button);
    words.fill(this.#entries);
  }

  /** @param {readonly import("assur/core/problem.js").Problem[]} problems */
  #refuse(problems) {
    const { drafts } = this.#page;
    drafts.keep(FIELD, problems);
    setTimeout(() => drafts.drop(FIELD), MESSAGE_PERIOD);
  }
}
