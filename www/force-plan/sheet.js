// One picture of forces: on its canvas on the page, and as a picture for print and SVG.
import { readDisplayList } from "assur/canvas/display-list.js";
import { labelledPoints, Painter } from "assur/canvas/painter.js";
import { Places } from "assur/canvas/places.js";
import { Surface } from "assur/canvas/surface.js";
import { Transform } from "assur/canvas/transform.js";
import { make, write } from "assur/core/dom.js";
import { unitsOf } from "assur/force-plan/equations.js";
import { alongLines, roundBelow } from "assur/polygons/close-up.js";
import { amount } from "assur/polygons/equations.js";

/**
 * @typedef {import("assur/types/web.js").ForcePictureHere} Here
 * @typedef {import("assur/canvas/painter.js").Target} Target
 * @typedef {import("assur/canvas/theme.js").Theme} Theme
 */

/** Free room around a picture for names, in pixels. */
const MARGIN = 28;
/** Height of the strip for the scale bar, in pixels. */
const STRIP = 16;
/** Greatest length of the scale bar, as a share of the width. */
const BAR = 0.4;
/** Size of the text beside the scale bar, in pixels. */
const TEXT = 13;
/** Size of a picture for print and SVG, in pixels. */
const PRINTED = Object.freeze({ width: 420, height: 360 });
/** Pose of the frame, the only body. */
const POSES = Object.freeze([Object.freeze([0, 0, 0])]);

export class Sheet {
  #page;
  #surface;
  #places = new Places();
  /** @type {Here | null} */
  #here = null;
  #title = make("span");
  #save;

  /**
   * @param {import("assur/app/page.js").Page} page
   * @param {string} name of the picture: part of its id, and of the name of its file
   */
  constructor(page, name) {
    this.#page = page;
    this.name = name;
    this.canvas = make("canvas", { id: `${name}-picture`, role: "img" });
    this.#surface = new Surface(this.canvas, () => this.#repaint());
    this.#save = make("button", { type: "button", class: "control", id: `${name}-svg`, "data-t": "force_plan.save", onclick: () => this.#download() });
    this.element = make("figure", { class: "force-figure" }, [this.canvas, make("figcaption", {}, [this.#title, this.#save])]);
  }

  /**
   * @param {Here} here
   * @param {string} title
   */
  show(here, title) {
    this.#here = here;
    write(this.#title, title);
    this.canvas.setAttribute("aria-label", title);
    this.#repaint();
  }

  /**
   * @param {Here | null} [here] picture data; by default those of the shown picture
   * @returns {import("assur/export/pictures.js").Picture}
   */
  picture(here = this.#here) {
    /** @type {import("assur/export/pictures.js").Picture["paint"]} */
    const paint = (target, theme, newPath) => {
      const { context, ratio } = target;
      context.setTransform(ratio, 0, 0, ratio, 0, 0);
      context.fillStyle = theme.colours.paper;
      context.fillRect(0, 0, PRINTED.width, PRINTED.height);
      if (here) this.#paint(here, target, theme, PRINTED, new Places(), newPath);
    };
    return { size: PRINTED, paint };
  }

  #repaint() {
    const surface = this.#surface;
    if (!this.#here || !surface.begin()) return;
    surface.clear();
    this.#paint(this.#here, surface, this.#page.theme, surface, this.#places);
  }

  /**
   * @param {Here} here
   * @param {Target} target
   * @param {Theme} theme
   * @param {{ width: number, height: number }} size
   * @param {Places} places
   * @param {() => Path2D} [newPath]
   */
  #paint({ list, names, bounds, scale }, target, theme, { width, height }, places, newPath = () => new Path2D()) {
    const painter = new Painter(theme);
    const layers = readDisplayList(Float32Array.from(list), 0, this.#page.engine.roles, names, newPath);
    const view = Transform.fit(bounds, width, height - STRIP, MARGIN);
    painter.shapes(target, layers, view, POSES);
    places.begin({ width, height: height - STRIP }, labelledPoints(layers, view, POSES), alongLines(layers, view));
    painter.labels(target, layers, view, POSES, (name) => name, places, false);
    if (scale === null) return;
    const perPixel = scale / view.scale;
    const bar = roundBelow(BAR * width * perPixel);
    const { words, engine } = this.#page;
    paintBar(target, theme, bar / perPixel, height, amount(bar, unitsOf(words, engine.lengths).force, words));
  }

  async #download() {
    const [{ paperTheme, toSvg }, { download }, { withoutExtras }] = await Promise.all([
      import("assur/export/pictures.js"), import("assur/core/download.js"), import("assur/state/state.js"),
    ]);
    const { engine, model } = this.#page;
    const theme = paperTheme(engine.roles);
    const file = `assur-${engine.catalogue.fileName(withoutExtras(model.lastAccepted))}-${this.name}.svg`;
    download(toSvg(this.picture(), theme, this.canvas.getAttribute("aria-label") ?? ""), file);
  }
}

/**
 * @param {Target} target
 * @param {Theme} theme
 * @param {number} length in pixels
 * @param {number} height of the picture
 * @param {string} text force that the bar represents
 */
function paintBar({ context, ratio }, theme, length, height, text) {
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  const [left, middle] = [10, height - 9];
  context.strokeStyle = theme.colours.ink;
  context.lineWidth = 2;
  context.beginPath();
  for (const [x0, y0, x1, y1] of [[0, 0, length, 0], [0, -4, 0, 4], [length, -4, length, 4]]) {
    context.moveTo(left + x0, middle + y0);
    context.lineTo(left + x1, middle + y1);
  }
  context.stroke();
  context.font = `${TEXT}px ${theme.font}`;
  context.textAlign = "left";
  context.textBaseline = "middle";
  context.fillStyle = theme.colours.ink;
  context.fillText(text, left + length + TEXT / 2, middle);
}
