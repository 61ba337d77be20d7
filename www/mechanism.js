// The drawing of the mechanism on its canvas.
import { readDisplayList } from "assur/display-list.js";
import { setData } from "assur/dom.js";
import { Painter } from "assur/painter.js";
import { Sheet } from "assur/sheet.js";
import { Surface } from "assur/surface.js";
import { Transform } from "assur/transform.js";

/**
 * @typedef {import("assur/display-list.js").Layer} Layer
 * @typedef {import("assur/engine.js").Engine} Engine
 * @typedef {import("assur/model.js").Snapshot} Snapshot
 * @typedef {import("assur/theme.js").Theme} Theme
 */

/** Free room around the drawing, in pixels. */
const MARGIN = 44;
const SMALL_MARGIN = 26;

export class MechanismView {
  #surface;
  #sheet = new Sheet();
  #painter;
  #theme;
  #engine;
  /** @type {Snapshot | null} */
  #snapshot = null;
  #revision = 0;
  /** @type {readonly Layer[]} what stands still under all that moves */
  #still = [];
  /** @type {readonly Layer[]} */
  #rigid = [];

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {Engine} engine
   * @param {Theme} theme
   */
  constructor(canvas, engine, theme) {
    this.#engine = engine;
    this.#theme = theme;
    this.#surface = new Surface(canvas, () => this.#draw(), { alpha: false });
    this.#painter = new Painter(theme);
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    this.#snapshot = snapshot;
    if (this.#revision !== snapshot.revision) {
      this.#revision = snapshot.revision;
      const layers = readDisplayList(snapshot.scene, 0, this.#engine.roles, this.#engine.labels);
      const moving = layers.findIndex(({ body }) => body !== 0);
      this.#still = layers.slice(0, moving);
      this.#rigid = layers.slice(moving);
    }
    setData(this.#surface.canvas, "faded", String(snapshot.faded));
    this.#draw();
  }

  #draw() {
    const snapshot = this.#snapshot;
    if (!snapshot || !this.#surface.visible) return;
    const { width, height } = this.#surface;
    const margin = Math.min(width, height) < 320 ? SMALL_MARGIN : MARGIN;
    const view = Transform.fit(snapshot.summary.bounds, width, height, margin);
    const { poses, end } = readPoses(snapshot.frame);
    const moving = readDisplayList(snapshot.frame, end, this.#engine.roles, this.#engine.labels);

    const key = `${snapshot.revision} ${snapshot.words.lang} ${this.#theme.revision}`;
    this.#sheet.cover(this.#surface, key, () => {
      this.#sheet.squares(this.#surface, view, this.#theme, snapshot.words);
      this.#painter.shapes(this.#sheet, this.#still, view, poses);
    });
    this.#painter.shapes(this.#surface, this.#rigid, view, poses);
    this.#painter.shapes(this.#surface, moving, view, poses);
    const write = (/** @type {string} */ label) => labelText(label, snapshot);
    for (const layers of [this.#still, this.#rigid, moving]) {
      this.#painter.labels(this.#surface, layers, view, poses, write);
    }
  }
}

/**
 * @param {Float32Array} frame
 * @returns {{ poses: (readonly number[])[], end: number }} x, y and angle of each body; where the list after them begins
 */
function readPoses(frame) {
  const bodies = frame[0];
  const poses = [];
  for (let body = 0; body < bodies; body++) poses.push([...frame.subarray(1 + 3 * body, 4 + 3 * body)]);
  return { poses, end: 1 + 3 * bodies };
}

/**
 * @param {string} label
 * @param {Snapshot} snapshot
 */
function labelText(label, { frameDeg, words }) {
  if (label === "phi1") return `φ₁ = ${words.numbers.fixed(frameDeg, 1)}°`;
  return label.replace(/(?<=\p{L})\d/gu, (digit) => String.fromCharCode(0x2080 + Number(digit)));
}
