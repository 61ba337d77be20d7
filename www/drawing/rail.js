// The panel beside a drawing: why the drawing does not move, with remedies; commands for the selection; coordinates.
import { NumberBox, numberField } from "assur/controls/number-box.js";
import { degrees } from "assur/core/angles.js";
import { byId, make } from "assur/core/dom.js";
import { called } from "assur/core/names.js";
import { Seen } from "assur/core/seen.js";
import { edit, step } from "assur/drawing/edit.js";
import { Reasons } from "assur/drawing/reasons.js";
import { placeTraced } from "assur/state/change.js";

/**
 * @typedef {import("assur/state/model.js").AnySnapshot} Snapshot
 * @typedef {import("assur/state/state.js").Documents["linkage"]} Document
 * @typedef {import("assur/core/words.js").Words} Words
 */

/** Names of the commands that lock and unlock a dimension, by its number of points. */
const LOCKS = Object.freeze(/** @type {Record<number, string>} */ ({ 2: "lock_length", 3: "lock_angle" }));

/** Tolerance within which an input counts as the drawn one, in radians or the unit of lengths. */
const DRAWN = 1e-9;

export class DrawingRail {
  #page;
  #selection;
  #reasons;
  #chosen = make("div", { id: "draw-chosen" });
  #points = make("div", { id: "draw-points", class: "draw-points" });
  #element;
  /** @type {{ name: string, label: HTMLElement, inputs: HTMLInputElement[], boxes: NumberBox[] }[]} */
  #rows = [];
  /** @type {(() => void)[]} functions that rewrite the numbers of the selection */
  #numbers = [];
  #seen = { told: new Seen(), chosen: new Seen(), points: new Seen() };
  /** @type {ReadonlyMap<string, readonly [number, number]>} current positions of the points */
  #positions = new Map();
  /** Name of the newest point. A digit typed outside any field goes into this point's x field (see `type`). */
  #last = "";

  /**
   * @param {import("assur/app/page.js").Page} page
   * @param {import("assur/drawing/selection.js").Selection} selection
   * @param {Readonly<Record<"remove" | "duplicate" | "mirror", () => void>>} acts commands for the selection
   */
  constructor(page, selection, acts) {
    this.#page = page;
    this.#selection = selection;
    this.acts = acts;
    this.#reasons = new Reasons(page);
    this.#element = make("section", { id: "draw-rail", "data-field": "edit" }, [
      make("h2", { "data-t": "draw.heading" }), ...this.#reasons.elements, this.#chosen,
      make("details", { id: "draw-numbers", open: "" }, [make("summary", { "data-t": "draw.points" }), this.#points]),
    ]);
    byId("rail", HTMLElement).prepend(this.#element);
    page.words.fill(this.#element);
  }

  /** @param {boolean} on */
  show(on) {
    this.#element.hidden = !on;
  }

  /**
   * Focuses the coordinates of the point drawn last.
   * @returns {boolean} false, so that the pressed key still reaches the field
   */
  type() {
    const row = this.#rows.find(({ name }) => name === this.#last) ?? this.#rows.at(-1);
    if (!row) return false;
    byId("draw-numbers", HTMLDetailsElement).open = true;
    row.inputs[0].focus();
    return false;
  }

  /**
   * Locks or unlocks the length or the angle of the selection.
   * @returns {boolean} whether the selection has a length or an angle to lock
   */
  lock() {
    const { points, links } = this.#selection;
    const lock = lockable(/** @type {Document} */ (this.#page.store.get().document), [...points], [...links]);
    if (lock) step(this.#page, { edit: "lock", points: lock });
    return lock !== null;
  }

  /**
   * @param {Snapshot} snapshot
   * @param {Document} document
   */
  render(snapshot, document) {
    const { words, summary } = snapshot;
    if (!this.#seen.told.same(words, summary)) this.#reasons.show(snapshot, document);
    const chosen = [...this.#selection.points, "/", ...this.#selection.links].join("\n");
    if (!this.#seen.chosen.same(words, chosen, structure(document))) this.#choose(document, words);
    this.#positions = this.#positionsOf(snapshot, document);
    this.#numbers.forEach((show) => show());
    this.#list(document, words);
  }

  /**
   * Returns the positions of the points: in the drawn pose, those of the document exactly; in other poses, computed ones.
   * @param {Pick<Snapshot, "summary" | "frameInput">} snapshot
   * @param {Document} document
   */
  #positionsOf({ summary, frameInput }, { points }) {
    /** @type {Map<string, readonly [number, number]>} */
    const positions = new Map(points.map(({ name, at }) => [name, at]));
    if (summary.moves && Math.abs(frameInput - summary.home) > DRAWN) {
      for (const { name, x, y } of this.#page.mechanism.joints()) if (positions.has(name)) positions.set(name, [x, y]);
    }
    return positions;
  }

  /**
   * Shows the buttons and fields for the selection.
   * @param {Document} document
   * @param {Words} words
   */
  #choose(document, words) {
    const { points, links } = this.#selection;
    this.#numbers = [];
    const button = (/** @type {string} */ name, /** @type {() => void} */ onclick, values = {}) =>
      make("button", { id: `draw-act-${name}`, class: "control", type: "button", onclick }, [words.text(`draw.act.${name}`, values)]);
    const act = (/** @type {string} */ name, /** @type {import("assur/types/edit.js").Edit} */ wanted) => button(name, () => step(this.#page, wanted));
    const acts = (/** @type {"remove" | "duplicate" | "mirror"} */ name) => button(name, this.acts[name]);
    /** @type {Node[]} */
    const content = [];
    const [point] = points;
    const [link, other] = links;
    if (points.size + links.size === 1) content.push(this.#name(point ?? link, words));
    const tracer = document.tracers?.find(({ name }) => name === point);
    if (tracer && points.size === 1 && links.size === 0) content.push(this.#carried(tracer.name, words));
    const own = point && document.points.some(({ name }) => name === point);
    const buttons = [];
    if (points.size === 1 && links.size === 0 && own) {
      buttons.push(act(document.frame.includes(point) ? "unfix" : "fix", { edit: "fix", point }));
      if (document.links.filter((one) => one.points.includes(point)).length > 1) buttons.push(act("part", { edit: "part", point }));
    }
    if (links.size === 1 && points.size === 0) {
      buttons.push(act("drive", { edit: "drive", link }));
      const one = document.links.find(({ name }) => name === link);
      if (one?.points.length === 1) buttons.push(act(one.fixed_to === "frame" ? "unfix" : "fix", { edit: "weld", links: [link, "frame"] }));
      if (document.links.find(({ name }) => name === link)?.centre_of_mass) buttons.push(act("unmass", { edit: "mass", link, at: null }));
      content.push(this.#measures(link, words));
    }
    if (links.size === 2 && points.size === 0) buttons.push(act("weld", { edit: "weld", links: [link, other] }));
    if (points.size === 2 && links.size === 0) {
      const [from, to] = points;
      buttons.push(act("join", { edit: "join", points: [from, to] }));
      buttons.push(act("bar", { edit: "bar", ends: [{ point: from }, { point: to }] }));
    }
    const lock = lockable(document, [...points], [...links]);
    if (lock) {
      const locking = button(LOCKS[lock.length], () => this.lock(), { n: lock[1] });
      locking.setAttribute("aria-pressed", String((document.locks ?? []).some((one) => same(one, lock))));
      locking.setAttribute("aria-keyshortcuts", "Alt+L");
      buttons.push(locking);
    }
    if (points.size + links.size > 0) buttons.push(acts("duplicate"), acts("mirror"), acts("remove"));
    content.push(make("div", { class: "draw-acts" }, buttons));
    const page = this.#chosen.ownerDocument;
    const focused = this.#chosen.contains(page.activeElement) ? page.activeElement?.id : undefined;
    this.#chosen.replaceChildren(...content);
    words.fill(this.#chosen);
    // A button with the focus keeps it when it is rebuilt.
    if (focused) page.getElementById(focused)?.focus();
  }

  /**
   * @param {string} name
   * @param {Words} words
   */
  #name(name, words) {
    const { points, links } = this.#selection;
    const input = make("input", { id: "draw-name", class: "control", type: "text", maxlength: "40", autocomplete: "off", spellcheck: "false", "data-t-label": "draw.name" });
    // A link of the catalogue is shown by its word in the reader's language. Its own name stays until another one is typed.
    const shown = links.has(name) ? called(name, words) : name;
    input.value = shown;
    input.addEventListener("change", () => {
      const made = step(this.#page, { edit: "rename", name, to: input.value });
      if (made) this.#selection.set(points.has(name) ? [input.value.trim()] : [], points.has(name) ? [] : [input.value.trim()]);
      else input.value = shown;
      this.#page.redraw();
    });
    return make("label", { class: "draw-numbers" }, [make("span", {}, [words.text("draw.name")]), input]);
  }

  /**
   * Fields for the length and the angle of a link with two points.
   * @param {string} link
   * @param {Words} words
   */
  #measures(link, words) {
    const off = () => {
      const [from, to] = this.#ends(link);
      return from && to ? [to[0] - from[0], to[1] - from[1]] : [0, 0];
    };
    if (this.#ends(link).length < 2) return make("div");
    return make("div", { class: "draw-numbers" }, [
      ...this.#box("length", words, () => Math.hypot(...off()), (length) => edit(this.#page, { edit: "stretch", link, length })),
      ...this.#box("angle", words, () => degrees(Math.atan2(off()[1], off()[0])), (angle) => edit(this.#page, { edit: "turn", link, angle_deg: angle })),
    ]);
  }

  /**
   * Fields for a traced point's position on its link: distances from the first point, along the link and to its left.
   * @param {string} point
   * @param {Words} words
   */
  #carried(point, words) {
    const at = () => /** @type {Document} */ (this.#page.store.get().document).tracers?.find(({ name }) => name === point)?.at ?? [0, 0];
    return make("div", { class: "draw-numbers" }, [
      ...["along", "across"].flatMap((what, axis) => this.#box(what, words, () => at()[axis], (value) => placeTraced(this.#page.store, point, axis, value))),
    ]);
  }

  /**
   * @param {string} link
   * @returns {(readonly [number, number])[]} positions of the link's first two points
   */
  #ends(link) {
    const { links } = /** @type {Document} */ (this.#page.store.get().document);
    const points = links.find(({ name }) => name === link)?.points ?? [];
    return points.slice(0, 2).flatMap((name) => {
      const position = this.#positions.get(name);
      return position ? [position] : [];
    });
  }

  /**
   * Makes the name and the field of a number of the selection.
   * @param {string} what
   * @param {Words} words
   * @param {() => number} value
   * @param {(value: number) => void} put
   */
  #box(what, words, value, put) {
    const input = numberField({ id: `draw-${what}`, "data-t-label": `draw.${what}` });
    const shown = new NumberBox(input, `draw-${what}`, this.#page.drafts, (number) => {
      put(number);
      this.#keep();
      return value();
    });
    this.#numbers.push(() => shown.show(value(), coordinateTexts(value(), this.#page.words), false));
    return [make("span", {}, [words.text(`draw.${what}`)]), input];
  }

  /**
   * Shows the points with their coordinates.
   * @param {Document} document
   * @param {Words} words
   */
  #list({ points }, words) {
    const names = points.map(({ name }) => name).join("\n");
    if (!this.#seen.points.same(words, names)) this.#build(points, words);
    this.#rows.forEach(({ name, label, boxes }, k) => {
      const position = this.#positions.get(name) ?? points[k].at;
      boxes.forEach((box, axis) => box.show(position[axis], coordinateTexts(position[axis], words), false));
      const selected = String(this.#selection.points.has(name));
      if (label.dataset.selected !== selected) label.dataset.selected = selected;
    });
  }

  /**
   * @param {Document["points"]} points
   * @param {Words} words
   */
  #build(points, words) {
    const before = new Set(this.#rows.map(({ name }) => name));
    const focused = document.activeElement?.id ?? "";
    this.#last = points.findLast(({ name }) => !before.has(name))?.name ?? this.#last;
    this.#rows = points.map(({ name }) => {
      const label = make("b", {}, [name]);
      const inputs = ["x", "y"].map((axis) => numberField({ id: `draw-${axis}-${name}`, "aria-label": words.text(axis === "x" ? "draw.point.x" : "draw.point.y", { n: name }) }));
      const boxes = inputs.map((input, axis) => new NumberBox(input, `draw-${"xy"[axis]}-${name}`, this.#page.drafts, (value) => this.#moveTo(name, axis, value)));
      return { name, label, inputs, boxes };
    });
    this.#points.replaceChildren(...this.#rows.flatMap(({ label, inputs }) => [label, ...inputs]));
    if (focused.startsWith("draw-")) document.getElementById(focused)?.focus();
  }

  /**
   * @param {string} name of a point
   * @param {number} axis
   * @param {number} value
   * @returns {number} the resulting value in the drawing
   */
  #moveTo(name, axis, value) {
    const [x, y] = this.#positions.get(name) ?? [0, 0];
    edit(this.#page, { edit: "place", point: name, at: axis === 0 ? [value, y] : [x, value] });
    this.#keep();
    return this.#positions.get(name)?.[axis] ?? value;
  }

  /** Takes the positions of the points from the document: after an edit, the driver is at the drawn input. */
  #keep() {
    const { points } = /** @type {Document} */ (this.#page.store.get().document);
    this.#positions = new Map(points.map((point) => [point.name, point.at]));
  }
}

/**
 * @param {number} value
 * @param {Words} words
 */
function coordinateTexts(value, { numbers }) {
  return { brief: numbers.short(value), full: numbers.exact(value) };
}

/**
 * @param {Document} document
 * @returns {string} all parts of the document on which the commands for the selection depend, as text
 */
function structure({ links, frame, locks }) {
  return JSON.stringify([frame, locks, links.map(({ name, points, centre_of_mass, fixed_to }) => [name, points, centre_of_mass, fixed_to])]);
}

/**
 * @param {Document} document
 * @param {string[]} points selected points
 * @param {readonly string[]} links selected links
 * @returns {string[] | null} two points with a lockable distance, or three with a lockable angle at the second
 */
function lockable(document, points, links) {
  const chosen = document.links.filter(({ name }) => links.includes(name));
  const ends = points.length === 0 && chosen.length === 1 ? chosen[0].points.slice(0, 2) : points;
  const own = ends.every((name) => document.points.some((point) => point.name === name));
  // A rectangle drawn around points also selects the links between them.
  const alone = points.length === 0 || chosen.every((link) => link.points.every((point) => points.includes(point)));
  return own && alone && ends.length in LOCKS ? ends : null;
}

/**
 * @param {readonly string[]} one points of a lock
 * @param {readonly string[]} other
 * @returns {boolean} whether both lock the same dimension: their points are equal in the same or in reverse order
 */
function same(one, other) {
  const is = (/** @type {readonly string[]} */ points) => points.join("\n") === other.join("\n");
  return is(one) || is([...one].reverse());
}
