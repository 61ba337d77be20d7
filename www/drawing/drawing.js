// Drawing mode: tools over the drawing, the pointer that uses them, a panel beside the drawing. Loaded on demand.
import { paintAxes } from "assur/drawing/axes.js";
import { Count } from "assur/drawing/count.js";
import { step, unsay } from "assur/drawing/edit.js";
import { Hand } from "assur/drawing/hand.js";
import { paint } from "assur/drawing/marks.js";
import { DrawingRail } from "assur/drawing/rail.js";
import { Selection } from "assur/drawing/selection.js";
import { Palette } from "assur/drawing/palette.js";
import { addPlotsButton } from "assur/drawing/plots-button.js";
import "assur/drawing/style.js";
import { Work } from "assur/drawing/tools.js";
import { byId, setData } from "assur/core/dom.js";
import { attempt } from "assur/core/problem.js";
import { inputNow } from "assur/state/change.js";

/**
 * @typedef {import("assur/state/model.js").AnySnapshot} Snapshot
 * @typedef {import("assur/state/state.js").Documents["linkage"]} Document
 */

/** Key under which the text of the clipboard holds a copied part of a drawing. */
const FORMAT = "assur.drawing";

/** Offset of a pasted part from its original, to the right and down, in steps of the grid. */
const PASTE_OFFSET = 4;

/** Distance of numbers and texts from the edges of the drawing, in pixels. */
const EDGE = 8;

/** Symbol unit on the screen: the shorter side of the drawing divided by `SYMBOLS`, within the limits `SYMBOL`, in pixels. */
const SYMBOLS = 130;
const SYMBOL = Object.freeze([3.6, 4.6]);

export class Drawing {
  #page;
  #selection = new Selection();
  #work;
  #hand;
  #palette;
  #rail;
  #count = new Count();
  #on = false;
  /** Whether the document shown last was an empty sheet. */
  #empty = false;

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    this.#page = page;
    this.#work = new Work(page);
    this.#hand = new Hand(page, this.#work, this.#selection, () => page.mechanism.repaint());
    this.#palette = new Palette(page, this.#work);
    this.#rail = new DrawingRail(page, this.#selection, {
      remove: () => this.#remove(), duplicate: () => this.#duplicate(), mirror: () => this.#mirror(),
    });
    addPlotsButton(page.words);
    page.mechanism.lay((context, view, theme) => {
      if (this.#on) paint(context, view, theme, { page, work: this.#work, selection: this.#selection, hand: this.#hand, area: this.#area });
    });
    page.mechanism.layUnder((context, view, theme) => {
      if (this.#on) paintAxes(context, view, theme, this.#area, page.words);
    }, () => null);
    const { picture } = this.#work;
    page.mechanism.layUnder((context, view) => {
      this.#scaleSymbols(view);
      if (this.#on) picture.paint(context, view);
    }, () => (this.#on ? picture.bounds : null));
    addEventListener("keydown", (event) => this.#key(event), true);
    addEventListener("drop", (event) => this.#bring(event, event.dataTransfer), true);
    addEventListener("paste", (event) => this.#bring(event, event.clipboardData), true);
    for (const kind of /** @type {const} */ (["copy", "cut", "paste"])) addEventListener(kind, (event) => this.#clip(event, kind));
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    const { state, summary } = snapshot;
    const on = state.view.drawing && "links" in state.document && (!summary.moves || summary.traceable);
    const turned = on !== this.#on;
    if (turned) this.#turn(on);
    this.#count.render(snapshot, on);
    if (!on) return;
    this.#work.picture.follow();
    const document = /** @type {Document} */ (state.document);
    // An empty sheet starts with the tool for bars.
    const empty = document.points.length === 0;
    if (empty && !this.#empty && this.#work.tool !== "bars") this.#palette.take("bars");
    this.#empty = empty;
    this.#selection.keep(document);
    this.#work.follow();
    this.#palette.render(snapshot);
    this.#rail.render(snapshot, document);
    // The drawing was painted before the tools were shown.
    if (turned) this.#page.mechanism.repaint();
  }

  /** @param {boolean} on */
  #turn(on) {
    const { pointer, mechanism } = this.#page;
    this.#on = on;
    // With this attribute, the style sheet keeps the size of the stage, whatever the drawing shows.
    setData(document.documentElement, "drawing", String(on));
    this.#palette.element.hidden = !on;
    this.#rail.show(on);
    this.#selection.clear();
    this.#work.rest();
    unsay(this.#page);
    pointer.setTool(on ? this.#hand : null);
    mechanism.keep(on, () => this.#palette.insets);
    if (on) this.#palette.take("select");
  }

  /**
   * Keeps the size of symbols on the screen while the drawing grows and the view is zoomed.
   * @param {import("assur/canvas/transform.js").Transform} view
   */
  #scaleSymbols({ scale }) {
    const { width, height } = this.#page.mechanism.size;
    const size = Math.min(Math.max(Math.min(width, height) / SYMBOLS, SYMBOL[0]), SYMBOL[1]);
    if (this.#page.model.scaleSymbols(this.#on ? size / scale : 0)) this.#page.redraw();
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    // The open document may already be of another kind, although it has not been shown yet.
    const drawn = this.#on && "links" in this.#document();
    if (!drawn || event.defaultPrevented || document.querySelector("dialog[open]")) return;
    const target = event.target instanceof HTMLElement ? event.target : document.body;
    const typing = target instanceof HTMLInputElement || target instanceof HTMLSelectElement || target instanceof HTMLTextAreaElement;
    if (event.key === "Escape" && this.#palette.fold()) byId("draw-more", HTMLButtonElement).focus();
    else if (event.key === "Escape" && this.#work.pressed.length > 0) this.#work.rest();
    else if (typing) return;
    else if (event.key === "Escape" && !this.#selection.empty) this.#selection.clear();
    else if (event.key === "Enter" && this.#hand.over && target.closest("button, summary, a") === null) this.#hand.pressHere();
    else if (event.key === "Delete" || event.key === "Backspace") this.#remove();
    else if (event.altKey && this.#palette.byKey(event)) return;
    else if (event.altKey && event.code === "KeyL" && this.#rail.lock()) return;
    else if ((event.ctrlKey || event.metaKey) && event.code === "KeyA") this.#all();
    else if ((event.ctrlKey || event.metaKey) && event.code === "KeyD") this.#duplicate();
    else if (/^[\d.,]$/.test(event.key) && !event.ctrlKey && !event.metaKey && this.#rail.type()) return;
    else if (event.key.startsWith("Arrow") && target.id !== "scrubber") this.#arrow(event);
    else return;
    event.preventDefault();
    event.stopPropagation();
    this.#page.redraw();
  }

  /** @returns {import("assur/drawing/axes.js").Area} the part of the drawing without tools and buttons */
  get #area() {
    const { width, height } = this.#page.mechanism.size;
    const { top, bottom } = this.#palette.insets;
    return { left: EDGE, top: top + EDGE, right: width - EDGE, bottom: height - bottom - EDGE };
  }

  #document() {
    return /** @type {Document} */ (this.#page.store.get().document);
  }

  /**
   * The selected points and those of selected links. Traced points are left out, because they move with their links.
   */
  #joints() {
    const document = this.#document();
    const points = new Set(document.points.map(({ name }) => name));
    return this.#selection.all(document).filter((name) => points.has(name));
  }

  #remove() {
    const { points, links } = this.#selection;
    if (this.#selection.empty) return;
    step(this.#page, { edit: "remove", points: [...points], links: [...links] });
  }

  #mirror() {
    const document = this.#document();
    const points = this.#selection.empty ? document.points.map(({ name }) => name) : this.#joints();
    step(this.#page, { edit: "mirror", points });
  }

  #all() {
    const { points, links } = this.#document();
    this.#selection.set(points.map(({ name }) => name), links.map(({ name }) => name));
  }

  #duplicate() {
    const part = this.#part();
    if (part) this.#paste(part);
  }

  /** @returns {Document | null} the selected part as a drawing of its own; null if there is none */
  #part() {
    if (this.#selection.empty) return null;
    const { points, links } = this.#selection;
    const input = inputNow(this.#page);
    return attempt(() => this.#page.engine.simulator.part([...points], [...links], input)).value;
  }

  /** @param {Document} drawing */
  #paste(drawing) {
    const offset = PASTE_OFFSET * this.#hand.step;
    const made = step(this.#page, { edit: "paste", drawing: /** @type {import("assur/types/file.js").LinkageDocument} */ (drawing), by: [offset, -offset] });
    if (!made) return;
    const { points, links } = made.document;
    const count = drawing.points.length;
    this.#selection.set(points.slice(points.length - count).map(({ name }) => name), links.slice(links.length - drawing.links.length).map(({ name }) => name));
    this.#palette.take("select");
  }

  /**
   * Moves the selection by a step of the grid. If another tool is in use or nothing is selected, moves the keyboard's
   * pointer instead; Enter presses at that pointer.
   * @param {KeyboardEvent} event
   */
  #arrow({ key }) {
    const [right, up] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[key] ?? [0, 0];
    if (this.#work.tool !== "select" || this.#selection.empty) {
      // The drawing gets the focus, so that Enter does not press the button of a tool.
      const canvas = byId("mechanism", HTMLCanvasElement);
      canvas.tabIndex = -1;
      canvas.focus({ preventScroll: true });
      this.#hand.walk(right, up);
      return;
    }
    const [x, y] = [right * this.#hand.step, up * this.#hand.step];
    step(this.#page, { edit: "move", points: this.#joints(), by: [x, y] });
  }

  /**
   * Puts a dropped or pasted picture behind the drawing.
   * @param {Event} event
   * @param {DataTransfer | null} data
   */
  #bring(event, data) {
    const file = data?.files[0];
    if (!this.#on || !file?.type.startsWith("image/") || document.querySelector("dialog[open]")) return;
    event.preventDefault();
    this.#palette.take("picture");
    this.#palette.pictures.take(file);
  }

  /**
   * @param {ClipboardEvent} event
   * @param {"copy" | "cut" | "paste"} kind
   */
  #clip(event, kind) {
    const target = event.target instanceof Element ? event.target : document.body;
    if (!this.#on || target.closest("input, textarea, select, dialog") || !event.clipboardData) return;
    if (kind === "paste") {
      const drawing = pasted(event.clipboardData.getData("text/plain"));
      if (!drawing) return;
      this.#paste(drawing);
    } else {
      const part = this.#part();
      if (!part) return;
      event.clipboardData.setData("text/plain", JSON.stringify({ [FORMAT]: part }));
      if (kind === "cut") this.#remove();
    }
    event.preventDefault();
    this.#page.redraw();
  }
}

/**
 * @param {string} text of the clipboard
 * @returns {Document | null} the copied part of a drawing, which the engine will check; null if the text holds none
 */
function pasted(text) {
  try {
    const value = JSON.parse(text);
    const drawing = value?.[FORMAT];
    return Array.isArray(drawing?.points) && Array.isArray(drawing?.links) ? drawing : null;
  } catch {
    return null;
  }
}
