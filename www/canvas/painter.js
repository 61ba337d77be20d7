// Painting of display lists. This module knows looks and colours, but not the meaning of the shapes.
import { outlined } from "assur/canvas/outline.js";
import { textWidth } from "assur/canvas/text-width.js";

/**
 * @typedef {import("assur/canvas/display-list.js").Layer} Layer
 * @typedef {import("assur/canvas/display-list.js").Shape} Shape
 * @typedef {import("assur/canvas/transform.js").Transform} Transform
 *
 * @typedef {Pick<CanvasRenderingContext2D, "fillStyle" | "strokeStyle" | "globalAlpha" | "lineWidth" | "lineJoin" | "lineCap"
 *   | "font" | "textAlign" | "textBaseline" | "beginPath" | "closePath" | "moveTo" | "lineTo" | "arc" | "fillRect" | "fillText"
 *   | "strokeText" | "measureText"> & {
 *   fill(path?: Path2D, rule?: CanvasFillRule): void,
 *   stroke(path?: Path2D): void,
 *   setLineDash(dash: readonly number[]): void,
 *   setTransform(a: number, b: number, c: number, d: number, e: number, f: number): void,
 * }} Context
 * The part of a canvas context that painting uses. The class Svg of export/svg.js has this part, too.
 *
 * @typedef {{ readonly context: Context, readonly ratio: number }} Target
 * Target of painting. `context`: where to paint. `ratio`: device pixels per CSS pixel.
 *
 * @typedef {Readonly<{ fill?: number, paper?: boolean, stroke?: number, opacity?: number, dash?: readonly number[] }>} Look
 * Look of a shape. `fill`: opacity of the filling. `paper`: whether the filling has the colour of the paper.
 * `stroke`: width of the line, in pixels. `opacity`, `dash`: opacity and dashes of the line.
 */

/** @type {readonly Look[]} looks by their numbers in the display list */
const LOOKS = [
  { fill: 1 }, // solid
  { fill: 0.16, stroke: 1.5 }, // pale
  { stroke: 2 }, // line
  { stroke: 2, opacity: 0.6, dash: [6, 5] }, // dashed
  { stroke: 1 }, // thin
  { paper: true, stroke: 2 }, // hollow
  { fill: 0.55 }, // soft
];

const TEXT_SIZE = 15;
/** Size of text on a small drawing, relative to the usual size. */
const SMALL = 0.85;
/** Label with a subscript: a Greek letter with one letter, or K (a centre of curvature) with the name of its point. Others are written as they are. */
const INDEXED = /^(\p{Script=Greek}(?=_\p{L}$)|K)_(\p{L}[\p{L}\p{N}]*)$/u;
/** Size of a subscript relative to the text, and its distance below the text, in heights of the text. */
const LOW = Object.freeze({ size: 0.75, below: 0.25 });
/** Width of the line painted under a text as its halo, in pixels. */
const HALO = 4;
/** @type {number[]} */
const NO_DASH = [];

export class Painter {
  #theme;
  /** @type {WeakMap<Shape, { width: number, band: Path2D }>} for polygons, the band painted in place of a line */
  #bands = new WeakMap();

  /** @param {import("assur/canvas/theme.js").Theme} theme */
  constructor(theme) {
    this.#theme = theme;
  }

  /**
   * @param {Target} target
   * @param {readonly Layer[]} layers
   * @param {Transform} view
   * @param {readonly (readonly number[])[]} poses x, y and angle of each body
   */
  shapes({ context, ratio }, layers, view, poses) {
    context.lineJoin = "round";
    context.lineCap = "round";
    for (const layer of layers) {
      const [x, y, angle] = poses[layer.body];
      view.place(context, ratio, x, y, angle);
      for (const shape of layer.shapes) this.#shape(context, shape, view.scale);
    }
    context.globalAlpha = 1;
    context.setLineDash(NO_DASH);
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
  }

  /**
   * @param {Target} target
   * @param {readonly Layer[]} layers
   * @param {Transform} view
   * @param {readonly (readonly number[])[]} poses
   * @param {(label: string) => string} write gives the text of a label
   * @param {import("assur/canvas/places.js").Places} places finds the places of the labels
   * @param {boolean} small whether the drawing is small: its text is then smaller, and a label without a free place is omitted
   */
  labels({ context, ratio }, layers, view, poses, write, places, small) {
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    const size = TEXT_SIZE * this.#theme.scale * (small ? SMALL : 1);
    const font = `600 ${size}px ${this.#theme.font}`;
    context.font = font;
    for (const layer of layers) {
      if (layer.labels.length === 0) continue;
      const place = placing(layer, view, poses);
      for (const label of layer.labels) {
        const written = write(label.label);
        const [, text = written, low = ""] = INDEXED.exec(written) ?? [];
        const [left, top] = place(label);
        const wanted = { x: left, y: top, dx: label.dx * size, dy: -label.dy * size };
        const width = textWidth(context, font, text);
        const more = low === "" ? 0 : LOW.size * textWidth(context, font, low);
        const spot = places.take(label.label, wanted, width + more, size);
        if (!spot.free && small) continue;
        const colour = this.#theme.colours[label.role];
        this.#write(context, text, colour, spot.x - more / 2, spot.y);
        if (low === "") continue;
        context.font = `600 ${LOW.size * size}px ${this.#theme.font}`;
        this.#write(context, low, colour, spot.x + width / 2, spot.y + LOW.below * size);
        context.font = font;
      }
    }
  }

  /**
   * @param {Context} context with the font set
   * @param {string} text
   * @param {string} colour
   * @param {number} x middle of the text
   * @param {number} y
   */
  #write(context, text, colour, x, y) {
    context.textAlign = "center";
    context.textBaseline = "middle";
    context.lineJoin = "round";
    context.lineWidth = HALO;
    context.strokeStyle = this.#theme.ground;
    context.strokeText(text, x, y);
    context.fillStyle = colour;
    context.fillText(text, x, y);
  }

  /**
   * @param {Context} context
   * @param {Shape} shape
   * @param {number} scale
   */
  #shape(context, shape, scale) {
    const { role, look, path, loops } = shape;
    const { fill, paper, stroke, opacity = 1, dash = NO_DASH } = LOOKS[look];
    const colour = this.#theme.colours[role];
    if (paper || fill) {
      context.globalAlpha = fill ?? 1;
      context.fillStyle = paper ? this.#theme.colours.paper : colour;
      context.fill(path, "evenodd");
    }
    const pixel = this.#theme.weight / scale;
    // A band is faster than a line only on a pixel canvas. A vector picture keeps the line.
    if (stroke && loops && dash === NO_DASH && "canvas" in context) {
      context.globalAlpha = opacity;
      context.fillStyle = colour;
      context.fill(this.#band(shape, loops, stroke * pixel));
    } else if (stroke) {
      context.globalAlpha = opacity;
      context.strokeStyle = colour;
      context.lineWidth = stroke * pixel;
      context.setLineDash(dash.map((length) => length * pixel));
      context.stroke(path);
    }
  }

  /**
   * @param {Shape} shape
   * @param {readonly import("assur/canvas/display-list.js").List[]} loops
   * @param {number} width
   * @returns {Path2D}
   */
  #band(shape, loops, width) {
    let known = this.#bands.get(shape);
    if (known?.width !== width) {
      known = { width, band: outlined(loops, width) };
      this.#bands.set(shape, known);
    }
    return known.band;
  }
}

/**
 * @param {readonly Layer[]} layers
 * @param {Transform} view
 * @param {readonly (readonly number[])[]} poses x, y and angle of each body
 * @returns {{ x: number, y: number }[]} the points of all labels, in pixels
 */
export function labelledPoints(layers, view, poses) {
  return layers.flatMap((layer) => layer.labels.map(placing(layer, view, poses)).map(([x, y]) => ({ x, y })));
}

/**
 * @param {Layer} layer
 * @param {Transform} view
 * @param {readonly (readonly number[])[]} poses
 * @returns {(at: { x: number, y: number }) => [number, number]} gives the pixels of a point of the layer's body
 */
function placing({ body }, view, poses) {
  const [x, y, angle] = poses[body];
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  return (at) => view.toScreen(x + cos * at.x - sin * at.y, y + sin * at.x + cos * at.y);
}
