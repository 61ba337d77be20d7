// A column beside the drawing. A drag of its edge or the arrow keys change its width, and a press folds it. The browser keeps the width.
import { byId, setData } from "assur/core/dom.js";
import { keep, kept } from "assur/state/storage.js";

/** Greatest movement that is a press and no drag, in pixels. */
const SLOP = 4;

/** Width below which a drag folds the column, in pixels. */
const LEAST = 180;

/** Change of the width by an arrow key, in pixels. */
const STEP = 24;

/** Widths that the keys Home and End ask for, in pixels; the style sheet limits them. */
const ENDS = Object.freeze({ Home: 1, End: 1e5 });

export class Column {
  #app = byId("app", HTMLElement);
  #name;
  #left;
  #edge;
  #column;
  /** @type {{ id: number, x: number, moved: boolean } | null} the pressed pointer */
  #held = null;

  /**
   * @param {"rail" | "plots"} name of the kept width, of the custom property and of the attribute in the style sheet
   * @param {string} id of the column
   * @param {"left" | "right"} side of the page at which the column stands
   */
  constructor(name, id, side) {
    this.#name = name;
    this.#left = side === "left";
    this.#column = byId(id, HTMLElement);
    const edge = byId(`${name}-edge`, HTMLElement);
    this.#edge = edge;
    this.#share(Number(kept(name)) || 0);
    edge.addEventListener("pointerdown", (event) => this.#down(event));
    edge.addEventListener("pointermove", (event) => this.#move(event));
    edge.addEventListener("pointerup", (event) => this.#up(event));
    edge.addEventListener("pointercancel", () => (this.#held = null));
    edge.addEventListener("keydown", (event) => this.#key(event));
    new ResizeObserver(() => this.#say()).observe(this.#column);
  }

  get #folded() {
    return this.#app.dataset[`${this.#name}Column`] === "folded";
  }

  /** @param {boolean} folded */
  #fold(folded) {
    setData(this.#app, `${this.#name}Column`, folded ? "folded" : "open");
  }

  /** @param {number} share of the window's width; 0 for the usual width */
  #share(share) {
    const property = `--${this.#name}`;
    if (share > 0) this.#app.style.setProperty(property, `${(100 * share).toFixed(2)}vw`);
    else this.#app.style.removeProperty(property);
  }

  /** @param {number} width in pixels */
  #widen(width) {
    this.#fold(false);
    this.#share(width / innerWidth);
    // The style sheet may have limited the width: the share is that of the actual width.
    this.#share(this.#column.offsetWidth / innerWidth);
  }

  #keep() {
    if (!this.#folded) keep(this.#name, String(this.#column.offsetWidth / innerWidth));
  }

  /** Gives screen readers the width, as a percentage of the window's. */
  #say() {
    this.#edge.ariaValueNow = String(Math.round((100 * this.#column.offsetWidth) / innerWidth));
  }

  /** @param {PointerEvent} event */
  #down(event) {
    if (this.#held || event.button !== 0) return;
    this.#held = { id: event.pointerId, x: event.clientX, moved: false };
    this.#edge.setPointerCapture(event.pointerId);
  }

  /** @param {PointerEvent} event */
  #move({ pointerId, clientX }) {
    const held = this.#held;
    if (pointerId !== held?.id) return;
    held.moved ||= Math.abs(clientX - held.x) > SLOP;
    if (!held.moved) return;
    const { left, right } = this.#app.getBoundingClientRect();
    const width = this.#left ? clientX - left : right - clientX;
    if (width < LEAST) this.#fold(true);
    else this.#widen(width);
  }

  /** @param {PointerEvent} event */
  #up({ pointerId }) {
    const held = this.#held;
    if (pointerId !== held?.id) return;
    this.#held = null;
    if (held.moved) this.#keep();
    else this.#fold(!this.#folded);
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    const { key } = event;
    const width = this.#folded ? 0 : this.#column.offsetWidth;
    if (key === "Enter") this.#fold(!this.#folded);
    else if (key === "ArrowLeft" || key === "ArrowRight") this.#widen(Math.max(width + ((key === "ArrowRight") === this.#left ? STEP : -STEP), 1));
    else if (key === "Home" || key === "End") this.#widen(ENDS[key]);
    else return;
    event.preventDefault();
    this.#keep();
  }
}
