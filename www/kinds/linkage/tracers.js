// The points that are traced on the links of a linkage, in its rail: where each is, and one less.
import { byId, make } from "assur/core/dom.js";
import { called } from "assur/core/names.js";
import { Seen } from "assur/core/seen.js";
import { subscript } from "assur/core/symbols.js";
import { edited } from "assur/state/state.js";

export class TracedPoints {
  #store;
  #list = make("div");
  #section = make("section", { "data-of": "linkage" }, [make("h2", { "data-t": "tracers.heading" }), this.#list]);
  #shown = new Seen();

  /** @param {import("assur/app/page.js").Page} page */
  constructor({ store }) {
    this.#store = store;
    byId("overlays", HTMLElement).before(this.#section);
  }

  /** @param {import("assur/kinds/linkage/rail.js").Snapshot} snapshot */
  render({ state, summary, words }) {
    const { tracers = [] } = state.document;
    if (this.#shown.same(state.document.tracers, summary, words)) return;
    const focused = this.#list.contains(document.activeElement);
    this.#section.hidden = tracers.length === 0;
    this.#list.replaceChildren(...tracers.map(({ name, link, at }, index) => {
      const role = summary.roles[link] ?? "secondary";
      const remove = make("button", {
        id: `traced-remove-${index}`, class: "control icon", type: "button",
        "data-t-label": "tracers.remove_named", "data-t-title": "tracers.remove_named", "data-n": subscript(name),
      }, ["×"]);
      remove.addEventListener("click", () => this.#remove(name));
      const place = at.map((value) => words.numbers.short(value)).join("; ");
      return make("div", { class: "row choosing", style: `--accent: var(--role-${role})` }, [
        make("span", { class: "name" }, [make("b", {}, [subscript(name)]), ` ${called(link, words)} (${place})`]), remove,
      ]);
    }));
    words.fill(this.#section);
    // A button that is there no more gives the focus away, else it would be lost.
    if (focused) (this.#list.querySelector("button") ?? byId("traces", HTMLInputElement)).focus();
  }

  /** @param {string} name */
  #remove(name) {
    this.#store.update((state) => edited(state, "linkage", ({ tracers = [] }) => ({ tracers: tracers.filter((one) => one.name !== name) })));
  }
}
