// Rarely changed parameters of a run under load: magnets, inertias, damping.
import { NumberRow } from "assur/controls/number-row.js";
import { section } from "assur/controls/section.js";
import { make } from "assur/core/dom.js";
import { numberEntries } from "assur/core/names.js";
import { Seen } from "assur/core/seen.js";
import { subscript } from "assur/core/symbols.js";
import { edited } from "assur/state/state.js";

/** @typedef {import("assur/kinds/gear-train/drives.js").Document} Document */

/**
 * Lists of parameters. `list`: path in the document. `symbol`: letter of a parameter. `of`: numbers of the links.
 * @type {readonly Readonly<{ list: string, symbol: string, of: readonly string[] }>[]}
 */
const LISTS = Object.freeze([
  { list: "magnets.peak", symbol: "T", of: ["1", "4"] },
  { list: "magnets.damping", symbol: "d", of: ["1", "4"] },
  { list: "bodies.inertia", symbol: "J", of: ["1", "2", "3", "4"] },
  { list: "bodies.damping", symbol: "c", of: ["1", "2", "3", "4"] },
]);

export class BodiesView {
  /** @type {{ row: NumberRow, read: (document: Document) => number }[]} */
  #rows;
  #shown = new Seen();

  /** @param {import("assur/app/page.js").Page} page */
  constructor({ store, drafts }) {
    const put = (/** @type {string} */ list, /** @type {number} */ at, /** @type {number} */ value) =>
      store.update((state) => edited(state, "gear-train", (document) => {
        const { group, part, numbers } = listOf(document, list);
        return { [group]: { ...document[group], [part]: numbers.map((one, i) => (i === at ? value : one)) } };
      }));
    for (const { list, of } of LISTS) numberEntries(list, (at) => of[at]);
    this.#rows = LISTS.flatMap(({ list, symbol, of }) => of.map((n, at) => {
      const kind = { field: `${list}[${at}]`, id: `${list.replace(".", "-")}-${n}`, key: list, n, symbol: symbol + subscript(n), role: "secondary" };
      const row = new NumberRow(kind, drafts, (value) => put(list, at, value));
      return { row, read: (/** @type {Document} */ document) => listOf(document, list).numbers[at] };
    }));
    const mass = new NumberRow({ field: "bodies.mass", symbol: "m₂", role: "secondary" }, drafts, (value) =>
      store.update((state) => edited(state, "gear-train", ({ bodies }) => ({ bodies: /** @type {Document["bodies"]} */ ({ ...bodies, mass: value }) }))));
    this.#rows.push({ row: mass, read: ({ bodies }) => bodies?.mass ?? 0 });
    const content = this.#rows.map(({ row }) => row.element);
    section("gear-train", "bodies.heading", "bodies", [make("details", { id: "train-bodies" }, [make("summary", { "data-t": "bodies.show" }), ...content])]);
  }

  /** @param {import("assur/kinds/gear-train/drives.js").Snapshot} snapshot */
  render({ state: { document }, words, problems }) {
    const wrong = new Set(problems.map(({ field }) => field));
    if (this.#shown.same(document.magnets, document.bodies, words, ...wrong)) return;
    for (const { row, read } of this.#rows) row.show(read(document), words, wrong.has(row.field));
  }
}

/**
 * @param {Document} document
 * @param {string} list such as `bodies.inertia`
 */
function listOf(document, list) {
  const [group, part] = /** @type {["magnets" | "bodies", string]} */ (list.split("."));
  const lists = /** @type {Readonly<Record<string, readonly number[]>>} */ (/** @type {unknown} */ (document[group]));
  return { group, part, numbers: lists[part] ?? [] };
}
