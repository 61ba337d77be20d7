// A photograph or scan behind the drawing. As part of the state it is saved and undone; URLs and exports omit it.
import { degrees, radians } from "assur/core/angles.js";
import { refuse } from "assur/drawing/edit.js";
import { imageOf, pixelsOf } from "assur/drawing/image.js";
import { withExtras } from "assur/state/state.js";

/**
 * @typedef {readonly [number, number]} Point in the model, or on the picture in pixels
 * @typedef {Readonly<{ x: number, y: number, length: number, angle: number }>} Base the line between the two marked
 * points: coordinates of its start, its length, and its angle to the x axis in degrees
 * @typedef {import("assur/state/state.js").Picture} Picture
 */

/** Largest size of a file, in bytes. */
const LARGEST = 64e6;

/** `SHARE`: greatest share of the view's width and height that a new picture takes. `OPACITY`: its opacity. */
const SHARE = 0.85;
const OPACITY = 0.5;

/** Limit on the coordinates and the size of the picture. */
const FARTHEST = 1e9;

export class BackPicture {
  #page;
  /** Text of the image to which the pixels belong. */
  #image = "";
  /** @type {HTMLCanvasElement | null} pixels of the image; null until they are loaded, and if the image cannot be read */
  #pixels = null;
  /** @type {Point[]} marked points on the picture */
  #marks = [];

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    this.#page = page;
  }

  get #picture() {
    return this.#page.store.get().picture;
  }

  get there() {
    return this.#picture !== undefined;
  }

  get opacity() {
    return this.#picture?.opacity ?? OPACITY;
  }

  set opacity(opacity) {
    this.#put({ opacity });
  }

  /** Loads the pixels of the state's picture, and reports an image that cannot be read. */
  async follow() {
    const image = this.#picture?.image ?? "";
    if (image === this.#image) return;
    this.#show(image, null);
    if (image === "") return;
    const pixels = await pixelsOf(image);
    if (image !== this.#image) return;
    this.#pixels = pixels;
    if (!pixels) refuse(this.#page, "no_picture");
    this.#page.redraw();
  }

  /**
   * Puts a picture in the middle of the visible area.
   * @param {File} file
   * @param {import("assur/canvas/transform.js").Transform} view
   * @param {import("assur/stage/figure.js").Size} size of the visible area, in pixels
   * @returns {Promise<string | null>} code of a problem with the file; null if there is none
   */
  async take(file, view, { width, height }) {
    if (file.size > LARGEST) return "picture_too_large";
    const image = await imageOf(file);
    if (!image) return "no_picture";
    const { text, pixels } = image;
    const scale = SHARE * Math.min(width / pixels.width, height / pixels.height);
    const at = view.toModel((width - scale * pixels.width) / 2, (height - scale * pixels.height) / 2);
    const opacity = this.opacity;
    this.#show(text, pixels);
    this.#page.history.step(() => this.#set({ image: text, at, width: (scale * pixels.width) / view.scale, turn_deg: 0, opacity }));
    return null;
  }

  remove() {
    this.#page.history.step(() => this.#set(undefined));
  }

  /** @param {Point} by */
  move([x, y]) {
    const { at } = this.#picture ?? {};
    if (at) this.#put({ at: [at[0] + x, at[1] + y] });
  }

  /** @param {Point} at point in the model; a third mark replaces the first two */
  mark(at) {
    const frame = this.#frame;
    if (!frame) return;
    const { origin, right: [right, up] } = frame;
    const [dx, dy] = [at[0] - origin[0], at[1] - origin[1]];
    const square = right * right + up * up;
    const mark = /** @type {Point} */ ([(right * dx + up * dy) / square, (up * dx - right * dy) / square]);
    if (this.#marks.length === 2) this.#marks = [];
    const [first] = this.#marks;
    // Two equal marks determine no line.
    if (first && first[0] === mark[0] && first[1] === mark[1]) return;
    this.#marks.push(mark);
  }

  /** @returns {readonly Point[]} the marks in the model */
  get marks() {
    const frame = this.#frame;
    if (!frame) return [];
    const { origin, right: [right, up] } = frame;
    // The picture's rows are counted downwards.
    return this.#marks.map(([x, y]) => [origin[0] + right * x + up * y, origin[1] + up * x - right * y]);
  }

  /** @returns {Base | null} */
  get base() {
    const [from, to] = this.marks;
    if (!from || !to) return null;
    const [x, y] = [to[0] - from[0], to[1] - from[1]];
    return { x: from[0], y: from[1], length: Math.hypot(x, y), angle: degrees(Math.atan2(y, x)) };
  }

  /**
   * Places the picture so that the line between its marks becomes the given one.
   * @param {Base} base
   * @returns {boolean} whether the picture was placed; this needs two marks and a valid length
   */
  lay({ x, y, length, angle }) {
    const now = this.base;
    const picture = this.#picture;
    if (!now || !picture || !(length > 0)) return false;
    const turned = angle - now.angle;
    const grown = length / now.length;
    const [cos, sin] = [grown * Math.cos(radians(turned)), grown * Math.sin(radians(turned))];
    const [dx, dy] = [picture.at[0] - now.x, picture.at[1] - now.y];
    const turn = picture.turn_deg + turned;
    return this.#put({
      at: [x + cos * dx - sin * dy, y + sin * dx + cos * dy], width: grown * picture.width, turn_deg: turn - 360 * Math.round(turn / 360),
    });
  }

  /** @returns {number[] | null} xmin, ymin, xmax, ymax of the picture in the model */
  get bounds() {
    const frame = this.#frame;
    if (!frame) return null;
    const { pixels: { width, height }, origin: [x, y], right: [right, up] } = frame;
    const corners = [[0, 0], [width, 0], [0, height], [width, height]].map(([column, row]) => [x + right * column + up * row, y + up * column - right * row]);
    const [xs, ys] = [corners.map(([one]) => one), corners.map(([, one]) => one)];
    return [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)];
  }

  /**
   * @param {CanvasRenderingContext2D} context
   * @param {import("assur/canvas/transform.js").Transform} view
   */
  paint(context, view) {
    const frame = this.#frame;
    if (!frame) return;
    const [left, top] = view.toScreen(...frame.origin);
    const [right, up] = frame.right.map((part) => part * view.scale);
    context.save();
    context.globalAlpha = this.opacity;
    context.transform(right, -up, up, right, left, top);
    context.drawImage(frame.pixels, 0, 0);
    context.restore();
  }

  /**
   * @returns {{ pixels: HTMLCanvasElement, origin: Point, right: Point } | null} `pixels`: those of the picture. In
   * model coordinates, `origin`: the picture's upper left corner; `right`: the vector from a pixel to the next on its
   * right
   */
  get #frame() {
    const [picture, pixels] = [this.#picture, this.#pixels];
    if (!picture || !pixels || picture.image !== this.#image) return null;
    const scale = picture.width / pixels.width;
    const turn = radians(picture.turn_deg);
    return { pixels, origin: picture.at, right: [scale * Math.cos(turn), scale * Math.sin(turn)] };
  }

  /**
   * @param {string} image
   * @param {HTMLCanvasElement | null} pixels
   */
  #show(image, pixels) {
    this.#image = image;
    this.#pixels = pixels;
    this.#marks = [];
  }

  /**
   * @param {Partial<Picture>} change
   * @returns {boolean} whether the change was possible and was made
   */
  #put(change) {
    const picture = this.#picture && { ...this.#picture, ...change };
    if (!picture || !(picture.width > 0) || ![...picture.at, picture.width].every((part) => Math.abs(part) <= FARTHEST)) return false;
    this.#set(picture);
    return true;
  }

  /** @param {Picture | undefined} picture */
  #set(picture) {
    this.#page.store.update((state) => withExtras(state, { picture: picture && Object.freeze(picture) }));
  }
}
