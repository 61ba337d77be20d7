// Measures: distances and angles between points or links, chosen in lists or by presses on the drawing.
import { byId, make, setData, write } from "assur/core/dom.js";
import { html, render } from "assur/core/html.js";
import { called } from "assur/core/names.js";
import { attempt } from "assur/core/problem.js";
import { partsOf } from "assur/core/quantity.js";
import { Seen } from "assur/core/seen.js";
import { MEASURES, calledWhole, subscript } from "assur/core/symbols.js";
import { PARTS, withView } from "assur/state/state.js";

/** @typedef {import("assur/state/model.js").Snapshot} Snapshot */

/** Number of points or links of each measure, and whether they are links. */
const BETWEEN = Object.freeze({
  distance: Object.freeze({ count: 2, links: false }),
  corner: Object.freeze({ count: 3, links: false }),
  between: Object.freeze({ count: 2, links: true }),
});

/** Limit of the number of measures. */
const MAX_MEASURES = 8;

/** Greatest distance of a press from the point or link that it chooses, in pixels. */
const PICK_DISTANCE = 26;

/** The separator before the last part of the name of a measure or of its derivative: `.`, `.d`, `.dd`. */
const ORDERS = new RegExp(`\\.d{0,2}(?=(?:${MEASURES.join("|")})$)`);

/**
 * @param {import("assur/state/state.js").State} state
 * @param {string} name of a measure
 * @returns the state without the measure and its plots
 */
function without(state, name) {
  const { measures, plot, against } = state.view;
  const own = Object.values(against ?? {}).some((column) => column.replace(ORDERS, ".") === name);
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
  #parts = [0, 1, 2].map((n) => byId(`measure-${n}`, HTMLSelectElement));
  #pick = byId("measure-pick", HTMLButtonElement);
  #add = byId("measure-add", HTMLButtonElement);
  /** Prompt over the drawing for the point or link to press next. */
  #prompt = make("p", { id: "measure-prompt", class: "hand-word prompt", role: "status" });
  #seen = new Seen();
  #shown = new Seen();
  /** @type {Snapshot | null} */
  #snapshot = null;
  /** @type {string[] | null} points or links pressed so far; null if presses do not choose any */
  #picked = null;

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    this.#page = page;
    for (const select of this.#parts) select.addEventListener("change", () => this.#choose());
    this.#what.addEventListener("change", () => {
      // The lists may change from points to links or back. Points or links pressed so far then no longer fit.
      if (this.#picked) this.#picking(false);
      this.#offer();
    });
    this.#pick.addEventListener("click", () => this.#picking(this.#picked === null));
    addEventListener("keydown", ({ key }) => {
      if (key === "Escape" && this.#picked) this.#picking(false);
    });
    byId("mechanism", HTMLElement).after(this.#prompt);
    this.#add.addEventListener("click", () => this.#measure(this.#listed));
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    const { state, words } = snapshot;
    this.#snapshot = snapshot;
    const none = this.#offered("distance").length < 2;
    if (this.#section.hidden !== none) this.#section.hidden = none;
    if (this.#picked && (none || state.view.drawing)) this.#picking(false);
    if (none) return;
    if (!this.#seen.same(this.#offered("distance").join("\n"), this.#offered("between").join("\n"), words)) this.#offer();
    const { measures } = state.view;
    if (this.#shown.same(measures.join("\n"), words)) return;
    const focused = this.#list.contains(document.activeElement);
    render(measures.map((name, index) => this.#row(name, index, words)), this.#list);
    this.#choose();
    // If a button with the focus disappears, another control gets the focus.
    if (focused && !this.#list.contains(document.activeElement)) (this.#list.querySelector("button") ?? this.#what).focus();
  }

  /**
   * @param {string} name
   * @param {number} index
   * @param {import("assur/core/words.js").Words} words
   */
  #row(name, index, words) {
    const { of, what } = partsOf(name);
    const [letter, role] = what === "distance" ? ["d", "accent3"] : ["θ", "accent4"];
    const parts = calledWhole(of, what, words);
    const remove = words.text("measure.remove", { n: `${letter} ${parts}` });
    return html`<div class="row choosing" .style=${`--accent: var(--role-${role})`}><span class="name"><b>${letter}</b></span><span>${parts}</span>
      <button id="measure-remove-${index}" class="control icon" type="button" aria-label=${remove} title=${remove} @click=${() => this.#page.store.update((state) => without(state, name))}>×</button></div>`;
  }

  /**
   * @param {keyof typeof BETWEEN} what
   * @returns {readonly string[]} points or links offered for the measure
   */
  #offered(what) {
    const summary = this.#snapshot?.summary;
    if (!summary || !("points" in summary)) return [];
    return BETWEEN[what].links ? Object.keys(summary.roles) : summary.points;
  }

  /** Fills the lists for the chosen measure. */
  #offer() {
    const snapshot = this.#snapshot;
    if (!snapshot) return;
    const { words } = snapshot;
    const offered = this.#offered(this.#chosen);
    const { links } = BETWEEN[this.#chosen];
    const spelled = (/** @type {string} */ part) => (links ? called(part, words) : subscript(part));
    this.#parts.forEach((select, n) => {
      const before = select.value;
      render(offered.map((part) => html`<option value=${part}>${spelled(part)}</option>`), select);
      select.value = before;
      if (select.selectedIndex < 0) select.selectedIndex = Math.min(n, offered.length - 1);
      select.dataset.tLabel = links ? "measure.link" : "measure.point";
    });
    this.#pick.dataset.t = links ? "measure.pick_links" : "measure.pick";
    words.fill(this.#section);
    this.#choose();
  }

  get #chosen() {
    return /** @type {keyof typeof BETWEEN} */ (this.#what.value);
  }

  /** Enables or disables the buttons, according to the choice in the lists. */
  #choose() {
    const { count } = BETWEEN[this.#chosen];
    this.#parts[2].hidden = count < 3;
    const parts = this.#listed;
    const measures = this.#snapshot?.state.view.measures ?? [];
    this.#add.disabled = new Set(parts).size < parts.length || measures.length >= MAX_MEASURES || measures.includes(this.#name(parts));
    this.#pick.disabled = measures.length >= MAX_MEASURES;
  }

  get #listed() {
    return this.#parts.slice(0, BETWEEN[this.#chosen].count).map(({ value }) => value);
  }

  /** @param {readonly string[]} parts */
  #name(parts) {
    return `${parts.join("-")}.${this.#chosen}`;
  }

  /** @param {readonly string[]} parts */
  #measure(parts) {
    const name = this.#name(parts);
    this.#page.store.update((state) => {
      const { measures } = state.view;
      return measures.includes(name) || measures.length >= MAX_MEASURES ? state : withView(state, { measures: [...measures, name] });
    });
  }

  /** @param {boolean} on whether presses on the drawing now choose the points or links of a measure */
  #picking(on) {
    // While the drawing tools are shown, they alone use the pointer.
    const drawing = this.#snapshot?.state.view.drawing ?? false;
    if (on && drawing) return;
    this.#picked = on ? [] : null;
    this.#pick.setAttribute("aria-pressed", String(on));
    if (!drawing && this.#page.pointer.tool !== this === on) this.#page.pointer.setTool(on ? this : null);
    this.#page.mechanism.ring("");
    setData(byId("mechanism", HTMLElement), "tracing", String(on));
    this.#ask();
  }

  /** Writes the prompt for the next press, or clears it. */
  #ask() {
    const { count, links } = BETWEEN[this.#chosen];
    const { words } = this.#page;
    const number = (/** @type {number} */ n) => words.numbers.exact(n);
    write(this.#prompt, this.#picked ? words.text(links ? "measure.prompt_link" : "measure.prompt", { number: number(this.#picked.length + 1), count: number(count) }) : "");
  }

  /** @param {import("assur/stage/pointer.js").Pixel} at */
  hover(at) {
    this.#page.mechanism.ring(BETWEEN[this.#chosen].links ? "" : this.#near(at) ?? "");
  }

  leave() {
    this.#page.mechanism.ring("");
  }

  dropped() {
    if (this.#picked) this.#picking(false);
  }

  /** Starts no drag: the tool takes only presses. */
  grab() {
    return null;
  }

  /** @param {import("assur/stage/pointer.js").Pixel} at */
  press(at) {
    const { count, links } = BETWEEN[this.#chosen];
    const part = links ? this.#link(at) : this.#near(at);
    if (part === null || !this.#picked || this.#picked.includes(part)) return;
    this.#parts[this.#picked.length].value = part;
    this.#picked.push(part);
    this.#choose();
    this.#ask();
    if (this.#picked.length < count) return;
    const picked = this.#picked;
    this.#picking(false);
    this.#measure(picked);
  }

  /**
   * @param {import("assur/stage/pointer.js").Pixel} at
   * @returns {string | null} the nearest point; null if none is within reach
   */
  #near({ x, y }) {
    const snapshot = this.#snapshot;
    if (!snapshot) return null;
    const { summary, readouts, handles } = snapshot;
    const held = summary.handles.map(({ name }, i) => ({ name, at: [handles[2 * i], handles[2 * i + 1]] }));
    const read = ("points" in summary ? summary.points : []).map((name) => ({ name, at: [readouts?.value(`${name}.x`), readouts?.value(`${name}.y`)] }));
    /** @type {string | null} */
    let nearest = null;
    let least = PICK_DISTANCE;
    for (const { name, at: [px, py] } of [...held, ...read]) {
      if (px === undefined || py === undefined || !("points" in summary) || !summary.points.includes(name)) continue;
      const [left, top] = this.#page.mechanism.view.toScreen(px, py);
      const off = Math.hypot(left - x, top - y);
      if (off < least) [nearest, least] = [name, off];
    }
    return nearest;
  }
  /**
   * @param {import("assur/stage/pointer.js").Pixel} at
   * @returns {string | null} the nearest link; null if none is within reach
   */
  #link({ x, y }) {
    const snapshot = this.#snapshot;
    if (!snapshot) return null;
    const { view } = this.#page.mechanism;
    const [left, top] = view.toModel(x, y);
    const near = attempt(() => this.#page.engine.simulator.linkAt(snapshot.frameInput, left, top)).value;
    return near && near.off * view.scale < PICK_DISTANCE ? near.link : null;
  }
}
