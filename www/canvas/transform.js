// The view transform, from model coordinates (y up) to screen pixels (y down). Only this module changes the sign of y.

/** An immutable, invertible map: x ↦ left + scale·x, y ↦ top − scale·y. */
export class Transform {
  /**
   * @param {number} scale pixels per unit of length
   * @param {number} left screen position of the model's origin
   * @param {number} top
   */
  constructor(scale, left, top) {
    this.scale = scale;
    this.left = left;
    this.top = top;
    Object.freeze(this);
  }

  /**
   * The largest view in which the bounds fit into a rectangle of the screen, with a margin.
   * @param {readonly number[]} bounds xmin, ymin, xmax, ymax
   * @param {number} width
   * @param {number} height
   * @param {number} margin
   */
  static fit([xmin, ymin, xmax, ymax], width, height, margin) {
    const scale = Math.min(
      Math.max(width - 2 * margin, 1) / Math.max(xmax - xmin, Number.MIN_VALUE),
      Math.max(height - 2 * margin, 1) / Math.max(ymax - ymin, Number.MIN_VALUE),
    );
    return new Transform(scale, width / 2 - (scale * (xmin + xmax)) / 2, height / 2 + (scale * (ymin + ymax)) / 2);
  }

  /**
   * The view magnified about the point (left, top) of the screen.
   * @param {number} factor
   * @param {number} left
   * @param {number} top
   */
  scaled(factor, left, top) {
    const grown = (/** @type {number} */ from, /** @type {number} */ at) => at + factor * (from - at);
    return new Transform(this.scale * factor, grown(this.left, left), grown(this.top, top));
  }

  /**
   * The view moved on the screen.
   * @param {number} right pixels
   * @param {number} down pixels
   */
  moved(right, down) {
    return new Transform(this.scale, this.left + right, this.top + down);
  }

  /**
   * @param {number} x
   * @param {number} y
   * @returns {[number, number]} screen pixels
   */
  toScreen(x, y) {
    return [this.left + this.scale * x, this.top - this.scale * y];
  }

  /**
   * @param {number} left
   * @param {number} top
   * @returns {[number, number]} model coordinates
   */
  toModel(left, top) {
    return [(left - this.left) / this.scale, (this.top - top) / this.scale];
  }

  /**
   * Sets a canvas to the coordinates of a body at (x, y), turned through an angle.
   * @param {import("assur/canvas/painter.js").Context} context
   * @param {number} ratio device pixels per screen pixel
   * @param {number} x
   * @param {number} y
   * @param {number} angle
   */
  place(context, ratio, x, y, angle) {
    const [left, top] = this.toScreen(x, y);
    const k = this.scale * ratio;
    const cos = k * Math.cos(angle);
    const sin = k * Math.sin(angle);
    context.setTransform(cos, -sin, -sin, -cos, left * ratio, top * ratio);
  }
}

/** The reader's zoom, applied to the fitted view. It does not depend on pixels, and so fits a canvas of any size. */
export class Zoom {
  /** The fitted view itself. */
  static NONE = new Zoom(1, 0, 0);
  static MIN = 1 / 64;
  static MAX = 64;

  /**
   * @param {number} factor magnification of the fitted view
   * @param {number} x offset of the view's middle from that of the fitted view, in the model's unit of length
   * @param {number} y
   */
  constructor(factor, x, y) {
    this.factor = factor;
    this.x = x;
    this.y = y;
    Object.freeze(this);
  }

  /**
   * The zoom from the fitted view to another, with its factor within limits and the canvas's middle within the bounds.
   * @param {Transform} fit
   * @param {Transform} view
   * @param {readonly number[]} bounds xmin, ymin, xmax, ymax
   * @param {number} width of the canvas
   * @param {number} height
   */
  static between(fit, view, [xmin, ymin, xmax, ymax], width, height) {
    const factor = within(view.scale / fit.scale, Zoom.MIN, Zoom.MAX);
    const [x, y] = view.toModel(width / 2, height / 2);
    const [fitX, fitY] = fit.toModel(width / 2, height / 2);
    return new Zoom(factor, within(x, xmin, xmax) - fitX, within(y, ymin, ymax) - fitY);
  }

  /**
   * @param {Transform} fit
   * @param {number} width of the canvas
   * @param {number} height
   * @returns {Transform} the zoomed view
   */
  upon(fit, width, height) {
    const [x, y] = [this.x * fit.scale, this.y * fit.scale];
    return fit.moved(-x, y).scaled(this.factor, width / 2, height / 2);
  }
}

/**
 * @param {number} value
 * @param {number} least
 * @param {number} most
 */
function within(value, least, most) {
  return Math.min(Math.max(value, least), most);
}
