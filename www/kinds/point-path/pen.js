// The pen: a path drawn by the hand. While the hand draws, the page shows the best linkage of a short search.
import { byId, make } from "assur/core/dom.js";
import { onLeaving } from "assur/kinds/point-path/choose.js";
import { edited } from "assur/state/state.js";

/**
 * @typedef {import("assur/stage/pointer.js").Pixel} Pixel
 */

/** Least distance between two points of a drawn line, in pixels. */
const STEP = 3;

/** Greatest number of points of a drawn path. */
const MOST = 96;

/** A line is closed if the distance of its ends is less than this part of its length. */
const CLOSES = 0.08;

/** Time between two short searches while the line is drawn, in milliseconds. */
const LOOK = 120;

/** Points are rounded to a multiple of a power of ten near the size of the path divided by this number. */
const STEPS = 1000;

/** Least sum of width and height of a drawn line, in pixels. A smaller line is taken for a slip of the hand. */
const SMALLEST = 30;

/** Least number of points of a path. */
const LEAST = 3;

export class Pen {
  #page;
  #on = false;
  #looked = 0;
  button = make("button", { id: "path-pen", class: "control add", type: "button", "aria-pressed": "false", "data-t": "path.pen", onclick: () => this.#set(!this.#on) });
  hint = make("p", { id: "path-pen-hint", "data-t": "path.pen_hint", hidden: "" });

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    this.#page = page;
    onLeaving(page, () => this.#set(false));
    addEventListener("keydown", (event) => {
      if (event.key === "Escape" && this.#on) this.#set(false);
    });
  }

  /** @param {boolean} on */
  #set(on) {
    if (on === this.#on) return;
    this.#on = on;
    this.button.setAttribute("aria-pressed", String(on));
    this.hint.hidden = !on;
    if (!on) this.#page.mechanism.release();
    const { pointer } = this.#page;
    if (on) pointer.setTool(this);
    else if (pointer.tool === this) pointer.setTool(null);
  }

  dropped() {
    this.#set(false);
  }

  hover() {}

  leave() {}

  /**
   * Adds a point at the end of the path.
   * @param {Pixel} at
   */
  press(at) {
    const place = this.#place(at);
    this.#page.store.update((state) => edited(state, "point-path", (document) => ({ path: [...document.path, place], angles_deg: nextAngles(document), linkage: null })));
  }

  /**
   * @param {Pixel} from
   * @returns {import("assur/stage/pointer.js").Drag}
   */
  grab(from) {
    const line = [from];
    const { mechanism } = this.#page;
    return {
      to: (at) => {
        if (line.length === 1) mechanism.hold();
        const last = line[line.length - 1];
        if (Math.hypot(at.x - last.x, at.y - last.y) < STEP) return;
        line.push(at);
        const now = performance.now();
        if (now < this.#looked + LOOK) return;
        this.#draw(line, false);
        this.#looked = performance.now();
      },
      end: () => {
        this.#draw(line, closes(line));
        this.#set(false);
        this.button.focus({ preventScroll: true });
      },
    };
  }

  /** @param {Pixel} at */
  #place({ x, y }) {
    const { view } = this.#page.mechanism;
    const digits = Math.ceil(Math.log10((STEPS * view.scale) / Math.max(1, byId("mechanism", HTMLCanvasElement).clientWidth)));
    const steps = 10 ** digits;
    return /** @type {[number, number]} */ (view.toModel(x, y).map((value) => Math.round(value * steps) / steps));
  }

  /**
   * @param {readonly Pixel[]} line
   * @param {boolean} closed
   */
  #draw(line, closed) {
    const [xs, ys] = [line.map(({ x }) => x), line.map(({ y }) => y)];
    if (Math.max(...xs) - Math.min(...xs) + Math.max(...ys) - Math.min(...ys) < SMALLEST) return;
    // The end of a closed line is its beginning.
    const points = (closed ? thinned(line, MOST + 1).slice(0, -1) : thinned(line, MOST)).map((at) => this.#place(at));
    if (points.length < LEAST) return;
    /** @type {import("assur/types/file.js").CourseDocument} */
    const course = closed ? "closed" : "open";
    this.#page.store.update((state) => edited(state, "point-path", () => ({ path: points, course, angles_deg: [], linkage: null })));
  }
}

/**
 * @param {import("assur/state/state.js").Documents["point-path"]} document
 * @returns {number[]} the crank angles with that of one more point, at the distance of the last two; none if they are free
 */
export function nextAngles({ angles_deg: angles }) {
  if (!angles?.length) return [];
  const [before, last] = [angles.at(-2) ?? 0, angles.at(-1) ?? 0];
  return [...angles, 2 * last - before];
}

/** @param {readonly Pixel[]} line */
function lengthsOf(line) {
  const lengths = [0];
  for (let k = 1; k < line.length; k++) lengths.push(lengths[k - 1] + Math.hypot(line[k].x - line[k - 1].x, line[k].y - line[k - 1].y));
  return lengths;
}

/**
 * @param {readonly Pixel[]} line
 * @returns {boolean} whether the end of a line is near its beginning
 */
export function closes(line) {
  const [first, last] = [line[0], line[line.length - 1]];
  return line.length > 2 * LEAST && Math.hypot(last.x - first.x, last.y - first.y) < CLOSES * lengthsOf(line)[line.length - 1];
}

/**
 * @param {readonly Pixel[]} line
 * @param {number} most
 * @returns {Pixel[]} at most this number of points of a line, at equal distances, with both ends
 */
export function thinned(line, most) {
  if (line.length <= most) return [...line];
  const lengths = lengthsOf(line);
  const all = lengths[lengths.length - 1];
  let k = 1;
  return Array.from({ length: most }, (_, j) => {
    const wanted = (all * j) / (most - 1);
    while (k < line.length - 1 && lengths[k] < wanted) k += 1;
    const share = (wanted - lengths[k - 1]) / Math.max(lengths[k] - lengths[k - 1], Number.MIN_VALUE);
    const [from, to] = [line[k - 1], line[k]];
    return { x: from.x + share * (to.x - from.x), y: from.y + share * (to.y - from.y) };
  });
}
