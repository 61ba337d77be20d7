// The mechanism of a lesson's step: the one last opened by a button of the step, as changed by the step's controls.
import { digest } from "assur/lesson/chance.js";
import { READERS } from "assur/lesson/steps.js";

/**
 * @typedef {import("assur/state/state.js").State} State
 * @typedef {import("assur/lesson/panel.js").Shown} Shown
 */

/** Events that may change a document. The last event's target decides whether a control of the step made the change. */
const ACTS = Object.freeze(["pointerdown", "pointermove", "pointerup", "click", "input", "change", "keydown", "wheel", "paste", "drop", "hashchange"]);

export class OwnMechanism {
  #page;
  /** @type {readonly Shown[]} */
  #shows = [];
  /** @type {WeakSet<State["document"]>} documents of the step, compared by identity: undo and redo bring back the same objects */
  #own = new WeakSet();
  /** @type {State | null} the last state with a document of the step */
  #last = null;
  #opening = false;
  /** Whether the reader's last action was on a control of the step. */
  #acted = false;
  #ended = new AbortController();

  /**
   * @param {Pick<import("assur/app/page.js").Page, "store" | "history" | "choose">} page
   * @param {HTMLElement} controls element with the controls of the step
   */
  constructor(page, controls) {
    this.#page = page;
    const unsubscribe = page.store.subscribe((next, previous) => this.#follow(next, previous));
    const { signal } = this.#ended;
    signal.addEventListener("abort", unsubscribe);
    const note = (/** @type {Event} */ { target }) => (this.#acted = target instanceof Node && controls.contains(target));
    for (const act of ACTS) addEventListener(act, note, { capture: true, signal });
  }

  /** Stops following the page. */
  close() {
    this.#ended.abort();
  }

  /**
   * Begins a step. The page may already show its mechanism, after a reload or from a link.
   * @param {readonly Shown[]} shows buttons of the step
   * @param {string} kept digest of the step's mechanism as it was when the page was left
   */
  begin(shows, kept = "") {
    this.#shows = shows;
    this.#own = new WeakSet();
    this.#last = null;
    const state = this.#page.store.get();
    if ((kept !== "" && digest(state.document) === kept) || shows.some((one) => one.opened?.(state))) this.#add(state);
  }

  /** Digest of the step's last mechanism, empty if none has been shown. */
  get digest() {
    return this.#last ? digest(this.#last.document) : "";
  }

  /**
   * Shows a mechanism of the step.
   * @param {Shown["open"]} open
   * @param {Partial<State["view"]>} [view] further fields of the view
   */
  open(open, view) {
    const { store } = this.#page;
    const before = store.get().document;
    this.#opening = true;
    try {
      open(view);
    } finally {
      this.#opening = false;
    }
    const state = store.get();
    if (state.document !== before || this.#shows.some((one) => one.opened?.(state))) this.#add(state);
  }

  /** Whether the page shows the step's mechanism. A step without a mechanism accepts every mechanism. */
  get there() {
    return this.#shows.length === 0 || this.#own.has(this.#page.store.get().document);
  }

  /** Shows the step's mechanism again. A single undo reverts this. */
  bringBack() {
    const last = this.#last;
    if (!last) {
      this.open(this.#shows[0].open);
      return;
    }
    const look = Object.fromEntries(Object.entries(last.view).filter(([key]) => !READERS.includes(key)));
    this.#page.choose(last.kind, last.document, [], () => look);
  }

  /**
   * @param {State} next
   * @param {State} previous
   */
  #follow(next, previous) {
    const changed = next.kind === previous.kind && this.#acted && !this.#page.history.walking && this.#own.has(previous.document);
    if (this.#opening || changed || this.#own.has(next.document)) this.#add(next);
  }

  /** @param {State} state */
  #add(state) {
    this.#own.add(state.document);
    this.#last = state;
  }
}
