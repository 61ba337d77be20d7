// Painting of a snapshot, in the same way on the screen's canvas and in an exported picture.
import { circleBounds, readDisplayList } from "assur/canvas/display-list.js";
import { labelledPoints, Painter } from "assur/canvas/painter.js";
import { Places } from "assur/canvas/places.js";
import { degrees } from "assur/core/angles.js";
import { readable } from "assur/core/numbers.js";
import { partsOf } from "assur/core/quantity.js";
import { isLength, subscript } from "assur/core/symbols.js";
import { paintSquares } from "assur/stage/paper.js";

/**
 * @typedef {import("assur/canvas/display-list.js").Layer} Layer
 * @typedef {Pick<import("assur/state/model.js").Snapshot, "scene" | "frame" | "frameInput" | "coordinate" | "readouts" | "revision" | "words">
 *   & { readonly compared?: import("assur/state/compared.js").Comparison | null, readonly withheld?: ReadonlySet<string>, readonly summary?: object, readonly state?: { readonly view: { readonly playing: boolean } } }} Snapshot
 * @typedef {import("assur/canvas/painter.js").Target} Target
 * @typedef {import("assur/canvas/theme.js").Theme} Theme
 * @typedef {import("assur/canvas/transform.js").Transform} Transform
 * @typedef {{ readonly width: number, readonly height: number }} Size in CSS pixels
 */

export class Figure {
  #engine;
  #theme;
  #painter;
  #newPath;
  #places;
  /** @type {Snapshot | null} */
  #snapshot = null;
  #revision = 0;
  /** @type {readonly Layer[]} fixed shapes, painted under the moving ones */
  #still = [];
  /** @type {readonly Layer[]} shapes fixed to moving bodies */
  #rigid = [];
  /** @type {readonly Layer[]} shapes that change in motion */
  #changing = [];
  /** @type {readonly (readonly number[])[]} x, y and angle of each body */
  #poses = [];
  /** @type {Figure | null} figure of mechanism A, if it is shown */
  #compared = null;

  /**
   * @param {Pick<import("assur/engine.js").Engine, "roles" | "labels">} engine
   * @param {Theme} theme
   * @param {() => Path2D} [newPath] makes an empty path of the kind that the targets take
   * @param {Places} [places] positions of the labels, which this figure may share with another one
   */
  constructor(engine, theme, newPath = () => new Path2D(), places = new Places()) {
    this.#places = places;
    this.#engine = engine;
    this.#theme = theme;
    this.#painter = new Painter(theme);
    this.#newPath = newPath;
  }

  /** Positions of the labels. */
  get places() {
    return this.#places;
  }

  /** @returns {(readonly number[])[]} bounds, in the frame's coordinates, of each label and circle that changes in motion: xmin, ymin, xmax, ymax */
  marks() {
    const layers = this.#changing.filter(({ body }) => body === 0);
    const labels = layers.flatMap((layer) => layer.labels).map(({ x, y }) => [x, y, x, y]);
    const circles = layers.flatMap(({ shapes }) => shapes).flatMap(({ record }) => circleBounds(record));
    return [...labels, ...circles];
  }

  /** @param {Snapshot} snapshot snapshot to paint from now on */
  take(snapshot) {
    this.#snapshot = snapshot;
    const { scene, frame, revision } = snapshot;
    if (this.#revision !== revision) {
      this.#revision = revision;
      const layers = this.#read(scene, 0, [...this.#still, ...this.#rigid]);
      this.#still = layers.filter(({ body }) => body === 0);
      this.#rigid = layers.filter(({ body }) => body !== 0);
    }
    const { poses, end } = readPoses(frame);
    this.#poses = poses;
    this.#changing = this.#read(frame, end);
    this.#takeComparison(snapshot);
  }

  /** @param {Snapshot} snapshot */
  #takeComparison({ compared, ...rest }) {
    if (!compared) {
      this.#compared = null;
      return;
    }
    const { scene, frame, labels, revision } = compared;
    if (!this.#compared || this.#compared.#revision !== revision) {
      this.#compared = new Figure({ roles: this.#engine.roles, labels }, muted(this.#theme), this.#newPath);
    }
    this.#compared.take({ ...rest, scene, frame, revision });
  }

  /**
   * Paints squared paper with the fixed shapes.
   * @param {Target} target
   * @param {Size} size
   * @param {Transform} view
   */
  paintGround(target, size, view) {
    if (!this.#snapshot) return;
    paintSquares(target.context, size, view, this.#theme, this.#snapshot.words, target.ratio);
    this.paintStill(target, view);
  }

  /**
   * Paints the fixed shapes.
   * @param {Target} target
   * @param {Transform} view
   */
  paintStill(target, view) {
    this.#painter.shapes(target, this.#still, view, this.#poses);
  }

  /**
   * Paints the moving shapes, over mechanism A if it is shown.
   * @param {Target} target
   * @param {Transform} view
   */
  paintMoving(target, view) {
    this.#compared?.paintStill(target, view);
    this.#compared?.paintMoving(target, view);
    this.#painter.shapes(target, this.#rigid, view, this.#poses);
    this.#painter.shapes(target, this.#changing, view, this.#poses);
  }

  /**
   * @param {Target} target
   * @param {Transform} view
   * @param {Size} size of the target
   * @param {boolean} small whether the drawing is small
   */
  paintLabels(target, view, size, small) {
    const snapshot = this.#snapshot;
    if (!snapshot) return;
    const write = (/** @type {string} */ label) => labelText(label, snapshot);
    const all = [this.#still, this.#rigid, this.#changing];
    this.#places.begin(size, labelledPoints(all.flat(), view, this.#poses));
    for (const layers of all) {
      this.#painter.labels(target, layers, view, this.#poses, write, this.#places, small);
    }
  }

  /**
   * @param {import("assur/canvas/display-list.js").List} list
   * @param {number} start
   * @param {readonly Layer[]} [before]
   */
  #read(list, start, before) {
    return readDisplayList(list, start, this.#engine.roles, this.#engine.labels, this.#newPath, before);
  }
}

/**
 * @param {Theme} theme
 * @returns {Theme} the theme with one colour for all roles except the paper
 */
function muted(theme) {
  let revision = -1;
  /** @type {Record<string, string>} */
  let colours = {};
  const get = () => {
    if (revision !== theme.revision) {
      revision = theme.revision;
      const { paper, secondary } = theme.colours;
      colours = { ...Object.fromEntries(Object.keys(theme.colours).map((role) => [role, secondary])), paper };
    }
    return colours;
  };
  return Object.create(theme, { colours: { get } });
}

/**
 * @param {Float32Array} frame
 * @returns {{ poses: (readonly number[])[], end: number }} `poses`: x, y and angle of each body; `end`: start of the display list
 */
function readPoses(frame) {
  const bodies = frame[0];
  const poses = [];
  for (let body = 0; body < bodies; body++) poses.push([...frame.subarray(1 + 3 * body, 4 + 3 * body)]);
  return { poses, end: 1 + 3 * bodies };
}

/**
 * Returns the text of a label: the name of a point, or a symbol with its value in the drawn frame.
 * @param {string} label name of a point, or a symbol and the name of its read-out, separated by a tab, which no name contains
 * @param {Snapshot} snapshot
 */
function labelText(label, { frameInput, coordinate, readouts, words, state, withheld }) {
  const [symbol, readout] = label.split("\t");
  if (readout === undefined) return low(label);
  const decimals = readable(1, state?.view.playing ?? false);
  if (readout === "input") return `${symbol} = ${coordinate.text(frameInput, words, decimals)}`;
  const value = readouts?.value(readout);
  if (value === undefined) return symbol;
  if (withheld?.has(readout)) return `${symbol} = ?`;
  const length = isLength(partsOf(readout).what);
  return `${symbol} = ${length ? words.length(words.numbers.short(value)) : `${words.numbers.fixed(degrees(value), decimals)}°`}`;
}

/** @param {string} label */
function low(label) {
  return label.replace(/(?<=\p{L})\d/gu, subscript);
}
