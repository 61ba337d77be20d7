// A picture behind the drawing: a photograph or a scan that links are drawn over. It is no part of the mechanism: links, files and saved
// pictures do not have it.

/**
 * @typedef {readonly [number, number]} Place in the model, or on the picture, in its pixels
 * @typedef {Readonly<{ x: number, y: number, length: number, angle: number }>} Base the line between the two marked places: where it begins, its
 * length, its angle to the x axis in degrees
 */

/** A picture has no longer side than this, in pixels: what is larger is kept smaller. */
const LONGEST = 2400;

/** What a file may have, in bytes. */
const LARGEST = 64e6;

/** Of what has no size of its own, as drawings without one. */
const SIDE = 1000;

/** A new picture takes this share of what is seen. */
const SHARE = 0.85;

export class BackPicture {
  /** @type {HTMLCanvasElement | null} */
  #pixels = null;
  /** Where its upper left corner is in the model. */
  #origin = /** @type {Place} */ ([0, 0]);
  /** A pixel to its right, in the model. */
  #right = /** @type {Place} */ ([1, 0]);
  /** @type {Place[]} the places that are marked, on the picture */
  #marks = [];
  /** How much of the paper it covers, from 0 to 1. */
  opacity = 0.5;

  get there() {
    return this.#pixels !== null;
  }

  /**
   * Takes a picture, in the middle of what is seen.
   * @param {File} file
   * @param {import("assur/canvas/transform.js").Transform} view
   * @param {import("assur/stage/figure.js").Size} size of what is seen, in pixels
   * @returns {Promise<string | null>} the code of what is wrong with it
   */
  async take(file, view, { width, height }) {
    if (file.size > LARGEST) return "picture_too_large";
    const pixels = await decoded(file);
    if (!pixels) return "no_picture";
    const scale = SHARE * Math.min(width / pixels.width, height / pixels.height);
    this.#pixels = pixels;
    this.#marks = [];
    this.#right = [scale / view.scale, 0];
    this.#origin = view.toModel((width - scale * pixels.width) / 2, (height - scale * pixels.height) / 2);
    return null;
  }

  remove() {
    this.#pixels = null;
    this.#marks = [];
  }

  /** @param {Place} by */
  move([x, y]) {
    this.#origin = [this.#origin[0] + x, this.#origin[1] + y];
  }

  /** @param {Place} at in the model; a third one begins anew */
  mark(at) {
    if (!this.there) return;
    const [x, y] = this.#onPicture(at);
    if (this.#marks.length === 2) this.#marks = [];
    const [first] = this.#marks;
    // Two marks in one place are no line.
    if (first && first[0] === x && first[1] === y) return;
    this.#marks.push([x, y]);
  }

  /** @returns {readonly Place[]} the marks in the model */
  get marks() {
    return this.#marks.map((mark) => this.#inModel(mark));
  }

  /** @returns {Base | null} */
  get base() {
    const [from, to] = this.marks;
    if (!from || !to) return null;
    const [x, y] = [to[0] - from[0], to[1] - from[1]];
    return { x: from[0], y: from[1], length: Math.hypot(x, y), angle: (Math.atan2(y, x) * 180) / Math.PI };
  }

  /**
   * Lays the picture so that the line between its marks is this one.
   * @param {Base} base
   * @returns {boolean} whether there are marks, and the line is one
   */
  lay({ x, y, length, angle }) {
    const now = this.base;
    if (!now || !(length > 0)) return false;
    const turned = ((angle - now.angle) * Math.PI) / 180;
    const grown = length / now.length;
    const [cos, sin] = [grown * Math.cos(turned), grown * Math.sin(turned)];
    const spun = (/** @type {Place} */ [right, up]) => /** @type {Place} */ ([cos * right - sin * up, sin * right + cos * up]);
    const [off, above] = spun([this.#origin[0] - now.x, this.#origin[1] - now.y]);
    const right = spun(this.#right);
    const laid = [x + off, y + above, ...right];
    if (!laid.every(Number.isFinite) || Math.hypot(...right) === 0) return false;
    this.#origin = [x + off, y + above];
    this.#right = right;
    return true;
  }

  /**
   * @param {CanvasRenderingContext2D} context
   * @param {import("assur/canvas/transform.js").Transform} view
   */
  paint(context, view) {
    if (!this.#pixels) return;
    const [left, top] = view.toScreen(...this.#origin);
    const [right, up] = this.#right.map((part) => part * view.scale);
    context.save();
    context.globalAlpha = this.opacity;
    context.transform(right, -up, up, right, left, top);
    context.drawImage(this.#pixels, 0, 0);
    context.restore();
  }

  /**
   * @param {Place} place on the picture
   * @returns {Place}
   */
  #inModel([x, y]) {
    const [right, up] = this.#right;
    // The picture counts downwards.
    return [this.#origin[0] + right * x + up * y, this.#origin[1] + up * x - right * y];
  }

  /**
   * @param {Place} at in the model
   * @returns {Place}
   */
  #onPicture([x, y]) {
    const [right, up] = this.#right;
    const [dx, dy] = [x - this.#origin[0], y - this.#origin[1]];
    const square = right * right + up * up;
    return [(right * dx + up * dy) / square, (up * dx - right * dy) / square];
  }
}

/**
 * @param {File} file
 * @returns {Promise<HTMLCanvasElement | null>} its pixels, if it is a picture
 */
async function decoded(file) {
  try {
    const image = new Image();
    image.src = await address(file);
    await image.decode();
    const [width, height] = [image.naturalWidth || SIDE, image.naturalHeight || SIDE];
    const shrunk = Math.min(1, LONGEST / Math.max(width, height));
    const canvas = document.createElement("canvas");
    canvas.width = Math.max(1, Math.round(width * shrunk));
    canvas.height = Math.max(1, Math.round(height * shrunk));
    canvas.getContext("2d")?.drawImage(image, 0, 0, canvas.width, canvas.height);
    return canvas;
  } catch {
    return null;
  }
}

/**
 * @param {File} file
 * @returns {Promise<string>} it as an address: nothing of it runs or is fetched where it is shown as a picture
 */
function address(file) {
  return new Promise((resolve, reject) => {
    const reader = new FileReader();
    reader.addEventListener("load", () => resolve(String(reader.result)));
    reader.addEventListener("error", () => reject(reader.error));
    reader.readAsDataURL(file);
  });
}
