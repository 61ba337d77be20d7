// Width of the column of plots: its edge is dragged, folded away by a press, and moved by keys; the browser keeps the width.
import { byId, setData } from "assur/core/dom.js";
import { keep, kept } from "assur/state/storage.js";

/** Name of the kept width, as a share of the window's width. */
const NAME = "plots";

/** Greatest movement that is a press and no drag, in pixels. */
const SLOP = 4;

/** Width below which a drag folds the column, in pixels. */
const LEAST = 180;

/** Change of the width by an arrow key, in pixels. */
const STEP = 24;

/** Widths at Home and End: the style sheet limits them. */
const ENDS = Object.freeze({ Home: 1, End: 1e5 });

export class PlotColumn {
  #app = byId("app", HTMLElement);
  #edge = byId("plots-edge", HTMLElement);
  #column = byId("plot-column", HTMLElement);
  /** @type {{ id: number, x: number, moved: boolean } | null} the pressed pointer */
  #held = null;

  constructor() {
    this.#share(Number(kept(NAME)) || 0);
    const edge = this.#edge;
    edge.addEventListener("pointerdown", (event) => this.#down(event));
    edge.addEventListener("pointermove", (event) => this.#move(event));
    edge.addEventListener("pointerup", (event) => this.#up(event));
    edge.addEventListener("pointercancel", () => (this.#held = null));
    edge.addEventListener("keydown", (event) => this.#key(event));
    new ResizeObserver(() => this.#say()).observe(this.#column);
  }

  get #folded() {
    return this.#app.dataset.plots === "folded";
  }

  /** @param {boolean} folded */
  #fold(folded) {
    setData(this.#app, "plots", folded ? "folded" : "open");
  }

  /** @param {number} share of the window's width; 0 for the usual width */
  #share(share) {
    if (share > 0) this.#app.style.setProperty("--plots", `${(100 * share).toFixed(2)}vw`);
    else this.#app.style.removeProperty("--plots");
  }

  /** @param {number} width in pixels */
  #widen(width) {
    this.#fold(false);
    this.#share(width / innerWidth);
    // The style sheet limits the width: what is kept is what is seen.
    this.#share(this.#column.offsetWidth / innerWidth);
  }

  #keep() {
    if (!this.#folded) keep(NAME, String(this.#column.offsetWidth / innerWidth));
  }

  /** Tells screen readers the width, as a percentage of the window's. */
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
    const width = this.#app.getBoundingClientRect().right - clientX;
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
    else if (key === "ArrowLeft") this.#widen(width + STEP);
    else if (key === "ArrowRight") this.#widen(Math.max(width - STEP, 1));
    else if (key === "Home" || key === "End") this.#widen(ENDS[key]);
    else return;
    event.preventDefault();
    this.#keep();
  }
}
