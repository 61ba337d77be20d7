// What is measured between points of the drawing: chosen by lists or by presses in the drawing, listed, taken away.
import { byId, make, setData } from "assur/core/dom.js";
import { Seen } from "assur/core/seen.js";
import { subscript } from "assur/core/symbols.js";
import { PARTS, withView } from "assur/state/state.js";

/** @typedef {import("assur/state/model.js").Snapshot} Snapshot */

/** How many points each measure is between. */
const POINTS = Object.freeze({ distance: 2, corner: 3 });

/** So many measures there may be. */
const MOST = 8;

/** So near a point a press takes it, in pixels. */
const REACH = 26;

/**
 * @param {import("assur/state/state.js").State} state
 * @param {string} name of a measure
 * @returns the state without it: what is plotted of it is so no more
 */
function without(state, name) {
  const { measures, plot, against } = state.view;
  const own = Object.values(against ?? {}).some((column) => column.replace(/\.d{0,2}(?=distance|corner)/, ".") === name);
  return withView(state, {
    measures: measures.filter((one) => one !== name),
    plot: plot === name ? PARTS.plot : plot,
    against: own ? PARTS.against : against,
  });
}

export class Measures {
  #page;
  #section = byId("measures", HTMLElement);
  #list = byId("measured", HTMLElement);
  #what = byId("measure-what", HTMLSelectElement);
  #points = [0, 1, 2].map((n) => byId(`measure-${n}`, HTMLSelectElement));
  #pick = byId("measure-pick", HTMLButtonElement);
  #add = byId("measure-add", HTMLButtonElement);
  #offered = new Seen();
  #shown = new Seen();
  /** @type {Snapshot | null} */
  #snapshot = null;
  /** @type {string[] | null} the points that were pressed, while they are */
  #picked = null;

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    this.#page = page;
    for (const select of [this.#what, ...this.#points]) select.addEventListener("change", () => this.#choose());
    this.#pick.addEventListener("click", () => this.#picking(this.#picked === null));
    this.#add.addEventListener("click", () => this.#measure(this.#chosen));
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    const { state, summary, words } = snapshot;
    this.#snapshot = snapshot;
    const points = "points" in summary ? summary.points : [];
    const none = points.length < 2;
    if (this.#section.hidden !== none) this.#section.hidden = none;
    if (this.#picked && (none || state.view.drawing)) this.#picking(false);
    if (none) return;
    if (!this.#offered.same(points.join("\n"), words)) this.#offer(points);
    const { measures } = state.view;
    if (this.#shown.same(measures.join("\n"), words)) return;
    const focused = this.#list.contains(document.activeElement);
    this.#list.replaceChildren(...measures.map((name, index) => this.#row(name, index)));
    words.fill(this.#section);
    this.#choose();
    // A button that is there no more gives the focus away, else it would be lost.
    if (focused) (this.#list.querySelector("button") ?? this.#what).focus();
  }

  /**
   * @param {string} name
   * @param {number} index
   */
  #row(name, index) {
    const dot = name.lastIndexOf(".");
    const [letter, role] = name.endsWith(".distance") ? ["d", "accent3"] : ["θ", "accent4"];
    const points = subscript(name.slice(0, dot));
    const remove = make("button", {
      id: `measure-remove-${index}`, class: "control icon", type: "button",
      "data-t-label": "measure.remove", "data-t-title": "measure.remove", "data-n": `${letter} ${points}`,
    }, ["×"]);
    remove.addEventListener("click", () => this.#page.store.update((state) => without(state, name)));
    return make("div", { class: "row choosing", style: `--accent: var(--role-${role})` }, [make("span", { class: "name" }, [make("b", {}, [letter])]), make("span", {}, [points]), remove]);
  }

  /** @param {readonly string[]} points */
  #offer(points) {
    this.#points.forEach((select, n) => {
      const before = select.value;
      select.replaceChildren(...points.map((point) => make("option", { value: point }, [subscript(point)])));
      select.value = before;
      if (select.selectedIndex < 0) select.selectedIndex = Math.min(n, points.length - 1);
    });
    this.#choose();
  }

  get #count() {
    return POINTS[/** @type {keyof typeof POINTS} */ (this.#what.value)];
  }

  get #chosen() {
    return this.#points.slice(0, this.#count).map(({ value }) => value);
  }

  /** What is chosen by the lists may be measured or not. */
  #choose() {
    this.#points[2].hidden = this.#count < 3;
    const points = this.#chosen;
    const measures = this.#snapshot?.state.view.measures ?? [];
    this.#add.disabled = new Set(points).size < points.length || measures.length >= MOST || measures.includes(this.#name(points));
    this.#pick.disabled = measures.length >= MOST;
  }

  /** @param {readonly string[]} points */
  #name(points) {
    return `${points.join("-")}.${this.#what.value}`;
  }

  /** @param {readonly string[]} points */
  #measure(points) {
    const name = this.#name(points);
    this.#page.store.update((state) => {
      const { measures } = state.view;
      return measures.includes(name) || measures.length >= MOST ? state : withView(state, { measures: [...measures, name] });
    });
  }

  /** @param {boolean} on whether presses in the drawing choose points from now on */
  #picking(on) {
    // The tools for drawing have the pointer while they are out.
    const drawing = this.#snapshot?.state.view.drawing ?? false;
    if (on && drawing) return;
    this.#picked = on ? [] : null;
    this.#pick.setAttribute("aria-pressed", String(on));
    if (!drawing) this.#page.pointer.lend(on ? this : null);
    this.#page.mechanism.ring("");
    setData(byId("mechanism", HTMLElement), "tracing", String(on));
  }

  /** @param {import("assur/stage/pointer.js").Place} at */
  hover(at) {
    this.#page.mechanism.ring(this.#near(at) ?? "");
  }

  leave() {
    this.#page.mechanism.ring("");
  }

  /** Nothing is dragged. */
  grab() {
    return null;
  }

  /** @param {import("assur/stage/pointer.js").Place} at */
  press(at) {
    const point = this.#near(at);
    if (point === null || !this.#picked || this.#picked.includes(point)) return;
    this.#points[this.#picked.length].value = point;
    this.#picked.push(point);
    this.#choose();
    if (this.#picked.length < this.#count) return;
    const picked = this.#picked;
    this.#picking(false);
    this.#measure(picked);
  }

  /**
   * @param {import("assur/stage/pointer.js").Place} at
   * @returns {string | null} the point that is next to a place, if one is near
   */
  #near({ x, y }) {
    const snapshot = this.#snapshot;
    if (!snapshot) return null;
    const { summary, readouts, handles } = snapshot;
    const held = summary.handles.map(({ name }, i) => ({ name, at: [handles[2 * i], handles[2 * i + 1]] }));
    const read = ("points" in summary ? summary.points : []).map((name) => ({ name, at: [readouts?.[`${name}.x`], readouts?.[`${name}.y`]] }));
    /** @type {string | null} */
    let nearest = null;
    let least = REACH;
    for (const { name, at: [px, py] } of [...held, ...read]) {
      if (px === undefined || py === undefined || !("points" in summary) || !summary.points.includes(name)) continue;
      const [left, top] = this.#page.mechanism.view.toScreen(px, py);
      const off = Math.hypot(left - x, top - y);
      if (off < least) [nearest, least] = [name, off];
    }
    return nearest;
  }
}
