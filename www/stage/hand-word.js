// Effect of a drag of the handle under the pointer, shown before and during the drag by a word and by the cursor.
import { byId, make, setData, write } from "assur/core/dom.js";
import { attempt } from "assur/core/problem.js";
import { Seen } from "assur/core/seen.js";
import { inputNow } from "assur/state/change.js";

/**
 * @typedef {import("assur/stage/view.js").Joint} Joint
 * @typedef {import("assur/stage/pointer.js").Pixel} Pixel
 * @typedef {"drives" | "lengths" | "pivot" | "traced"} Effect
 */

/** @type {Readonly<Record<Effect, string>>} keys of the words */
const WORDS = Object.freeze({ drives: "drag.drives", lengths: "drag.lengths", pivot: "drag.pivot", traced: "drag.traced" });

/** Distance of the word from the pointer, in pixels: for a mouse, and for a finger, which covers more. */
const AWAY = Object.freeze([18, 46]);

/**
 * Determines the effect of a drag of a handle: asks the engine for the change that a drag to the handle's present place would make.
 * @param {Pick<import("assur/app/page.js").Page, "engine" | "store" | "model">} page
 * @param {Pick<Joint, "name" | "x" | "y">} joint
 * @returns {Effect | null} null if the drag is refused, or if all handles of the mechanism have the same effect
 */
export function effectOf(page, { name, x, y }) {
  const { summary } = page.model;
  // If points of links cannot be traced, all handles have the same effect.
  if (summary.moves === null || !summary.traceable) return null;
  const { document } = page.store.get();
  const change = attempt(() => page.engine.simulator.drag(name, inputNow(page), x, y)).value;
  if (!change) return null;
  if (!change.document) return "drives";
  const [first, ...others] = Object.keys(change.document);
  if (first === "tracers" && others.length === 0) return "traced";
  return "frame" in document && Array.isArray(document.frame) && document.frame.includes(name) ? "pivot" : "lengths";
}

export class HandWord {
  #page;
  #canvas = byId("mechanism", HTMLCanvasElement);
  #word = make("span", { id: "hand-word", class: "hand-word", "aria-hidden": "true", hidden: "" });
  /** Name of the handle and the document for which the engine was asked. */
  #seen = new Seen();
  /** @type {Effect | null} */
  #effect = null;

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    this.#page = page;
    this.#canvas.after(this.#word);
  }

  /**
   * @param {Joint} joint handle under the pointer
   * @param {Pixel} at of the pointer
   * @param {boolean} isTouch
   */
  show(joint, at, isTouch) {
    if (!this.#seen.same(joint.name, this.#page.store.get().document)) this.#effect = effectOf(this.#page, joint);
    this.move(at, isTouch);
  }

  /**
   * Moves the word with the pointer. While a handle is dragged, its effect stays.
   * @param {Pixel} at
   * @param {boolean} isTouch
   */
  move(at, isTouch) {
    setData(this.#canvas, "drags", this.#effect ?? "");
    this.#word.hidden = this.#effect === null;
    if (!this.#effect) return;
    write(this.#word, this.#page.words.text(WORDS[this.#effect]));
    const away = AWAY[Number(isTouch)];
    const { width } = this.#page.mechanism.size;
    const left = at.x + away + this.#word.offsetWidth <= width ? at.x + away : at.x - away - this.#word.offsetWidth;
    this.#word.style.left = `${Math.max(left, 0)}px`;
    this.#word.style.top = `${Math.max(at.y - away - this.#word.offsetHeight, 0)}px`;
  }

  hide() {
    this.#seen = new Seen();
    setData(this.#canvas, "drags", "");
    this.#word.hidden = true;
  }
}
