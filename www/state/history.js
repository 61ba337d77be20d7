// Undo and redo: lists of earlier and of undone states. One step is one drag, one press, one held key, or all typing into one field.
import { whenReleased } from "assur/core/released.js";
import { isTyped } from "assur/core/typed.js";
import { partOf } from "assur/state/drafts.js";
import { EXTRAS, UNDOABLE_VIEW, extrasOf, withExtras, withMechanism, withView } from "assur/state/state.js";

/**
 * @typedef {import("assur/state/state.js").State} State
 * @typedef {Readonly<{ kind: State["kind"], document: State["document"], extras: import("assur/state/state.js").Extras, shown: Partial<State["view"]> }>} UndoEntry
 * What undo restores. Input, playing, speed and language are not undone, because nothing is lost when they change.
 */

/**
 * Events that end a step, unless a pointer or a key is held down: a typed number is entered, a control has changed. While a pointer or key
 * is down, these events belong to the step: a slider reports each repetition of a held key as a change, and in Firefox the focus leaves the
 * previous field only after a pressed slider has moved.
 */
const ENDS = Object.freeze(["change", "focusout", "click"]);

/** Limit of the number of steps. */
const MAX_STEPS = 1000;
/** Limit of the total length of all images in the steps, in characters; one image may have two million. */
const IMAGES = 20_000_000;

export class History {
  /** @type {UndoEntry[]} */
  #past = [];
  /** @type {UndoEntry[]} */
  #future = [];
  /** Whether the next change belongs to the previous step. */
  #open = false;
  #walking = false;
  /** @type {readonly string[]} fields with a number rejected during the last step; undoing the step drops these numbers */
  #within = [];
  /** @type {"pointer" | "key" | null} what the reader holds down */
  #held = null;
  #store;
  #drafts;

  /**
   * @param {import("assur/state/store.js").Store<State>} store
   * @param {import("assur/state/drafts.js").Drafts} drafts
   */
  constructor(store, drafts) {
    this.#store = store;
    this.#drafts = drafts;
    store.subscribe((state, previous) => {
      if (this.#walking || same(entryOf(state), entryOf(previous))) return;
      if (!this.#open) this.#add(entryOf(previous));
      this.#future = [];
      this.#open = true;
    });
    addEventListener("pointerdown", () => this.#hold("pointer"), true);
    // A slider may report its last movement after the release of the pointer, so the release does not end the step.
    whenReleased(() => (this.#held = null));
    // All keys typed into a text field are one step, until the field is left. A key pressed during a drag only changes the drag.
    addEventListener("keydown", ({ repeat, target }) => {
      if (this.#held === "pointer") return;
      if (isTyped(target)) this.#held = null;
      else if (repeat) this.#held = "key";
      else this.#hold("key");
    }, true);
    addEventListener("keyup", () => {
      if (this.#held !== "key") return;
      this.#held = null;
      this.close();
    }, true);
    for (const end of ENDS) {
      addEventListener(end, () => {
        if (!this.#held) this.close();
      }, true);
    }
  }

  /** @param {"pointer" | "key"} held what the reader has just pressed, which begins a step */
  #hold(held) {
    this.close();
    this.#held = held;
  }

  get canUndo() {
    return this.#past.length > 0 || this.#rejected().length > 0;
  }

  get canRedo() {
    return this.#future.length > 0;
  }

  /** Whether undo or redo is making the current change. */
  get walking() {
    return this.#walking;
  }

  /** Ends the step: the next change begins a new one. */
  close() {
    if (this.#open) this.#within = this.#rejected();
    this.#open = false;
  }

  /** @returns {string[]} fields of the document with a rejected number */
  #rejected() {
    const { document } = this.#store.get();
    return this.#drafts.fields().filter((field) => partOf(field) in document);
  }

  /** Joins the next change to the previous step. */
  join() {
    this.#open = true;
  }

  /**
   * Makes a change as a step of its own. The previous step ends, and all rejected numbers are dropped.
   * @param {() => void} change
   */
  step(change) {
    this.close();
    this.#drafts.dropAll(this.#drafts.fields());
    change();
    this.close();
  }

  /** @param {UndoEntry} entry to return to; beyond a limit, the oldest entries are dropped */
  #add(entry) {
    this.#past.push(entry);
    while (this.#past.length > MAX_STEPS || imagesOf(this.#past) > IMAGES) this.#past.shift();
  }

  /** Drops the numbers that were rejected after the last step or, if there are none, undoes the step. */
  undo() {
    this.close();
    const later = this.#rejected().filter((field) => !this.#within.includes(field));
    if (later.length > 0) this.#drafts.dropAll(later);
    else this.#walk(this.#past, this.#future);
  }

  redo() {
    this.#walk(this.#future, this.#past);
  }

  /**
   * @param {UndoEntry[]} from
   * @param {UndoEntry[]} to
   */
  #walk(from, to) {
    this.close();
    const next = from.pop();
    if (!next) return;
    const state = this.#store.get();
    to.push(entryOf(state));
    this.#drafts.dropAll(Object.keys(next.document));
    this.#walking = true;
    try {
      this.#store.update((now) => withView(withExtras(withMechanism(now, next.kind, next.document), next.extras), next.shown));
    } finally {
      this.#walking = false;
    }
  }
}

/**
 * @param {State} state
 * @returns {UndoEntry}
 */
function entryOf(state) {
  const { kind, document, view } = state;
  return { kind, document, extras: extrasOf(state), shown: Object.fromEntries(UNDOABLE_VIEW.map((name) => [name, view[name]])) };
}

/**
 * @param {readonly UndoEntry[]} entries
 * @returns {number} total length of the images in the entries, in characters; equal images count once
 */
function imagesOf(entries) {
  const images = new Set(entries.map(({ extras }) => extras.picture?.image ?? ""));
  return [...images].reduce((sum, { length }) => sum + length, 0);
}

/**
 * @param {UndoEntry} one
 * @param {UndoEntry} other
 */
function same(one, other) {
  const extras = EXTRAS.every((name) => one.extras[name] === other.extras[name]);
  return one.document === other.document && extras && UNDOABLE_VIEW.every((name) => one.shown[name] === other.shown[name]);
}
