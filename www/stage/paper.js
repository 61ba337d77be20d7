// Background of the drawing: squared paper with its scale and the fixed shapes. While it is unchanged, each frame takes it from a copy.

/**
 * @typedef {import("assur/canvas/painter.js").Context} Context
 * @typedef {import("assur/canvas/theme.js").Theme} Theme
 */

/** Least width of the squares, in pixels. */
const SQUARE = 44;

export class Backdrop {
  /** Content of the last frame, and content of the copy. */
  #shown = "";
  #copied = "";
  #context;

  constructor() {
    const context = new OffscreenCanvas(1, 1).getContext("2d", { alpha: false });
    if (!context) throw new Error("no 2d context");
    this.#context = context;
  }

  /**
   * Covers a surface with the backdrop. Content that differs from that of the last frame is painted on the surface itself, because
   * the next frame may differ again. Content shown a second time is copied.
   * @param {import("assur/canvas/surface.js").Surface} surface
   * @param {string} key identifies the content: a different key means different content
   * @param {(target: import("assur/canvas/painter.js").Target) => void} paint paints the content
   */
  cover(surface, key, paint) {
    const { context, ratio } = surface;
    const { width, height } = surface.canvas;
    const wanted = `${key} ${width}×${height} ${ratio}`;
    if (wanted !== this.#shown) {
      this.#shown = wanted;
      surface.toPixels();
      paint(surface);
      return;
    }
    const { canvas } = this.#context;
    if (wanted !== this.#copied) {
      this.#copied = wanted;
      // Setting the size of a canvas, even to the same value, clears and reallocates it.
      if (canvas.width !== width) canvas.width = width;
      if (canvas.height !== height) canvas.height = height;
      this.#context.setTransform(ratio, 0, 0, ratio, 0, 0);
      paint({ context: this.#context, ratio });
    }
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.drawImage(canvas, 0, 0);
    surface.toPixels();
  }
}

/**
 * @param {number} scale pixels per unit of length
 * @returns {number} length of the side of a square: 1, 2 or 5 times a power of ten
 */
export function side(scale) {
  return roundUp(SQUARE / scale);
}

/**
 * Paints squares of a round size, and a scale bar with the length of their side.
 * @param {Context} context
 * @param {import("assur/stage/figure.js").Size} size
 * @param {import("assur/canvas/transform.js").Transform} view
 * @param {Theme} theme
 * @param {import("assur/core/words.js").Words} words
 * @param {number} ratio device pixels per CSS pixel
 */
export function paintSquares(context, { width, height }, view, theme, words, ratio) {
  const length = side(view.scale);
  const pixels = length * view.scale;
  context.fillStyle = theme.ground;
  context.fillRect(0, 0, width, height);
  const line = sharp(theme.weight, ratio);
  context.beginPath();
  for (let x = positive(view.left, pixels); x < width; x += pixels) {
    context.moveTo(line.at(x), 0);
    context.lineTo(line.at(x), height);
  }
  for (let y = positive(view.top, pixels); y < height; y += pixels) {
    context.moveTo(0, line.at(y));
    context.lineTo(width, line.at(y));
  }
  context.lineWidth = line.width;
  context.globalAlpha = 0.55;
  context.strokeStyle = theme.colours.line;
  context.stroke();
  context.globalAlpha = 1;
  paintScaleBar(context, height, pixels, words.length(words.numbers.short(length)), theme, ratio);
}

/**
 * @param {Context} context
 * @param {number} height of the paper
 * @param {number} length
 * @param {string} text
 * @param {Theme} theme
 * @param {number} ratio
 */
function paintScaleBar(context, height, length, text, theme, ratio) {
  const line = sharp(1.5 * theme.weight, ratio);
  const [left, bottom] = [line.at(16), line.at(height - 14)];
  context.beginPath();
  context.moveTo(left, bottom - 5);
  context.lineTo(left, bottom);
  context.lineTo(left + length, bottom);
  context.lineTo(left + length, bottom - 5);
  context.lineWidth = line.width;
  context.strokeStyle = theme.colours.secondary;
  context.stroke();
  context.font = `${12 * theme.scale}px ${theme.font}`;
  context.textAlign = "left";
  context.textBaseline = "alphabetic";
  context.fillStyle = theme.colours.secondary;
  context.fillText(text, left + 5, bottom - 6 - 3 * theme.scale);
}

/**
 * Aligns the edges of a horizontal or vertical line with the pixels, so that a thin line is not pale and twice as wide.
 * @param {number} width
 * @param {number} ratio device pixels per CSS pixel
 * @returns {{ width: number, at(coordinate: number): number }} `width`: the line's width; `at`: the coordinate moved into line with the pixels
 */
function sharp(width, ratio) {
  const aligned = Math.max(Math.round(width * ratio), 1) / ratio;
  return { width: aligned, at: (coordinate) => Math.round((coordinate - aligned / 2) * ratio) / ratio + aligned / 2 };
}

/**
 * @param {number} length
 * @returns {number} 1, 2 or 5 times a power of ten, not below the length
 */
function roundUp(length) {
  const power = 10 ** Math.floor(Math.log10(length));
  return power * ([1, 2, 5].find((step) => step * power >= length) ?? 10);
}

/**
 * @param {number} value
 * @param {number} period
 * @returns {number} the non-negative remainder
 */
function positive(value, period) {
  return ((value % period) + period) % period;
}
