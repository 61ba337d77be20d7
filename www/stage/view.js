// The drawing of the mechanism on its canvas: its layers, its fit and zoom, and the pictures that are made of it.
import { Places } from "assur/canvas/places.js";
import { Surface } from "assur/canvas/surface.js";
import { Transform, Zoom } from "assur/canvas/transform.js";
import { setData } from "assur/core/dom.js";
import { Figure } from "assur/stage/figure.js";
import { Backdrop } from "assur/stage/paper.js";

/**
 * @typedef {import("assur/state/model.js").AnySnapshot} Snapshot
 * @typedef {import("assur/canvas/theme.js").Theme} Theme
 * @typedef {readonly [number, number, number, number]} Edges left, bottom, right and top of a part of the canvas, in pixels
 * @typedef {{ name: string, role: string, pressed: boolean, x: number, y: number }} Joint handle of a joint or a traced point, in model coordinates; `pressed`: whether
 * a press without a drag has an effect
 * @typedef {Readonly<{ top: number, bottom: number }>} Insets heights of the strips at the edges of the canvas that tools cover, in pixels
 * @typedef {(context: CanvasRenderingContext2D, view: Transform, theme: Theme) => void} Laid paints over or under the mechanism
 */

/** Free room around a drawing, in pixels; `SMALL_MARGIN`: around a small one. */
const MARGIN = 44;
const SMALL_MARGIN = 36;
/** Length of the shorter side below which a drawing is small, in pixels. */
const SMALL = 320;

/** Width and height to which a picture is fitted if the drawing is not on the screen, in pixels. */
const UNSEEN = Object.freeze(/** @type {const} */ ([640, 480]));

/** Limits of the share of the canvas that the bounds may fill. Outside these limits, the view is fitted again. */
const SMALLEST_SHARE = 0.1;
const MAX_SHARE = 2;

/** Disc around a joint that can be dragged. `RING`: its radius, in pixels. `RING_OPACITY`: its opacity. */
const RING = 15;
const RING_OPACITY = 0.28;

export class MechanismView {
  #surface;
  #backdrop = new Backdrop();
  #figure;
  #theme;
  #engine;
  /** @type {Snapshot | null} */
  #snapshot = null;
  #zoom = Zoom.NONE;
  /** @type {readonly number[] | null} bounds to which the zoom is relative, kept while the view is zoomed */
  #bounds = null;
  /** @type {Transform | null} view that is kept, as during the drag of a joint */
  #held = null;
  /** Whether the view is kept because the reader is drawing. */
  #kept = false;
  /** Whether the next snapshot is of another mechanism, so that the present view is not kept. */
  #replaced = false;
  /** Size of the canvas for which the view is kept. */
  #keptSize = "";
  /** @type {() => Insets} */
  #insets = () => ({ top: 0, bottom: 0 });
  /** Size of the lower right corner that buttons cover, in pixels. */
  #corner = { width: 0, height: 0 };
  /** @type {string} the joint with a ring around it */
  #ringed = "";
  /** @type {Laid[]} */
  #laid = [];
  /** @type {{ paint: Laid, bounds: () => readonly number[] | null }[]} */
  #under = [];

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {import("assur/engine.js").Engine} engine
   * @param {Theme} theme
   */
  constructor(canvas, engine, theme) {
    this.#engine = engine;
    this.#theme = theme;
    this.#surface = new Surface(canvas, () => this.#draw(), { alpha: false });
    this.#figure = new Figure(engine, theme);
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    this.#snapshot = snapshot;
    this.#replaced = false;
    this.#figure.take(snapshot);
    setData(this.#surface.canvas, "faded", String(snapshot.faded));
    this.#draw();
  }

  /** @param {Laid} paint paints over the mechanism and under its labels, but not in exported pictures */
  lay(paint) {
    this.#laid.push(paint);
  }

  /**
   * @param {Laid} paint paints over the paper and the fixed shapes and under the moving shapes, but not in exported pictures
   * @param {() => readonly number[] | null} bounds returns the bounds of what is painted: xmin, ymin, xmax, ymax
   */
  layUnder(paint, bounds) {
    this.#under.push({ paint, bounds });
  }

  /** Paints the current content again. */
  repaint() {
    this.#draw();
  }

  /** @returns {Joint[]} the joints and traced points that can be dragged, at their drawn positions */
  joints() {
    const snapshot = this.#snapshot;
    if (!snapshot) return [];
    const { summary: { handles }, handles: points } = snapshot;
    return handles.map((handle, i) => ({ ...handle, x: points[2 * i], y: points[2 * i + 1] }));
  }

  /**
   * @param {{ x: number, y: number }} pixel of the canvas
   * @param {number} reach pixels
   * @param {string} [but] name of a joint to leave out
   * @returns {Joint | null} the nearest joint within reach
   */
  near({ x, y }, reach, but = "") {
    const { view } = this;
    let [nearest, least] = [/** @type {Joint | null} */ (null), reach];
    for (const joint of this.joints()) {
      const [left, top] = view.toScreen(joint.x, joint.y);
      const off = Math.hypot(left - x, top - y);
      if (joint.name !== but && off <= least) [nearest, least] = [joint, off];
    }
    return nearest;
  }

  /** @returns {Transform} transform from the model to the pixels of the canvas */
  get view() {
    const { width, height } = this.#surface;
    return this.#held ?? this.#zoom.upon(this.#fit(), width, height);
  }

  /** @returns {import("assur/stage/figure.js").Size} */
  get size() {
    return this.#surface;
  }

  /**
   * Returns the picture to save or print: the mechanism with room around it, or the visible part of a zoomed drawing.
   * @param {number} [least] least width in pixels
   * @returns {import("assur/export/pictures.js").Picture}
   */
  cropped(least = 0) {
    const { size, begin } = this.sheet(least);
    /** @type {import("assur/export/pictures.js").Picture["paint"]} */
    const paint = (target, theme, newPath) => {
      const { ground, moment } = begin(theme, newPath, this.#figure.places);
      ground(target);
      moment(target);
    };
    return { size, paint };
  }

  /**
   * Returns the picture of {@link cropped} in a form that can be painted at one input after another.
   * @param {number} [least] least width in pixels
   * @param {number} [tall] least height in pixels
   * @returns {import("assur/export/pictures.js").Sheet}
   */
  sheet(least = 0, tall = 0) {
    const { visible } = this.#surface;
    const zoomed = visible && this.zoomed;
    const screen = visible ? (zoomed ? this.view : this.#fit()) : Transform.fit(this.#fullBounds, ...UNSEEN, this.#margin);
    const [left, bottom, right, top] = zoomed ? this.#onScreen() : this.#boundsOnScreen(screen);
    const aside = Math.ceil(Math.max(0, least - (right - left)) / 2);
    const above = Math.ceil(Math.max(0, tall - (bottom - top)) / 2);
    const size = { width: right - left + 2 * aside, height: bottom - top + 2 * above };
    const view = screen.moved(aside - left, above - top);
    const snapshot = this.#snapshot;
    const small = this.#small;
    /** @type {import("assur/export/pictures.js").Sheet["begin"]} */
    const begin = (theme, newPath, places = new Places()) => {
      const figure = new Figure(this.#engine, theme, newPath, places);
      if (snapshot) figure.take(snapshot);
      return {
        ground: (target) => figure.paintGround(target, size, view),
        moment: (target, here, labelled = true) => {
          if (snapshot && here) figure.take({ ...snapshot, ...here });
          figure.paintMoving(target, view);
          if (labelled) figure.paintLabels(target, view, size, small);
        },
      };
    };
    return { size, begin };
  }

  get zoomed() {
    return this.#zoom !== Zoom.NONE;
  }

  /**
   * Magnifies the view about a point of the canvas, by default the centre of the canvas.
   * @param {number} factor
   * @param {number} [left] pixels
   * @param {number} [top]
   */
  zoom(factor, left = this.#surface.width / 2, top = this.#surface.height / 2) {
    const limited = Math.min(Math.max(factor, Zoom.MIN / this.#zoom.factor), Zoom.MAX / this.#zoom.factor);
    this.#look(this.view.scaled(limited, left, top));
  }

  /**
   * @param {number} right pixels
   * @param {number} down
   */
  pan(right, down) {
    this.#look(this.view.moved(right, down));
  }

  /**
   * Fits the whole mechanism to the canvas.
   * @param {boolean} [replaced] whether the mechanism of the next snapshot is meant
   */
  fit(replaced = false) {
    this.#replaced = replaced;
    this.#zoom = Zoom.NONE;
    this.#bounds = null;
    this.#held = null;
    this.#shown();
  }

  /** Fits all that is drawn at this input to the canvas: the mechanism, and the named points and circles of the overlays. */
  fitAll() {
    this.fit();
    const all = joined([this.#fullBounds, ...this.#figure.marks()]);
    if (this.#kept || this.#fullBounds.every((side, i) => side === all[i])) return;
    this.#bounds = all;
    this.#zoom = new Zoom(1, 0, 0);
    this.#shown();
  }

  /**
   * Fits the view again if the bounds are out of sight, or too small or too large to work with.
   * @param {readonly number[]} bounds xmin, ymin, xmax, ymax
   */
  seek([xmin, ymin, xmax, ymax]) {
    const { width, height } = this.#surface;
    const [left, bottom] = this.view.toScreen(xmin, ymin);
    const [right, top] = this.view.toScreen(xmax, ymax);
    const seen = left < width && right > 0 && top < height && bottom > 0;
    const share = Math.max((right - left) / width, (bottom - top) / height);
    if (!seen || share < SMALLEST_SHARE || share > MAX_SHARE) this.fit();
  }

  /**
   * @param {boolean} on whether the view is kept while the reader draws
   * @param {() => Insets} insets
   */
  keep(on, insets) {
    if (on === this.#kept) return;
    this.#kept = on;
    this.#insets = insets;
    this.#held = null;
    if (!on) this.release();
  }

  /**
   * Fits the drawing clear of the buttons in the lower right corner.
   * @param {number} width of the covered corner, in pixels
   * @param {number} height
   */
  spare(width, height) {
    this.#corner = { width, height };
    this.#shown();
  }

  /** Keeps the view during a drag. */
  hold() {
    this.#held = this.view;
  }

  /** Lets the view follow the bounds again, unless the reader has zoomed or is drawing. */
  release() {
    if (!this.#kept) this.#held = null;
    this.#shown();
  }

  /** @param {string} name of the joint that gets a ring; empty for none */
  ring(name) {
    if (name === this.#ringed) return;
    this.#ringed = name;
    this.#draw();
  }

  /** @param {Transform} view */
  #look(view) {
    const { width, height, visible } = this.#surface;
    if (!visible) return;
    this.#held = null;
    this.#bounds ??= this.#fullBounds;
    this.#zoom = Zoom.between(this.#fit(), view, this.#bounds, width, height);
    this.#shown();
  }

  #shown() {
    setData(this.#surface.canvas, "zoom", String(this.#zoom.factor));
    setData(this.#surface.canvas, "zoomed", String(this.zoomed));
    this.#draw();
  }

  get #small() {
    return this.#surface.visible && Math.min(this.#surface.width, this.#surface.height) < SMALL;
  }

  get #margin() {
    return (this.#small ? SMALL_MARGIN : MARGIN) * this.#theme.scale;
  }

  /** @returns {Transform} */
  #fit() {
    const { width, height } = this.#surface;
    const { top, bottom } = this.#insets();
    // On a low canvas the drawing keeps half of it, if need be under the tools.
    const share = Math.min(1, height / 2 / Math.max(top + bottom, 1));
    const bounds = this.#bounds ?? this.#fullBounds;
    const fitted = Transform.fit(bounds, width, height - share * (top + bottom), this.#margin).moved(0, share * top);
    const [right, foot] = fitted.toScreen(bounds[2], bounds[1]);
    const { width: wide, height: high } = this.#corner;
    const covered = right > width - wide && foot > height - high && high < height / 2;
    return covered && !this.#kept ? Transform.fit(bounds, width, height - high, this.#margin) : fitted;
  }

  /** @returns {readonly number[]} bounds of the mechanism and of what is painted under it; a mechanism without joints counts only if nothing is painted */
  get #fullBounds() {
    const { bounds = [0, 0, 1, 1], handles = [] } = this.#snapshot?.summary ?? {};
    const under = this.#under.flatMap(({ bounds: of }) => [of() ?? []]).filter((one) => one.length > 0);
    const all = under.length > 0 && handles.length === 0 ? under : [bounds, ...under];
    return joined(all);
  }

  /** @returns {Edges} */
  #onScreen() {
    const { width, height } = this.#surface;
    return [0, Math.ceil(height), Math.ceil(width), 0];
  }

  /**
   * @param {Transform} view
   * @returns {Edges} bounds of the mechanism in all its poses, with a margin
   */
  #boundsOnScreen(view) {
    const [xmin, ymin, xmax, ymax] = this.#snapshot?.summary.bounds ?? [0, 0, 1, 1];
    const [left, bottom] = view.toScreen(xmin, ymin);
    const [right, top] = view.toScreen(xmax, ymax);
    const margin = this.#margin;
    // The edges are at whole pixels, so that lines are as sharp as on the screen.
    return [Math.floor(left - margin), Math.ceil(bottom + margin), Math.ceil(right + margin), Math.floor(top - margin)];
  }

  #draw() {
    const snapshot = this.#snapshot;
    if (!snapshot || !this.#surface.begin()) return;
    if (this.#kept && !this.#replaced) this.#keep();
    const { view } = this;
    const key = `${snapshot.revision} ${snapshot.words.lang} ${this.#theme.revision} ${view.scale} ${view.left} ${view.top}`;
    this.#backdrop.cover(this.#surface, key, (target) => this.#figure.paintGround(target, this.#surface, view));
    for (const { paint } of this.#under) paint(this.#surface.context, view, this.#theme);
    this.#figure.paintMoving(this.#surface, view);
    this.#paintRing(view);
    for (const paint of this.#laid) paint(this.#surface.context, view, this.#theme);
    this.#figure.paintLabels(this.#surface, view, this.#surface, this.#small);
  }

  /** Keeps the view until the size of the canvas changes. */
  #keep() {
    const { width, height } = this.#surface;
    const size = `${width}×${height}`;
    if (size !== this.#keptSize) this.#held = null;
    this.#keptSize = size;
    this.#held ??= this.view;
  }

  /** @param {Transform} view */
  #paintRing(view) {
    if (!this.#ringed) return;
    const joint = this.joints().find(({ name }) => name === this.#ringed);
    if (!joint) return;
    const { context } = this.#surface;
    const [left, top] = view.toScreen(joint.x, joint.y);
    context.beginPath();
    context.arc(left, top, RING * this.#theme.weight, 0, 2 * Math.PI);
    context.globalAlpha = RING_OPACITY;
    context.fillStyle = this.#theme.colours[joint.role];
    context.fill();
    context.globalAlpha = 1;
  }
}

/**
 * @param {readonly (readonly number[])[]} all bounds, at least one: xmin, ymin, xmax, ymax
 * @returns {readonly number[]} bounds around all of them
 */
function joined(all) {
  return [0, 1, 2, 3].map((side) => (side < 2 ? Math.min : Math.max)(...all.map((one) => one[side])));
}
