// The status line: kind and properties of the mechanism, one entry for each.
import { writeReadout } from "assur/controls/readout.js";
import { cellOf, idOfOutput } from "assur/controls/shown.js";
import { byId, make, setData, write } from "assur/core/dom.js";

/** @typedef {{ text: string, value?: number, nodes?: readonly (Node | string)[] }} Said content of an entry. `nodes`: the text with marks */

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
  /** @type {{ item: Item<S>, said: Said | null, entry: HTMLElement, heading: HTMLElement, output: HTMLElement }[]} */
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
    this.#entries = items.map((item) => {
      const heading = make("dt");
      const output = make("dd", { id: idOfOutput(item.name) });
      const entry = make("div", { class: `entry ${item.class ?? ""}`.trim(), "data-of": kind }, [heading, " ", output, " "]);
      this.#list.append(entry);
      return { item, said: null, entry, heading, output };
    });
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
    const rows = [];
    for (const one of this.#entries) {
      const { item: { name, title: key, n = coordinate.symbol, reveals, late: slow = false, say }, entry, heading, output } = one;
      if (slow === late) one.said = say(snapshot);
      const { text = "", value, nodes } = one.said ?? {};
      const title = words.text(key, { n });
      /** @type {import("assur/controls/shown.js").Cell} */
      const cell = cellOf(name, { title, text, value }, snapshot, reveals);
      entry.hidden = text === "";
      write(heading, title);
      writeReadout(output, cell);
      if (nodes && !cell.asked) output.replaceChildren(...nodes);
      if (text !== "") rows.push({ title, cells: [cell] });
    }
    // Late entries may come after a document of another kind.
    if (this.#page.model.kind === this.#kind) this.#page.shown.put("status", rows);
  }
}
