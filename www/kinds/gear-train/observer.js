// Choice of the frame of reference in which the train is drawn, read and plotted.
import { section } from "assur/controls/section.js";
import { make } from "assur/core/dom.js";
import { edited } from "assur/state/state.js";

/** @typedef {import("assur/kinds/gear-train/drives.js").Snapshot} Snapshot */

const OBSERVERS = Object.freeze(/** @type {const} */ (["ground", "sun", "carrier", "ring"]));

export class ObserverView {
  /** @type {Map<string, HTMLInputElement>} */
  #boxes = new Map();

  /** @param {import("assur/app/page.js").Page} page */
  constructor({ store }) {
    const choices = OBSERVERS.map((observer) => {
      const box = make("input", { id: `observer-${observer}`, type: "radio", name: "observer", value: observer });
      box.addEventListener("change", () => store.update((state) => edited(state, "gear-train", () => ({ observer }))));
      this.#boxes.set(observer, box);
      return make("label", { class: "check" }, [box, " ", make("span", { "data-t": `observer.${observer}` })]);
    });
    section("gear-train", "observer.heading", "observer", [
      make("div", { class: "train-observers", role: "radiogroup", "data-t-label": "field.observer" }, choices),
      make("p", { class: "note", "data-t": "observer.said" }),
    ]);
  }

  /** @param {Snapshot} snapshot */
  render({ state: { document } }) {
    const box = this.#boxes.get(document.observer ?? "ground");
    if (box && !box.checked) box.checked = true;
  }
}
