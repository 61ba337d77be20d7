// The pointer in drawing mode: the points and links that presses hit and drags move.
import { attempt } from "assur/core/problem.js";
import { edit, unsay, unsayLater } from "assur/drawing/edit.js";
import { inputNow } from "assur/state/change.js";
import { side } from "assur/stage/paper.js";

/**
 * @typedef {import("assur/stage/pointer.js").Pixel} Pixel
 * @typedef {import("assur/drawing/tools.js").Target} Target
 * @typedef {import("assur/state/state.js").LinkageDocument} Document
 * @typedef {readonly [number, number]} Point in the model
 * @typedef {Pick<PointerEvent, "pointerType" | "altKey" | "shiftKey">} Pressed
 * @typedef {{ to(at: Pixel, free: boolean): void, end(): void }} Drag
 */

/** Greatest distance of a press from the joint or link that it hits, in pixels: for a mouse, and for a finger. */
const PICK_DISTANCE = Object.freeze({ joint: [16, 26], link: [7, 14] });

/** Event data for a press made by the keyboard. */
const KEYED = Object.freeze({ pointerType: "mouse", altKey: false, shiftKey: false });

/** Number of grid steps per side of a square of the squared paper, by the first digit of the side's length. */
const STEPS = Object.freeze({ 1: 5, 2: 4, 5: 5 });

export class Hand {
  #page;
  #work;
  #selection;
  #changed;
  /** @type {[Point, Point] | null} opposite corners of the rectangle that the reader draws to select */
  frame = null;
  /** @type {Point | null} point in the model at which a press would act; null if the pointer is outside the drawing */
  over = null;
  /** @type {Point | null} position of the point that is dragged */
  held = null;
  /** Whether `over` was set by the keyboard's pointer. */
  keyed = false;

  /**
   * @param {import("assur/app/page.js").Page} page
   * @param {import("assur/drawing/tools.js").Work} work
   * @param {import("assur/drawing/selection.js").Selection} selection
   * @param {() => void} changed called when only the marks over the drawing change
   */
  constructor(page, work, selection, changed) {
    this.#page = page;
    this.#work = work;
    this.#selection = selection;
    this.#changed = changed;
  }

  /**
   * @param {Pixel} at
   * @param {PointerEvent} event
   */
  hover(at, event) {
    const target = this.#target(at, event);
    this.over = target.at;
    this.held = null;
    this.keyed = false;
    this.#page.mechanism.ring(target.point ?? "");
    this.#changed();
  }

  leave() {
    this.over = null;
    this.#page.mechanism.ring("");
    this.#changed();
  }

  /**
   * Moves the keyboard's pointer along the grid. It starts at the mouse pointer or, if that is outside the drawing, in
   * the middle of the visible area.
   * @param {number} right steps
   * @param {number} up
   */
  walk(right, up) {
    const { width, height } = this.#page.mechanism.size;
    const [x, y] = this.over ?? this.#snapped({ x: width / 2, y: height / 2 }, false);
    this.keyed = true;
    this.over = this.over ? [round(x + right * this.step, this.step), round(y + up * this.step, this.step)] : [x, y];
    const [left, top] = this.#view.toScreen(...this.over);
    this.#page.mechanism.ring(this.#joint({ x: left, y: top }, false)?.name ?? "");
    this.#changed();
  }

  /** Presses at the keyboard's pointer. */
  pressHere() {
    if (!this.over) return;
    const [x, y] = this.#view.toScreen(...this.over);
    this.press({ x, y }, KEYED);
  }

  /**
   * Handles a press without a drag.
   * @param {Pixel} at
   * @param {Pressed} event
   */
  press(at, event) {
    // Removes the message about the previous press.
    unsay(this.#page);
    const target = this.#target(at, event);
    if (this.#work.tool === "select") this.#selection.choose(target.point, target.link, event.shiftKey);
    else this.#work.press(target);
    this.over = target.at;
    unsayLater(this.#page);
    this.#page.redraw();
  }

  /**
   * Begins a drag at a pixel. Returns null if the tool drags nothing there.
   * @param {Pixel} at
   * @param {PointerEvent} event
   * @returns {Drag | null}
   */
  grab(at, event) {
    const touch = event.pointerType === "touch";
    unsay(this.#page);
    if (this.#work.tool === "picture" && this.#work.picture.there) return this.#slide(at);
    if (this.#work.tool !== "select") return null;
    const { point, link } = this.#target(at, event);
    if (point && this.#selection.points.has(point) && this.#selection.points.size > 1) return this.#carry(this.#selection.all(this.#document()), at);
    if (point) return this.#move(point, at, touch);
    if (link) {
      const own = this.#selection.links.has(link) ? this.#selection.all(this.#document()) : this.#document().links.find(({ name }) => name === link)?.points ?? [];
      return this.#carry(own, at);
    }
    // A finger on the paper pans the view instead.
    return touch ? null : this.#surround(at, event.shiftKey);
  }

  /**
   * Drags one point. If it is dropped on another point, the two are joined.
   * @param {string} point
   * @param {Pixel} from
   * @param {boolean} touch
   * @returns {Drag}
   */
  #move(point, from, touch) {
    const joint = this.#page.mechanism.joints().find(({ name }) => name === point);
    if (!joint) return { to() {}, end() {} };
    const [left, top] = this.#view.toScreen(joint.x, joint.y);
    const off = { x: left - from.x, y: top - from.y };
    let onto = "";
    return {
      to: (at, free) => {
        const pixel = { x: at.x + off.x, y: at.y + off.y };
        const near = this.#joint(pixel, touch, point);
        onto = near && this.#isPoint(near.name) && this.#isPoint(point) ? near.name : "";
        const [x, y] = near ? [near.x, near.y] : this.#snapped(pixel, free);
        this.#page.mechanism.ring(onto || point);
        const drawn = edit(this.#page, { edit: "place", point, at: [x, y] });
        this.held = drawn?.document.points.find(({ name }) => name === point)?.at ?? this.held;
        // Locked dimensions may have kept the dragged point from reaching the other point.
        if (drawn?.held) onto = "";
      },
      end: () => {
        this.held = null;
        // Dragging and joining form one undo step.
        if (onto && edit(this.#page, { edit: "join", points: [point, onto] })) this.#selection.set([onto], []);
        unsayLater(this.#page);
      },
    };
  }

  /**
   * Drags several points by the same distance.
   * @param {readonly string[]} points
   * @param {Pixel} from
   * @returns {Drag}
   */
  #carry(points, from) {
    const last = this.#snapped(from, false);
    const [first] = points;
    return {
      to: (at, free) => {
        const [x, y] = this.#snapped(at, free);
        const by = /** @type {[number, number]} */ ([x - last[0], y - last[1]]);
        if (by[0] === 0 && by[1] === 0) return;
        const before = this.#page.mechanism.joints().find(({ name }) => name === first);
        const after = edit(this.#page, { edit: "move", points: [...points], by })?.document.points.find(({ name }) => name === first);
        if (!after) return;
        // Locked dimensions may have shortened the movement.
        const went = before ? [after.at[0] - before.x, after.at[1] - before.y] : by;
        last[0] += went[0];
        last[1] += went[1];
      },
      end: () => unsayLater(this.#page),
    };
  }

  /**
   * Drags the picture behind the drawing.
   * @param {Pixel} from
   * @returns {Drag}
   */
  #slide(from) {
    let last = this.#snapped(from, true);
    return {
      to: (at) => {
        const [x, y] = this.#snapped(at, true);
        this.#work.picture.move([x - last[0], y - last[1]]);
        last = [x, y];
      },
      end() {},
    };
  }

  /**
   * Draws a rectangle, and selects the points and links inside.
   * @param {Pixel} from
   * @param {boolean} more whether to add to the selection instead of replacing it
   * @returns {Drag}
   */
  #surround(from, more) {
    const corner = this.#view.toModel(from.x, from.y);
    const [points, links] = more ? [this.#selection.points, this.#selection.links] : [[], []];
    return {
      to: (at) => {
        const other = this.#view.toModel(at.x, at.y);
        this.frame = [corner, other];
        const inside = this.#page.mechanism.joints().filter(({ x, y }) => between(x, corner[0], other[0]) && between(y, corner[1], other[1]));
        const names = new Set(inside.map(({ name }) => name));
        const enclosed = this.#document().links.filter((link) => link.points.every((point) => names.has(point)));
        this.#selection.set([...points, ...names], [...links, ...enclosed.map(({ name }) => name)]);
        this.#page.redraw();
      },
      end: () => {
        this.frame = null;
        this.#page.redraw();
      },
    };
  }

  /** The step of the grid, in the unit of lengths. */
  get step() {
    return grid(this.#view.scale);
  }

  get #view() {
    return this.#page.mechanism.view;
  }

  #document() {
    return /** @type {Document} */ (this.#page.store.get().document);
  }

  /** @param {string} name */
  #isPoint(name) {
    return this.#document().points?.some((point) => point.name === name) ?? true;
  }

  /**
   * @param {Pixel} at
   * @param {Pressed} event
   * @returns {Target} the joint at a pixel, or else the link, or else the paper
   */
  #target(at, event) {
    const touch = event.pointerType === "touch";
    // Marks on a picture ignore the grid and the joints.
    if (this.#work.tool === "picture") return { point: null, link: null, wheel: null, at: this.#snapped(at, true) };
    const joint = this.#joint(at, touch);
    if (joint) return { point: joint.name, link: this.#linkOf(joint.name), wheel: this.#wheelOn(joint.name), at: [joint.x, joint.y] };
    // With Alt, the press passes over a link under the pointer, or else ignores the grid.
    const below = this.#link(at, touch);
    if (!event.altKey) return { point: null, ...below, at: this.#snapped(at, false) };
    return { point: null, link: null, wheel: null, at: this.#snapped(at, below.link === null) };
  }

  /**
   * @param {Pixel} at
   * @param {boolean} touch
   * @param {string} [but] joint to leave out
   */
  #joint(at, touch, but = "") {
    return this.#page.mechanism.near(at, PICK_DISTANCE.joint[Number(touch)], but);
  }

  /**
   * @param {string} point
   * @returns {string | null} the link of the point, if the point is on one link only
   */
  #linkOf(point) {
    const having = this.#document().links?.filter(({ points }) => points.includes(point)) ?? [];
    return having.length === 1 ? having[0].name : null;
  }

  /**
   * @param {string} point
   * @returns {string | null} the last wheel added at the point; null if the point has no wheel or is on no other link
   */
  #wheelOn(point) {
    const { links = [], slides = [] } = this.#document();
    const having = links.filter(({ points }) => points.includes(point));
    const alone = having.findLast(({ name, points }) => points.length === 1 && !slides.some(({ link }) => link === name));
    return having.length > 1 && alone ? alone.name : null;
  }

  /**
   * @param {Pixel} at
   * @param {boolean} touch
   * @returns {Pick<Target, "link" | "wheel">}
   */
  #link(at, touch) {
    const [x, y] = this.#view.toModel(at.x, at.y);
    const input = inputNow(this.#page);
    const near = attempt(() => this.#page.engine.simulator.linkAt(input, x, y)).value;
    const reached = near && near.off * this.#view.scale <= PICK_DISTANCE.link[Number(touch)];
    return { link: reached ? near.link : null, wheel: near?.wheel ?? null };
  }

  /**
   * @param {Pixel} at
   * @param {boolean} free whether the grid is ignored
   * @returns {[number, number]} the point in the model, moved to the nearest grid point unless the grid is ignored
   */
  #snapped(at, free) {
    const [x, y] = this.#view.toModel(at.x, at.y);
    if (free) return [x, y];
    return [round(x, this.step), round(y, this.step)];
  }
}

/**
 * @param {number} scale pixels per unit of length
 * @returns {number} the step of the grid
 */
function grid(scale) {
  const square = side(scale);
  const digit = Math.round(square / 10 ** Math.floor(Math.log10(square * 1.000001)));
  return square / (STEPS[/** @type {1 | 2 | 5} */ (digit)] ?? 5);
}

/**
 * @param {number} value
 * @param {number} step
 * @returns {number} the nearest multiple of the step, without rounding errors in the last decimals
 */
function round(value, step) {
  return Number((Math.round(value / step) * step).toPrecision(12));
}

/**
 * @param {number} value
 * @param {number} one
 * @param {number} other
 */
function between(value, one, other) {
  return value >= Math.min(one, other) && value <= Math.max(one, other);
}
