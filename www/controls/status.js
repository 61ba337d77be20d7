// The status line: kind and properties of the mechanism, one entry for each.
import { readoutText } from "assur/controls/readout.js";
import { cellOf } from "assur/controls/shown.js";
import { byId, setData } from "assur/core/dom.js";
import { html, nothing, render } from "assur/core/html.js";

/** @typedef {{ text: string, value?: number, marked?: unknown }} Said content of an entry. `marked`: template of the text with its marks */

/** @typedef {{ words: import("assur/core/words.js").Words, revision: number, stale: boolean, withheld: ReadonlySet<string>, coordinate: import("assur/state/coordinate.js").Coordinate }} Needed */

/**
 * @template {Needed} S
 * @typedef {Readonly<{ name: string, title: string, n?: string, class?: string, late?: boolean, reveals?: RegExp, say: (snapshot: S) => Said | null }>} Item
 * `title`: key of the entry's title. `n`: text for {n} in the title, by default the input's symbol. `late`: whether
 * the content is slow to compute, and waits for a moment without changes. `reveals`: names of quantities, as lessons ask for
 * them, that the content gives away. `say`: gives the content; the entry is hidden if it is null or empty.
 */

/** Time without a change before late entries are computed, in milliseconds. */
const MOMENT = 150;

/** @template {Needed} S */
export class StatusLine {
  #list = byId("status", HTMLElement);
  /** Mark in the page after the entries; entries of other kinds of documents follow it. */
  #end = document.createTextNode("");
  /** @type {{ item: Item<S>, said: Said | null }[]} */
  #entries;
  #kind;
  #page;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #moment;
  #shown = "";
  /** @type {ReadonlySet<string> | null} */
  #withheld = null;

  /**
   * @param {string} kind of the documents that have the entries
   * @param {readonly Item<S>[]} items
   * @param {Pick<import("assur/app/page.js").Page, "model" | "shown">} page
   */
  constructor(kind, items, page) {
    this.#kind = kind;
    this.#page = page;
    this.#list.append(this.#end);
    this.#entries = items.map((item) => ({ item, said: null }));
  }

  /** @param {S} snapshot */
  render(snapshot) {
    const { words, revision, stale, withheld } = snapshot;
    setData(this.#list, "faded", String(stale));
    // After a refused state, the entries of the last mechanism stay.
    if (stale && this.#shown.endsWith(` ${words.lang}`)) return;
    const shown = `${revision} ${words.lang}`;
    if (shown === this.#shown && withheld === this.#withheld) return;
    this.#withheld = withheld;
    this.#shown = shown;
    this.#write(false, snapshot);
    clearTimeout(this.#moment);
    this.#moment = setTimeout(() => this.#write(true, snapshot), MOMENT);
  }

  /**
   * @param {boolean} late whether to compute the late entries or the others
   * @param {S} snapshot
   */
  #write(late, snapshot) {
    const { words, coordinate } = snapshot;
    /** @type {import("assur/controls/shown.js").Row[]} */
    const rows = [];
    const entries = this.#entries.map((one) => {
      const { name, title: key, n = coordinate.symbol, reveals, late: slow = false, say, class: tone = "" } = one.item;
      if (slow === late) one.said = say(snapshot);
      const { text = "", value, marked } = one.said ?? {};
      const title = words.text(key, { n });
      /** @type {import("assur/controls/shown.js").Cell} */
      const cell = cellOf(name, { title, text, value }, snapshot, reveals);
      if (text !== "") rows.push({ title, cells: [cell] });
      return html`<div class="entry ${tone}" data-of=${this.#kind} ?hidden=${text === ""}><dt>${title}</dt> <dd id=${cell.id} data-value=${cell.value ?? nothing} data-asked=${cell.asked ?? nothing}>${(!cell.asked && marked) || readoutText(cell)}</dd> </div>`;
    });
    render(entries, this.#list, { renderBefore: this.#end });
    // When late entries are written, a document of another kind may already be shown.
    if (this.#page.model.kind === this.#kind) this.#page.shown.put("status", rows);
  }
}
