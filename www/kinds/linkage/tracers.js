// The traced points of a linkage in the rail: their coordinates on their links, and buttons to remove them.
import { NumberBox, numberField } from "assur/controls/number-box.js";
import { fold } from "assur/controls/section.js";
import { byId, make } from "assur/core/dom.js";
import { called } from "assur/core/names.js";
import { Seen } from "assur/core/seen.js";
import { subscript } from "assur/core/symbols.js";
import { placeTraced } from "assur/state/change.js";
import { edited } from "assur/state/state.js";

/** Coordinates of a point on a link: along the line of the link's first two points, and at right angles, to the left. */
const AXES = Object.freeze(/** @type {const} */ (["along", "across"]));

export class TracedPoints {
  #store;
  #drafts;
  #list = make("div");
  #section = make("section", { "data-of": "linkage" }, [make("h2", { "data-t": "tracers.heading" }), this.#list]);
  /** @type {NumberBox[][]} fields of the two coordinates of each point */
  #boxes = [];
  #built = new Seen();
  #shown = new Seen();

  /** @param {import("assur/app/page.js").Page} page */
  constructor({ store, drafts }) {
    this.#store = store;
    this.#drafts = drafts;
    fold("show", [this.#section]);
  }

  /** @param {import("assur/kinds/linkage/rail.js").Snapshot} snapshot */
  render({ state, summary, words, problems }) {
    const { tracers = [] } = state.document;
    const wrong = new Set(problems.map(({ field, path }) => field ?? path));
    if (this.#shown.same(state.document.tracers, summary, words, ...wrong)) return;
    this.#section.hidden = tracers.length === 0;
    const built = JSON.stringify([words.lang, tracers.map(({ name, link }) => [name, link, summary.roles[link]])]);
    if (!this.#built.same(built)) this.#build(tracers, summary, words);
    this.#boxes.forEach((boxes, i) => boxes.forEach((box, axis) => {
      const value = tracers[i].at[axis];
      box.show(value, { brief: words.numbers.short(value), full: words.numbers.exact(value) }, wrong.has(`tracers[${i}].at`));
    }));
  }

  /**
   * @param {readonly { name: string, link: string }[]} tracers
   * @param {import("assur/kinds/linkage/rail.js").Summary} summary
   * @param {import("assur/core/words.js").Words} words
   */
  #build(tracers, summary, words) {
    const focused = this.#list.contains(document.activeElement);
    this.#boxes = [];
    this.#list.replaceChildren(...tracers.flatMap(({ name, link }, index) => {
      const role = summary.roles[link] ?? "secondary";
      const remove = make("button", {
        id: `traced-remove-${index}`, class: "control icon", type: "button",
        "data-t-label": "tracers.remove_named", "data-t-title": "tracers.remove_named", "data-n": subscript(name),
        onclick: () => this.#remove(name),
      }, ["×"]);
      const inputs = AXES.map((axis) => numberField({ id: `traced-${axis}-${index}`, "data-t-label": `draw.${axis}` }));
      this.#boxes.push(inputs.map((input, axis) => new NumberBox(input, `tracers[${index}].at ${axis}`, this.#drafts, (value) => placeTraced(this.#store, name, axis, value))));
      const colour = `--accent: var(--role-${role})`;
      return [
        make("div", { class: "row choosing", style: colour }, [make("b", {}, [subscript(name)]), make("span", { class: "name" }, [called(link, words)]), remove]),
        ...AXES.map((axis, k) => make("div", { class: "row", style: colour }, [make("span", { "data-t": `draw.${axis}` }), inputs[k]])),
      ];
    }));
    words.fill(this.#section);
    // If the focus was in the old list, it moves to the first button of the new list, or to the box for traces.
    if (focused) (this.#list.querySelector("button") ?? byId("traces", HTMLInputElement)).focus();
  }

  /** @param {string} name */
  #remove(name) {
    this.#store.update((state) => edited(state, "linkage", ({ tracers = [] }) => ({ tracers: tracers.filter((one) => one.name !== name) })));
  }
}
