// Pointer input on the drawing: dragging joints and traced points, panning by the empty paper, zooming with the wheel or two fingers.
import { byId, setData } from "assur/core/dom.js";
import { attempt } from "assur/core/problem.js";
import { HandWord } from "assur/stage/hand-word.js";
import { inputNow, take } from "assur/state/change.js";
import { TRACERS, withView } from "assur/state/state.js";

/**
 * @typedef {import("assur/stage/view.js").Joint} Joint
 * @typedef {import("assur/state/state.js").State} State
 * @typedef {{ x: number, y: number }} Pixel point of the canvas, in CSS pixels
 * @typedef {{ to(at: Pixel, free: boolean): void, end(): void }} Drag
 * @typedef {{
 *   hover(at: Pixel, event: PointerEvent): void, leave(): void, press(at: Pixel, event: PointerEvent): void,
 *   grab(at: Pixel, event: PointerEvent): Drag | null, dropped?(): void,
 * }} PointerTool tool that receives the pointer's actions instead of the joints. `dropped`: called when another tool, or none, takes its place
 */

/** Greatest distance at which a pointer takes hold of a joint, in pixels: for a mouse or pen, and for a finger. */
const PICK_DISTANCE = 18;
const FINGER_PICK_DISTANCE = 28;

/** Greatest movement of a pressed pointer that does not count as a drag, in pixels. */
const STILL = 4;

/** Zoom factor of one press of + or −. */
const STEP = 1.3;

/**
 * `WHEEL`: natural logarithm of the zoom factor for a pixel scrolled. `WHEEL_UNIT`: pixels in a pixel, a line and a
 * page, the units of a wheel event. `PINCHED`: factor by which a pinch on a touchpad counts more than scrolling.
 */
const WHEEL = 0.0015;
const WHEEL_UNIT = Object.freeze([1, 20, 400]);
const PINCHED = 6;

export class MechanismPointer {
  #page;
  #canvas;
  #view;
  #engine;
  #store;
  #model;
  /** @type {Map<number, Pixel>} pressed pointers */
  #pointers = new Map();
  /** @type {{ name: Joint["name"], pressed: boolean, dx: number, dy: number, from: Pixel } | null} the joint that is held. `pressed`: whether the
   * joint has an action for a press, and is not dragged yet; `dx`, `dy`: from the pointer to the joint; `from`: pixel of the press */
  #taken = null;
  /** Whether the next press places a traced point. */
  #tracing = false;
  #draw = byId("draw", HTMLButtonElement);
  #trace = byId("trace", HTMLButtonElement);
  #word;
  /** @type {PointerTool | null} the tool that receives the pointer's actions instead of the joints */
  #tool = null;
  /** @type {{ from: Pixel, still: boolean, drag: Drag | null } | null} the current press or drag of the tool */
  #work = null;

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {import("assur/app/page.js").Page} page
   */
  constructor(canvas, page) {
    const { mechanism: view, engine, store, model } = page;
    this.#page = page;
    this.#word = new HandWord(page);
    this.#canvas = canvas;
    this.#view = view;
    this.#engine = engine;
    this.#store = store;
    this.#model = model;
    canvas.addEventListener("pointerdown", (event) => this.#down(event));
    canvas.addEventListener("pointermove", (event) => this.#move(event));
    canvas.addEventListener("pointerup", (event) => this.#up(event));
    canvas.addEventListener("pointercancel", (event) => this.#up(event));
    canvas.addEventListener("pointerleave", () => {
      this.#show(this.#taken?.name ?? "");
      if (!this.#taken) this.#word.hide();
      this.#tool?.leave();
    });
    canvas.addEventListener("dblclick", () => this.#tool ?? view.fit());
    canvas.addEventListener("wheel", (event) => this.#wheel(event), { passive: false });
    // One finger scrolls the page unless it starts at a joint, a tool is in use or the drawing is zoomed. Two fingers
    // zoom.
    canvas.addEventListener("touchstart", (event) => this.#touch(event), { passive: false });
    byId("zoom-in", HTMLButtonElement).addEventListener("click", () => view.zoom(STEP));
    byId("zoom-out", HTMLButtonElement).addEventListener("click", () => view.zoom(1 / STEP));
    byId("zoom-fit", HTMLButtonElement).addEventListener("click", () => view.fit());
    this.#trace.addEventListener("click", () => this.trace(!this.#tracing));
  }

  /**
   * Switches the tool that places a traced point.
   * @param {boolean} [on] whether the tool is on; the opposite of its present state if omitted
   */
  trace(on = !this.#tracing) {
    this.#tracing = on && !this.#trace.disabled;
    this.#trace.setAttribute("aria-pressed", String(this.#tracing));
    setData(this.#canvas, "tracing", String(this.#tracing));
  }

  get tool() {
    return this.#tool;
  }

  /** @param {PointerTool | null} tool that receives the pointer's actions; null for the joints */
  setTool(tool) {
    const before = this.#tool;
    this.#tool = tool;
    this.#work = null;
    this.#word.hide();
    setData(this.#canvas, "lent", String(tool !== null));
    if (before !== tool) before?.dropped?.();
  }

  /** @param {import("assur/state/model.js").AnySnapshot} snapshot */
  render({ state, summary }) {
    const { tracers = [] } = /** @type {{ tracers?: readonly unknown[] }} */ (state.document);
    const drawable = summary.moves ? summary.traceable : "links" in state.document;
    if (this.#draw.hidden === drawable) this.#draw.hidden = !drawable;
    this.#draw.setAttribute("aria-pressed", String(state.view.drawing));
    const none = !summary.moves || !summary.traceable || tracers.length >= TRACERS.most;
    if (this.#trace.disabled !== none) this.#trace.disabled = none;
  }

  /** @param {PointerEvent} event */
  #down(event) {
    if (event.button !== 0) return;
    const at = this.#pixelOf(event);
    this.#pointers.set(event.pointerId, at);
    this.#canvas.setPointerCapture(event.pointerId);
    if (this.#pointers.size > 1) {
      this.#drop();
      this.#work = null;
      return;
    }
    if (this.#tool) {
      this.#work = { from: at, still: true, drag: this.#tool.grab(at, event) };
      return;
    }
    const joint = this.#tracing ? this.#put(at) : this.#near(at, event.pointerType);
    if (!joint) {
      this.#show("");
      return;
    }
    const [left, top] = this.#view.view.toScreen(joint.x, joint.y);
    this.#taken = { name: joint.name, pressed: joint.pressed, dx: left - at.x, dy: top - at.y, from: at };
    this.#view.hold();
    this.#show(joint.name);
    this.#word.show(joint, at, event.pointerType === "touch");
    // Taking hold of a joint stops the motion.
    this.#store.update((state) => withView(state, { playing: false }));
  }

  /** @param {PointerEvent} event */
  #move(event) {
    const at = this.#pixelOf(event);
    const from = this.#pointers.get(event.pointerId);
    if (!from && this.#tool) {
      this.#tool.hover(at, event);
      return;
    }
    if (!from) {
      if (event.pointerType !== "touch") this.#hover(at, event.pointerType);
      return;
    }
    this.#pointers.set(event.pointerId, at);
    if (this.#work) {
      this.#pull(this.#work, from, at, event.altKey);
      return;
    }
    if (this.#taken?.pressed) this.#taken.pressed = Math.hypot(at.x - this.#taken.from.x, at.y - this.#taken.from.y) <= STILL;
    if (this.#taken?.pressed) return;
    if (this.#taken) {
      this.#drag(this.#taken, at);
      this.#word.move(at, event.pointerType === "touch");
    }
    else if (this.#pointers.size === 2) this.#pinch(event.pointerId, from, at);
    else if (this.#pointers.size === 1) this.#pan(event.pointerType, from, at);
  }

  /** @param {PointerEvent} event */
  #up(event) {
    if (!this.#pointers.delete(event.pointerId)) return;
    const work = this.#work;
    this.#work = null;
    if (work && this.#tool) {
      if (!work.still) work.drag?.end();
      else if (event.type === "pointerup") this.#tool.press(this.#pixelOf(event), event);
      setData(this.#canvas, "hand", "");
      return;
    }
    if (this.#taken?.pressed && event.type === "pointerup") this.#press(this.#taken.name);
    this.#drop();
    this.#show("");
    this.#word.hide();
  }

  /**
   * @param {Pixel} at
   * @param {string} pointer
   */
  #hover(at, pointer) {
    const joint = this.#near(at, pointer);
    this.#show(joint?.name ?? "");
    if (joint) this.#word.show(joint, at, false);
    else this.#word.hide();
  }

  /**
   * @param {{ from: Pixel, still: boolean, drag: Drag | null }} work
   * @param {Pixel} from
   * @param {Pixel} at
   * @param {boolean} free
   */
  #pull(work, from, at, free) {
    if (work.still && Math.hypot(at.x - work.from.x, at.y - work.from.y) <= STILL) return;
    const began = work.still;
    work.still = false;
    if (work.drag) work.drag.to(at, free);
    else this.#view.pan(at.x - (began ? work.from : from).x, at.y - (began ? work.from : from).y);
    setData(this.#canvas, "hand", "closed");
  }

  /** @param {string} name of a handle that is pressed but not dragged */
  #press(name) {
    const change = attempt(() => this.#engine.simulator.press(name)).value;
    if (change) take(change, this.#page);
  }

  #drop() {
    if (!this.#taken) return;
    this.#taken = null;
    this.#view.release();
  }

  /**
   * Places a traced point on the link nearest to a pixel.
   * @param {Pixel} at
   * @returns {Joint | null} the point, ready to be dragged; null if the engine or the page refuses it
   */
  #put(at) {
    const [x, y] = this.#view.view.toModel(at.x, at.y);
    const put = attempt(() => this.#engine.simulator.trace(inputNow(this.#page), x, y)).value;
    if (!put || !take(put, this.#page)) return null;
    this.trace(false);
    const { tracers } = put.document;
    const { name = `P${tracers.length}`, link } = tracers[tracers.length - 1];
    return { name, role: this.#model.summary.roles[link] ?? "ink", pressed: false, x, y };
  }

  /**
   * @param {{ name: Joint["name"], dx: number, dy: number }} taken
   * @param {Pixel} at
   */
  #drag({ name, dx, dy }, at) {
    const [x, y] = this.#view.view.toModel(at.x + dx, at.y + dy);
    const change = attempt(() => this.#engine.simulator.drag(name, inputNow(this.#page), x, y)).value;
    if (!change) return;
    if (change.document || change.input === undefined) take(change, this.#page);
    else this.#page.drive(this.#model.coordinate.inputShown(change.input));
  }

  /**
   * @param {string} pointer
   * @param {Pixel} from
   * @param {Pixel} at
   */
  #pan(pointer, from, at) {
    if (pointer === "touch" && !this.#view.zoomed) return;
    setData(this.#canvas, "hand", "closed");
    this.#view.pan(at.x - from.x, at.y - from.y);
  }

  /**
   * Zooms and pans with two fingers, so that the drawing follows them.
   * @param {number} moving id of the finger that has moved
   * @param {Pixel} from
   * @param {Pixel} at
   */
  #pinch(moving, from, at) {
    const other = [...this.#pointers].find(([id]) => id !== moving)?.[1];
    if (!other) return;
    const before = Math.hypot(from.x - other.x, from.y - other.y);
    const after = Math.hypot(at.x - other.x, at.y - other.y);
    if (before < 1 || after < 1) return;
    this.#view.zoom(after / before, (from.x + other.x) / 2, (from.y + other.y) / 2);
    this.#view.pan((at.x - from.x) / 2, (at.y - from.y) / 2);
  }

  /** @param {WheelEvent} event */
  #wheel(event) {
    // In a frame without the focus, the wheel scrolls the page around the frame. With Ctrl it always zooms.
    if (parent !== window && !event.ctrlKey && !document.hasFocus()) return;
    event.preventDefault();
    const at = this.#pixelOf(event);
    const pixels = event.deltaY * WHEEL_UNIT[event.deltaMode] * (event.ctrlKey ? PINCHED : 1);
    this.#view.zoom(Math.exp(-WHEEL * pixels), at.x, at.y);
  }

  /** @param {TouchEvent} event */
  #touch(event) {
    const [touch] = event.touches;
    const ours = event.touches.length > 1 || this.#tool || this.#view.zoomed || this.#tracing || this.#near(this.#pixelOf(touch), "touch");
    if (ours && event.cancelable) event.preventDefault();
  }

  /**
   * @param {{ clientX: number, clientY: number }} event
   * @returns {Pixel}
   */
  #pixelOf({ clientX, clientY }) {
    const { left, top } = this.#canvas.getBoundingClientRect();
    return { x: clientX - left, y: clientY - top };
  }

  /**
   * @param {Pixel} at
   * @param {string} pointer
   * @returns {Joint | null} the joint nearest to a pointer within its reach
   */
  #near(at, pointer) {
    return this.#view.near(at, pointer === "touch" ? FINGER_PICK_DISTANCE : PICK_DISTANCE);
  }

  /** @param {string} joint name of the joint under the pointer or being dragged, empty for none */
  #show(joint) {
    this.#view.ring(joint);
    setData(this.#canvas, "hand", this.#taken ? "closed" : joint ? "open" : "");
  }
}
