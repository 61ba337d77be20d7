// A list of the document, shown in the rail: a card for each entry, and buttons that add and remove an entry.
import { make } from "assur/core/dom.js";
import { numberEntries } from "assur/core/names.js";
import { edited } from "assur/state/state.js";

/**
 * @typedef {import("assur/state/drafts.js").Drafts} Drafts
 * @typedef {import("assur/state/state.js").Kind} Kind
 */

/**
 * @template {Kind} K
 * @typedef {import("assur/state/model.js").OwnSnapshot<K>} Snapshot
 */

/**
 * @template {Kind} K
 * @typedef {import("assur/state/state.js").Documents[K]} Documents
 */

/**
 * @template {Kind} K
 * @template E
 * @typedef {(entry: E, snapshot: Snapshot<K>, wrong: ReadonlySet<string | undefined>) => void} Show
 */

/**
 * @template {Kind} K
 * @template E
 * @typedef {(index: number, put: (change: Partial<E>) => void, drafts: Drafts, remove: HTMLButtonElement) => { lines: HTMLElement[], show: Show<K, E> }} Build
 */

/**
 * @template {Kind} K
 * @template E
 * @typedef {Readonly<{
 *   kind: K,
 *   name: string & keyof Documents<K>,
 *   first: number,
 *   least: number,
 *   most: number,
 *   written: (number: number) => string,
 *   words: Readonly<{ add: string, remove: string }>,
 *   build: Build<K, E>,
 *   another: (snapshot: Snapshot<K>) => E,
 *   beside?: (document: Documents<K>) => Partial<Documents<K>>,
 *   without?: (index: number, document: Documents<K>) => Partial<Documents<K>>,
 * }>} ListKind
 * A list in the documents of one kind. `name`: field of the list. `first`: the number shown on the first entry
 * (wheels of a mixer start at 5). `least`, `most`: limits of the number of entries. `written`: writes the number shown
 * on an entry. `words`: keys of the names of the buttons. `build`: makes the card of an entry. `another`: makes an
 * entry to be added. `beside`: other fields that are changed with an added entry. `without`: needed if removing an entry changes other fields of the document too; gives all
 * changed fields, including the list.
 */

/**
 * @template {Kind} K
 * @template E
 */
export class CardList {
  #kind;
  #store;
  #drafts;
  /** Button that adds an entry; disabled if the list has its greatest number of entries. */
  add;
  /** Element with the cards, whose id is the name of the list. */
  cards;
  /** @type {{ show: Show<K, E>, element: HTMLElement, remove: HTMLButtonElement }[]} */
  #cards = [];
  /** @type {Snapshot<K> | null} */
  #snapshot = null;

  /**
   * @param {ListKind<K, E>} kind
   * @param {Pick<import("assur/app/page.js").Page, "store" | "drafts">} page
   */
  constructor(kind, { store, drafts }) {
    const { name, first, written, words, another, beside } = kind;
    numberEntries(name, (index) => written(index + first));
    this.#kind = kind;
    this.#store = store;
    this.#drafts = drafts;
    this.cards = make("div", { id: name });
    this.add = make("button", { id: `${name}-add`, class: "control add", type: "button", "data-t": words.add });
    this.add.addEventListener("click", () => {
      const snapshot = this.#snapshot;
      if (snapshot) this.#change((document) => ({ ...beside?.(document), ...this.#with(document, (entries) => [...entries, another(snapshot)]) }));
    });
  }

  /**
   * @param {Snapshot<K>} snapshot
   * @param {ReadonlySet<string | undefined>} wrong fields with a problem
   */
  show(snapshot, wrong) {
    this.#snapshot = snapshot;
    const entries = this.#of(/** @type {Documents<K>} */ (snapshot.state.document));
    const { least, most } = this.#kind;
    while (this.#cards.length < entries.length) {
      const card = this.#card(this.#cards.length);
      this.#cards.push(card);
      this.cards.append(card.element);
      snapshot.words.fill(card.element);
    }
    const focused = document.activeElement;
    for (const [index, card] of this.#cards.entries()) {
      card.element.hidden = index >= entries.length;
      card.remove.hidden = entries.length <= least;
      if (entries[index]) card.show(entries[index], snapshot, wrong);
    }
    this.add.disabled = entries.length >= most;
    // If a button with the focus disappears, another button gets the focus.
    if (focused === this.add && this.add.disabled) this.#cards[entries.length - 1].remove.focus();
    if (this.#cards.some(({ remove }) => remove === focused && remove.offsetParent === null)) this.add.focus();
  }

  /** @param {number} index */
  #card(index) {
    const { name, first, written, words, build, without } = this.#kind;
    const number = index + first;
    const remove = make("button", {
      id: `${name}-remove-${number}`,
      type: "button",
      class: "control icon",
      "data-t-label": words.remove,
      "data-t-title": words.remove,
      "data-n": written(number),
      onclick: () => this.#change((document) => drop(index, document)),
    }, ["×"]);
    const drop = without ?? ((_, document) => this.#with(document, (entries) => entries.filter((_, at) => at !== index)));
    const put = (/** @type {Partial<E>} */ change) => this.#edit((document) => (
      this.#with(document, (entries) => entries.map((entry, at) => (at === index ? merged(entry, change) : entry)))
    ));
    const { lines, show } = build(index, put, this.#drafts, remove);
    return { element: make("div", { class: "card" }, lines), remove, show };
  }

  /** @param {Documents<K>} document */
  #of(document) {
    return /** @type {readonly E[]} */ (/** @type {unknown} */ (document[this.#kind.name]));
  }

  /**
   * @param {Documents<K>} document
   * @param {(entries: readonly E[]) => readonly E[]} change
   * @returns {Partial<Documents<K>>} the field of the document with the changed list
   */
  #with(document, change) {
    return /** @type {Partial<Documents<K>>} */ ({ [this.#kind.name]: change(this.#of(document)) });
  }

  /** @param {(document: Documents<K>) => Partial<Documents<K>>} change change that adds or removes an entry */
  #change(change) {
    this.#drafts.dropAll([this.#kind.name]);
    this.#edit(change);
  }

  /** @param {(document: Documents<K>) => Partial<Documents<K>>} change */
  #edit(change) {
    this.#store.update((state) => edited(state, this.#kind.kind, change));
  }
}

/**
 * @template E
 * @param {E} entry
 * @param {Partial<E>} change an entry that is a list is changed as a whole
 * @returns {E}
 */
function merged(entry, change) {
  return /** @type {E} */ (Array.isArray(change) ? change : { ...entry, ...change });
}
