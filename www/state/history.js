// Undo and redo: a list of what the mechanism was. A step is what a person takes for one.
import { whenReleased } from "assur/core/released.js";
import { partOf } from "assur/state/drafts.js";
import { FURTHER, UNDONE, furtherOf, withFurther, withMechanism, withView } from "assur/state/state.js";

/**
 * @typedef {import("assur/state/state.js").State} State
 * @typedef {Readonly<{ kind: State["kind"], document: State["document"], further: import("assur/state/state.js").Further, shown: Partial<State["view"]> }>} Moment
 * What is undone. Where the crank stands, playing, speed and language are not: they lose nothing.
 */

/**
 * Each of these ends a step; what changes between two of them (a drag, a typed number) is one. A drag ends with the next
 * press: the last movement of a slider may be told after the finger is lifted.
 */
const ENDS = Object.freeze(["change", "focusout", "click", "pointerdown"]);

/** More steps than anybody goes back. */
const MOST = 1000;
/** Characters of all images in them: each may have two million. */
const IMAGES = 20_000_000;

export class History {
  /** @type {Moment[]} */
  #past = [];
  /** @type {Moment[]} */
  #future = [];
  /** Whether what changes now belongs to the step before. */
  #open = false;
  #walking = false;
  /** @type {readonly string[]} fields whose number was rejected while the last step was made: it is undone with the step */
  #within = [];
  /** Whether a pointer has changed, or changes, something. */
  #pointed = false;
  /** @type {HTMLInputElement | null} the slider under a pressed pointer */
  #slid = null;
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
      if (this.#walking || same(moment(state), moment(previous))) return;
      if (!this.#open) this.#add(moment(previous));
      this.#future = [];
      this.#open = true;
    });
    for (const end of ENDS) {
      addEventListener(end, ({ target }) => {
        const slider = target instanceof HTMLInputElement && target.type === "range" ? target : null;
        // A slider moved by keys changes at every press: they are one step until the focus leaves it.
        const pressed = end === "change" && slider;
        if (end === "pointerdown") {
          this.#pointed = true;
          this.#slid = slider;
        }
        // Firefox moves a slider that is pressed before the focus leaves what had it.
        const left = this.#slid !== null && slider !== this.#slid;
        if (!pressed && !left) this.close();
      }, true);
    }
    whenReleased(() => (this.#slid = null));
    // Keys after a drag are another step.
    addEventListener("keydown", () => {
      if (this.#pointed) this.close();
      this.#pointed = false;
    }, true);
  }

  get canUndo() {
    return this.#past.length > 0 || this.#rejected().length > 0;
  }

  get canRedo() {
    return this.#future.length > 0;
  }

  /** Whether a change of now is one of undo or redo. */
  get walking() {
    return this.#walking;
  }

  /** What changes next is a step of its own. */
  close() {
    if (this.#open) this.#within = this.#rejected();
    this.#open = false;
  }

  /** @returns {string[]} fields of the document in which a number stands that was rejected */
  #rejected() {
    const { document } = this.#store.get();
    return this.#drafts.fields().filter((field) => partOf(field) in document);
  }

  /** What changes next belongs to the step before. */
  join() {
    this.#open = true;
  }

  /**
   * A change that is a step of its own, whatever is being edited.
   * @param {() => void} change
   */
  step(change) {
    this.close();
    this.#drafts.dropAll(this.#drafts.fields());
    change();
    this.close();
  }

  /** @param {Moment} one that can be gone back to; the oldest are dropped */
  #add(one) {
    this.#past.push(one);
    while (this.#past.length > MOST || imagesOf(this.#past) > IMAGES) this.#past.shift();
  }

  /** A number that was rejected after the last step is undone first. */
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
   * @param {Moment[]} from
   * @param {Moment[]} to
   */
  #walk(from, to) {
    this.close();
    const next = from.pop();
    if (!next) return;
    const state = this.#store.get();
    to.push(moment(state));
    this.#drafts.dropAll(Object.keys(next.document));
    this.#walking = true;
    try {
      this.#store.update((now) => withView(withFurther(withMechanism(now, next.kind, next.document), next.further), next.shown));
    } finally {
      this.#walking = false;
    }
  }
}

/**
 * @param {State} state
 * @returns {Moment}
 */
function moment(state) {
  const { kind, document, view } = state;
  return { kind, document, further: furtherOf(state), shown: Object.fromEntries(UNDONE.map((name) => [name, view[name]])) };
}

/**
 * @param {readonly Moment[]} moments
 * @returns {number} characters of all images in them: steps that have the same picture share its image
 */
function imagesOf(moments) {
  const images = new Set(moments.map(({ further }) => further.picture?.image ?? ""));
  return [...images].reduce((sum, { length }) => sum + length, 0);
}

/**
 * @param {Moment} one
 * @param {Moment} other
 */
function same(one, other) {
  const further = FURTHER.every((name) => one.further[name] === other.further[name]);
  return one.document === other.document && further && UNDONE.every((name) => one.shown[name] === other.shown[name]);
}
