// The view transform: model coordinates (y up) to screen pixels (y down). The only place where y flips.

/** An immutable, invertible map: x ↦ left + scale·x, y ↦ top − scale·y. */
export class Transform {
  /**
   * @param {number} scale pixels per unit of length
   * @param {number} left where the model's origin is on the screen
   * @param {number} top
   */
  constructor(scale, left, top) {
    this.scale = scale;
    this.left = left;
    this.top = top;
    Object.freeze(this);
  }

  /**
   * The largest picture of the bounds that leaves a margin in a rectangle of the screen.
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
   * Makes a canvas draw in the coordinates of a body that stands at (x, y), turned by an angle.
   * @param {CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D} context
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
