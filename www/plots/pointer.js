// Pointer on the plots: a click or drag moves the driver, hovering shows values, a press on a title or a double click
// makes one plot large.
import { setData } from "assur/core/dom.js";
import { inputAt } from "assur/plots/against.js";
import { angleAt } from "assur/plots/panel.js";
import { withView } from "assur/state/state.js";

/** Greatest movement of a finger that does not count as a drag, in pixels. */
const SLOP = 6;

/** Greatest distance beyond the ends of the axis at which the pointer still acts on the plots, in pixels. */
const BEYOND = 16;

/** Free strip around a title that belongs to it, in pixels. */
const AROUND = 3;

/** Longest time between the presses of a double click, in milliseconds. */
const TWICE = 300;

/** Values of the view's field `only` that show a single plot, by the order of its derivative. */
const ALONE = Object.freeze(/** @type {const} */ (["value", "first", "second"]));

export class ChartPointer {
  #canvas;
  #chart;
  #cursor;
  #drive;
  #model;
  #store;
  /** @type {{ id: number, x: number, y: number, driving: boolean } | null} the pressed pointer */
  #held = null;
  /** Whether the last press was on a title, and when it was. */
  #titled = false;
  #pressed = -Infinity;

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {{ hover(input: number | null): void }} cursor
   * @param {import("assur/app/page.js").Page} page
   */
  constructor(canvas, cursor, page) {
    const { chart, model } = page;
    this.#canvas = canvas;
    this.#chart = chart;
    this.#cursor = cursor;
    this.#model = model;
    this.#store = page.store;
    this.#drive = (/** @type {number} */ input) => {
      const { coordinate } = model;
      page.drive(Math.min(coordinate.inputShown(input), coordinate.last(coordinate.of(page.store.get()))));
    };
    canvas.addEventListener("pointerdown", (event) => this.#down(event));
    canvas.addEventListener("pointermove", (event) => this.#move(event));
    canvas.addEventListener("pointerup", (event) => this.#up(event));
    canvas.addEventListener("pointercancel", () => this.#leave());
    canvas.addEventListener("pointerleave", () => this.#leave());
    canvas.addEventListener("click", (event) => this.#titled && event.detail <= 1 && this.#alone(event));
    canvas.addEventListener("dblclick", (event) => this.#titled || this.#alone(event));
  }

  /**
   * @param {{ clientX: number, clientY: number }} event
   * @returns {boolean} whether the pointer is on the title of a plot
   */
  #onTitle({ clientX, clientY }) {
    const { left, top } = this.#canvas.getBoundingClientRect();
    const [x, y] = [clientX - left, clientY - top];
    return this.#chart.titles.some((title) => x >= title.left && x <= title.right && y >= title.top - AROUND && y <= title.bottom + AROUND);
  }

  /**
   * Shows only the plot under the pointer, or all plots again.
   * @param {MouseEvent} event
   */
  #alone({ clientY }) {
    const y = clientY - this.#canvas.getBoundingClientRect().top;
    const { panels } = this.#chart;
    const plot = panels.find(({ top, height }) => y <= top + height) ?? panels.at(-1);
    if (plot) this.#store.update((state) => withView(state, { only: state.view.only === "all" ? ALONE[plot.order] : "all" }));
  }

  /** @param {PointerEvent} event */
  #down(event) {
    // The second press of a double click counts as on the title if the first was, although the title may have moved.
    if (event.timeStamp - this.#pressed > TWICE) this.#titled = this.#onTitle(event);
    this.#pressed = event.timeStamp;
    if (this.#titled) return;
    if (this.#held || event.button !== 0 || this.#angle(event, BEYOND) === null) return;
    // A finger may be about to scroll the page: it moves the driver only when it moves sideways or is lifted.
    const driving = event.pointerType !== "touch";
    this.#held = { id: event.pointerId, x: event.clientX, y: event.clientY, driving };
    this.#hover(null);
    if (!driving) return;
    this.#canvas.setPointerCapture(event.pointerId);
    this.#driveTo(event);
  }

  /** @param {PointerEvent} event */
  #move(event) {
    const held = this.#held;
    if (!held) {
      const titled = this.#onTitle(event);
      setData(this.#canvas, "titled", String(titled));
      if (event.pointerType !== "touch") this.#hover(titled ? null : this.#angle(event, BEYOND));
      return;
    }
    if (event.pointerId !== held.id) return;
    const aside = Math.abs(event.clientX - held.x);
    if (!held.driving && aside > SLOP && aside > Math.abs(event.clientY - held.y)) {
      held.driving = true;
      this.#canvas.setPointerCapture(event.pointerId);
    }
    if (held.driving) this.#driveTo(event);
  }

  /** @param {PointerEvent} event */
  #up(event) {
    if (event.pointerId !== this.#held?.id) return;
    this.#driveTo(event);
    this.#held = null;
  }

  #leave() {
    this.#held = null;
    this.#hover(null);
  }

  /** @param {PointerEvent} event */
  #driveTo(event) {
    const input = this.#angle(event, Infinity);
    if (input !== null) this.#drive(input);
  }

  /** @param {number | null} input */
  #hover(input) {
    setData(this.#canvas, "hover", input === null ? "" : String(this.#model.coordinate.inputShown(input)));
    this.#cursor.hover(input);
  }

  /**
   * @param {PointerEvent} event
   * @param {number} beyond
   * @returns {number | null} the input under the pointer; null if no plot is within `beyond` pixels
   */
  #angle({ clientX, clientY }, beyond) {
    const { left: x, top: y } = this.#canvas.getBoundingClientRect();
    const { panels, against } = this.#chart;
    const { coordinate } = this.#model;
    if (against) return inputAt(against, clientX - x, clientY - y, beyond, coordinate.input(coordinate.of(this.#store.get())));
    const [panel] = panels;
    if (!panel) return null;
    const left = clientX - x;
    if (left < panel.left - beyond || left > panel.left + panel.width + beyond) return null;
    return angleAt(panel, left);
  }
}
