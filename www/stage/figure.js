// What is painted of a snapshot, alike on the screen's canvas and on an exported picture.
import { readDisplayList } from "assur/canvas/display-list.js";
import { Painter } from "assur/canvas/painter.js";
import { degrees } from "assur/core/angles.js";
import { called } from "assur/core/names.js";
import { subscript } from "assur/core/symbols.js";
import { paintSquares } from "assur/stage/paper.js";

/**
 * @typedef {import("assur/canvas/display-list.js").Layer} Layer
 * @typedef {import("assur/engine.js").Engine} Engine
 * @typedef {Pick<import("assur/state/model.js").Snapshot, "scene" | "frame" | "frameInput" | "coordinate" | "readouts" | "revision" | "words" | "legible"> & { readonly summary?: object }} Snapshot
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
  /** @type {Snapshot | null} */
  #snapshot = null;
  /** @type {Snapshot | null} the one whose numbers stand in the labels: in motion new ones come too fast to be read */
  #legible = null;
  #revision = 0;
  /** @type {readonly Layer[]} what stands still under all that moves */
  #still = [];
  /** @type {readonly Layer[]} */
  #rigid = [];
  /** @type {readonly Layer[]} what changes its shape */
  #changing = [];
  /** @type {readonly (readonly number[])[]} x, y and angle of each body */
  #poses = [];

  /**
   * @param {Engine} engine
   * @param {Theme} theme
   * @param {() => Path2D} [newPath] an empty path of the kind its targets take
   */
  constructor(engine, theme, newPath = () => new Path2D()) {
    this.#engine = engine;
    this.#theme = theme;
    this.#painter = new Painter(theme);
    this.#newPath = newPath;
  }

  /** @param {Snapshot} snapshot what is painted from now on */
  take(snapshot) {
    this.#snapshot = snapshot;
    if (snapshot.legible || this.#legible?.words !== snapshot.words) this.#legible = snapshot;
    const { scene, frame, revision } = snapshot;
    if (this.#revision !== revision) {
      this.#revision = revision;
      const layers = this.#read(scene, 0, [...this.#still, ...this.#rigid]);
      const moving = layers.findIndex(({ body }) => body !== 0);
      this.#still = layers.slice(0, moving);
      this.#rigid = layers.slice(moving);
    }
    const { poses, end } = readPoses(frame);
    this.#poses = poses;
    this.#changing = this.#read(frame, end);
  }

  /**
   * Squared paper, and on it what stands still.
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
   * What stands still.
   * @param {Target} target
   * @param {Transform} view
   */
  paintStill(target, view) {
    this.#painter.shapes(target, this.#still, view, this.#poses);
  }

  /**
   * What moves.
   * @param {Target} target
   * @param {Transform} view
   */
  paintMoving(target, view) {
    this.#painter.shapes(target, this.#rigid, view, this.#poses);
    this.#painter.shapes(target, this.#changing, view, this.#poses);
  }

  /**
   * @param {Target} target
   * @param {Transform} view
   * @param {boolean} small whether there is little room
   */
  paintLabels(target, view, small) {
    const snapshot = this.#legible;
    if (!snapshot) return;
    const write = (/** @type {string} */ label) => labelText(label, snapshot);
    const taken = small ? [] : null;
    for (const layers of [this.#still, this.#rigid, this.#changing]) {
      this.#painter.labels(target, layers, view, this.#poses, write, taken);
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
 * @param {Float64Array} frame
 * @returns {{ poses: (readonly number[])[], end: number }} x, y and angle of each body; where the list after them begins
 */
function readPoses(frame) {
  const bodies = frame[0];
  const poses = [];
  for (let body = 0; body < bodies; body++) poses.push([...frame.subarray(1 + 3 * body, 4 + 3 * body)]);
  return { poses, end: 1 + 3 * bodies };
}

/**
 * @param {string} label a name, or a symbol and the read-out it is written with: `μ=C.transmission`
 * @param {Snapshot} snapshot
 */
function labelText(label, { frameInput, coordinate, readouts, words }) {
  const [symbol, readout] = label.split("=");
  if (readout === undefined) return low(called(label, words));
  if (readout === "input") return `${symbol} = ${coordinate.text(frameInput, words, 1)}`;
  return readouts ? `${symbol} = ${words.numbers.fixed(degrees(readouts[readout]), 1)}°` : symbol;
}

/** @param {string} label */
function low(label) {
  return label.replace(/(?<=\p{L})\d/gu, subscript);
}
