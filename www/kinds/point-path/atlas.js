// The atlas: coupler curves over two lengths of the four-bar, shaded by a chosen property. A pressed curve is
// placed on the path.
import { Surface } from "assur/canvas/surface.js";
import { sentence } from "assur/controls/problems.js";
import { section } from "assur/controls/section.js";
import { make, setData, write } from "assur/core/dom.js";
import { attempt } from "assur/core/problem.js";
import { Seen } from "assur/core/seen.js";
import { choose } from "assur/kinds/point-path/choose.js";
import { missedBy } from "assur/kinds/point-path/verdict.js";
import { withoutExtras } from "assur/state/state.js";

/**
 * @typedef {import("assur/kinds/point-path/verdict.js").Snapshot} Snapshot
 * @typedef {import("assur/types/web.js").AtlasCell} Cell
 * @typedef {import("assur/types/web.js").AtlasHere} Atlas
 * @typedef {import("assur/types/web.js").AtlasRatio} Ratio
 */

/** Properties of a cell that the shades can show, from 0, the lightest, to 1. */
const SHADES = Object.freeze(/** @type {Readonly<Record<string, (cell: Cell) => number>>} */ ({
  likeness: ({ unlikeness }) => (unlikeness === null ? 0 : 1 - unlikeness),
  transmission: ({ transmission }) => (2 * (transmission ?? 0)) / Math.PI,
  turns: ({ grashof }) => (grashof === "crank_rocker" || grashof === "double_crank" ? 1 : 0),
}));

/** Lengths of which one is not on an axis. */
const THIRDS = Object.freeze(/** @type {readonly Ratio[]} */ (["frame", "rocker", "coupler"]));

/** Sliders of the parameters that are not on the axes. The length is relative to the crank, shares to the coupler. */
const SLIDERS = Object.freeze([
  { name: "third", least: 0.6, most: 6, usual: 3 },
  { name: "along", least: -1, most: 2, usual: 0.5 },
  { name: "across", least: -1.5, most: 1.5, usual: 0.5 },
]);
const STEP = 0.05;

/** Senses of the axes. */
const ARROWS = Object.freeze(["→", "↑"]);

/**
 * `ROOM`: room around a curve, as a part of its cell. `DARKEST`: greatest opacity of a shade. `CONTRAST`: exponent that
 * makes great values stand out.
 */
const ROOM = 0.12;
const DARKEST = 0.7;
const CONTRAST = 3;

/** Steps of the mark, in columns and rows, for the arrow keys. */
const KEYS = Object.freeze(/** @type {Readonly<Record<string, readonly [number, number]>>} */ ({ ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }));

export class AtlasView {
  #page;
  #surface;
  #canvas = make("canvas", { id: "path-atlas", class: "map", role: "img", tabindex: "0" });
  #shade = make("select", { id: "path-atlas-shade", class: "control", "data-t-label": "path.atlas.shade" }, Object.keys(SHADES).map((name) => make("option", { value: name, "data-t": `path.atlas.shade.${name}` })));
  #axes = make("select", { id: "path-atlas-axes", class: "control", "data-t-label": "path.atlas.axes" }, THIRDS.map((name) => make("option", { value: name, "data-t": `path.atlas.without.${name}` })));
  #sliders = SLIDERS.map(({ name, least, most, usual }) => {
    const input = make("input", { id: `path-atlas-${name}`, type: "range", min: String(least), max: String(most), step: String(STEP), value: String(usual) });
    const [title, value] = [make("span", {}), make("output", {})];
    return { name, input, title, value, element: make("label", {}, [title, " ", value, input]) };
  });
  /** Names and ranges of the axes, to the right and upwards. */
  #names = [make("p", { class: "atlas-axis" }), make("p", { class: "atlas-axis" })];
  #told = make("p", { id: "path-atlas-told", role: "status" });
  #details;
  /** @type {Atlas | null} */
  #atlas = null;
  /** Index of the marked cell. */
  #at = 0;
  /** @type {Snapshot | null} */
  #snapshot = null;
  #computed = new Seen();
  #painted = new Seen();

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    this.#page = page;
    this.#surface = new Surface(this.#canvas, () => this.#paint());
    const [across, up] = this.#names;
    const content = make("div", {}, [this.#axes, this.#shade, ...this.#sliders.map(({ element }) => element), make("p", { "data-t": "path.atlas.hint" }), up, this.#canvas, across, this.#told]);
    this.#details = make("details", { id: "path-atlas-fold" }, [make("summary", { "data-t": "path.atlas" }), content]);
    this.#details.addEventListener("toggle", () => this.#show());
    this.#axes.addEventListener("change", () => this.#show());
    this.#shade.addEventListener("change", () => this.#paint());
    for (const { input } of this.#sliders) input.addEventListener("input", () => this.#show());
    this.#canvas.addEventListener("pointermove", (event) => this.#mark(this.#cellAt(event)));
    this.#canvas.addEventListener("click", (event) => this.#take(this.#cellAt(event)));
    this.#canvas.addEventListener("keydown", (event) => this.#key(event));
    section("point-path", "path.atlas_heading", "atlas", [this.#details]);
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    this.#snapshot = snapshot;
    this.#show();
  }

  /** @returns {import("assur/types/web.js").AtlasPage} */
  get #asked() {
    const [ratio, along, across] = this.#sliders.map(({ input }) => input.valueAsNumber);
    return { third: this.#third, ratio, point: [along, across] };
  }

  /** @returns {Ratio} the length that is not on an axis */
  get #third() {
    return THIRDS[this.#axes.selectedIndex];
  }

  #show() {
    const snapshot = this.#snapshot;
    if (!snapshot || !this.#details.open) return;
    const { state, words } = snapshot;
    const asked = this.#asked;
    const { path, course } = state.document;
    const { theme, engine } = this.#page;
    if (!this.#computed.same(path, course, JSON.stringify(asked))) {
      const { value } = attempt(() => engine.functions.pathAtlas(withoutExtras(state), asked));
      this.#atlas = value ?? null;
    }
    if (this.#painted.same(this.#atlas, words, theme.revision)) return;
    for (const { name, input, title, value } of this.#sliders) {
      const { min, max, valueAsNumber: at } = input;
      write(title, words.text(`path.atlas.${name === "third" ? this.#third : name}`));
      write(value, words.numbers.upTo(at, 2));
      input.style.setProperty("--fill", String((at - Number(min)) / (Number(max) - Number(min))));
    }
    const [from, to] = this.#atlas?.range.map((ratio) => words.numbers.upTo(ratio, 2)) ?? [];
    for (const [k, ratio] of this.#atlas?.axes.entries() ?? []) write(this.#names[k], `${ARROWS[k]} ${words.text("path.atlas.axis", { ratio: words.text(`path.atlas.${ratio}`), from, to })}`);
    this.#mark(this.#at);
    this.#paint();
  }

  /**
   * @param {MouseEvent} event
   * @returns {number} index of the cell under the pointer
   */
  #cellAt({ offsetX, offsetY }) {
    const { count = 1 } = this.#atlas ?? {};
    const { width, height } = this.#surface;
    const part = (/** @type {number} */ at, /** @type {number} */ all) => Math.min(Math.max(Math.floor((count * at) / Math.max(all, 1)), 0), count - 1);
    return part(offsetX, width) + count * (count - 1 - part(offsetY, height));
  }

  /** @param {number} index */
  #mark(index) {
    const words = this.#snapshot?.words;
    const cell = this.#atlas?.cells[index];
    if (!cell || !words) return;
    const moved = index !== this.#at;
    this.#at = index;
    const { numbers } = words;
    const [coupler, rocker, frame] = cell.lengths.map((length) => numbers.upTo(length, 2));
    const type = words.text(cell.grashof === null ? "path.atlas.none" : `grashof.${cell.grashof}`);
    this.#canvas.ariaLabel = words.text("path.atlas.cell", { coupler, rocker, frame, type });
    write(this.#told, this.#canvas.ariaLabel);
    setData(this.#canvas, "cell", String(index));
    if (moved) this.#paint();
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    const { count = 1 } = this.#atlas ?? {};
    const [right, up] = KEYS[event.key] ?? [0, 0];
    const pressed = event.key === "Enter" || event.key === " ";
    if (!pressed && right === 0 && up === 0) return;
    event.preventDefault();
    if (pressed) {
      this.#take(this.#at);
      return;
    }
    const within = (/** @type {number} */ at) => Math.min(Math.max(at, 0), count - 1);
    this.#mark(within((this.#at % count) + right) + count * within(Math.floor(this.#at / count) + up));
  }

  /**
   * Places the linkage of a cell on the path.
   * @param {number} index
   */
  #take(index) {
    const snapshot = this.#snapshot;
    if (!snapshot || !this.#atlas) return;
    this.#mark(index);
    const { words } = snapshot;
    const { value: found, problems } = attempt(() => this.#page.engine.functions.pathOfCell(withoutExtras(snapshot.state), this.#asked, index));
    if (!found) {
      write(this.#told, problems.length > 0 ? problems.map((problem) => sentence(problem, words)).join(" ") : words.text("path.atlas.unplaced"));
      return;
    }
    this.#page.history.close();
    choose(this.#page, found.linkage);
    write(this.#told, `${this.#canvas.ariaLabel} ${words.text("path.atlas.placed", { missed: missedBy(found, snapshot.summary.size, words) })}`);
  }

  #paint() {
    const atlas = this.#atlas;
    if (!this.#details.open || !this.#surface.begin()) return;
    this.#surface.clear();
    if (!atlas) return;
    const { context, width, height } = this.#surface;
    const { colours, weight } = this.#page.theme;
    const { count, cells } = atlas;
    const [wide, high] = [width / count, height / count];
    const shade = SHADES[this.#shade.value];
    for (const [index, cell] of cells.entries()) {
      const [left, top] = [(index % count) * wide, (count - 1 - Math.floor(index / count)) * high];
      if (cell.grashof !== null) {
        context.globalAlpha = DARKEST * shade(cell) ** CONTRAST;
        context.fillStyle = colours.rocker;
        context.fillRect(left, top, wide, high);
        context.globalAlpha = 1;
        this.#curve(cell.curve, [left, top, wide, high], colours.ink);
      }
      if (index === this.#at) {
        context.strokeStyle = colours.crank;
        context.lineWidth = 2 * weight;
        context.strokeRect(left + 1, top + 1, wide - 2, high - 2);
      }
    }
  }

  /**
   * @param {readonly number[]} curve x and y in turn
   * @param {readonly number[]} box left, top, width and height
   * @param {string} colour
   */
  #curve(curve, [left, top, width, height], colour) {
    const { context } = this.#surface;
    const [xs, ys] = [0, 1].map((axis) => curve.filter((_, k) => k % 2 === axis));
    const [xmin, xmax, ymin, ymax] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
    const inner = 1 - 2 * ROOM;
    const scale = Math.min((inner * width) / Math.max(xmax - xmin, Number.MIN_VALUE), (inner * height) / Math.max(ymax - ymin, Number.MIN_VALUE));
    const [x0, y0] = [left + width / 2 - (scale * (xmin + xmax)) / 2, top + height / 2 + (scale * (ymin + ymax)) / 2];
    if (!Number.isFinite(x0 + y0 + scale)) return;
    context.beginPath();
    for (const [k, x] of xs.entries()) context.lineTo(x0 + scale * x, y0 - scale * ys[k]);
    context.strokeStyle = colour;
    context.lineWidth = 1;
    context.stroke();
  }
}
