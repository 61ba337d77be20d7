// The steady cycle and its flywheels: found by a worker, as a table, a plot of the rate, and Wittenbauer's diagram.
import { sentence } from "assur/controls/problems.js";
import { numberField } from "assur/controls/number-box.js";
import { degrees } from "assur/core/angles.js";
import { make } from "assur/core/dom.js";
import { html, nothing, render } from "assur/core/html.js";
import { parseNumber } from "assur/core/numbers.js";
import { compiledWasm } from "assur/core/wasm.js";
import { edited, withoutExtras } from "assur/state/state.js";
import { plot } from "assur/under-load/plot.js";

/**
 * @typedef {import("assur/types/web.js").CycleHere} Found
 * @typedef {import("assur/types/web.js").WheelHere} Wheel
 * @typedef {import("assur/core/problem.js").Problem} Problem
 * @typedef {import("assur/core/words.js").Words} Words
 * @typedef {import("assur/state/state.js").State} State
 */

/** Non-uniformity wanted at first: that of presses and pumps. */
const USUAL = 0.04;

/** @type {readonly (readonly ["given" | "wittenbauer" | "mertsalov", string, string])[]} rows, with the keys of their names and their colours */
const WHEELS = Object.freeze(/** @type {const} */ ([
  ["given", "under_load.given", "accent1"],
  ["wittenbauer", "under_load.wittenbauer", "accent2"],
  ["mertsalov", "under_load.mertsalov", "accent3"],
]));

export class Cycle {
  #page;
  #delta = numberField({ id: "cycle-delta", "data-t-label": "under_load.delta", value: String(USUAL) });
  #out = make("div", { id: "cycle-found" });
  /** @type {Worker | null} */
  #worker = null;
  /** @type {Found | null} */
  #found = null;
  /** @type {readonly Problem[]} */
  #problems = [];
  /** @type {State["document"] | null} document of the last question */
  #document = null;
  #lang = "";

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    this.#page = page;
    const ask = make("button", { type: "button", class: "control", id: "cycle-find", "data-t": "under_load.steady", onclick: () => this.#ask() });
    const delta = make("label", { class: "load-field" }, [make("span", { "data-t": "under_load.delta" }), this.#delta]);
    this.element = make("div", {}, [make("h3", { "data-t": "under_load.cycle" }), make("div", { class: "load-buttons" }, [delta, ask]), this.#out]);
  }

  /**
   * @param {import("assur/state/model.js").Snapshot} snapshot
   * @param {Words} words
   */
  render({ state }, words) {
    if (this.#document && state.document !== this.#document) this.close();
    if (this.#lang === words.lang) return;
    this.#lang = words.lang;
    const value = parseNumber(this.#delta.value);
    if (value !== null) this.#delta.value = words.numbers.exact(value);
    this.#write();
  }

  /** Ends the search and forgets what it has found. */
  close() {
    if (!this.#document && this.#problems.length === 0) return;
    this.#worker?.terminate();
    this.#worker = this.#document = this.#found = null;
    this.#problems = [];
    this.#write();
  }

  async #ask() {
    this.close();
    const state = this.#page.store.get();
    const delta = parseNumber(this.#delta.value);
    this.#delta.setAttribute("aria-invalid", String(delta === null));
    if (state.kind !== "linkage" || delta === null) {
      this.#problems = [{ code: "bad_non_uniformity", max: 1 }];
      this.#write();
      return;
    }
    const worker = new Worker(import.meta.resolve("assur/under-load/worker.js"), { type: "module" });
    this.#worker = worker;
    this.#document = state.document;
    const done = (/** @type {{ found?: Found, problems?: readonly Problem[] }} */ { found = undefined, problems = [] }) => {
      if (worker !== this.#worker) return;
      worker.terminate();
      this.#worker = null;
      this.#found = found ?? null;
      this.#problems = problems;
      this.#write();
    };
    worker.addEventListener("message", ({ data }) => done(data));
    worker.addEventListener("error", () => done({ problems: [{ code: "trapped" }] }));
    this.#write();
    try {
      const wasm = await compiledWasm();
      worker.postMessage({ wasm, state: withoutExtras(state), rate: state.document.initial_rate ?? 0, delta });
    } catch {
      done({ problems: [{ code: "trapped" }] });
    }
  }

  /** @param {number} flywheel */
  #put(flywheel) {
    const { store } = this.#page;
    store.update((state) => edited(state, "linkage", () => ({ flywheel: Number(flywheel.toPrecision(6)) })));
    this.#ask();
  }

  #write() {
    const { words } = this.#page;
    const wait = this.#worker ? html`<p role="status">${words.text("under_load.searching")}</p>` : nothing;
    const why = this.#problems.map((problem) => html`<p role="alert">${sentence(problem, words)}</p>`);
    render([wait, why, this.#found ? this.#answer(this.#found, words) : nothing], this.#out);
  }

  /**
   * @param {Found} found
   * @param {Words} words
   */
  #answer(found, words) {
    const { numbers } = words;
    const inertia = words.unit === "" ? "" : `, ${words.text("under_load.unit.inertia")}`;
    const energy = words.unit === "" ? "" : `, ${words.text("under_load.unit.energy")}`;
    const rate = `, ${words.text("unit.rad_per_s")}`;
    const shown = WHEELS.filter(([name]) => name === "given" || found[name].flywheel > 0);
    const row = (/** @type {typeof WHEELS[number]} */ [name, key]) => {
      const { flywheel, cycle, problems } = found[name];
      const cells = cycle
        ? [cycle.delta, cycle.mean, cycle.extremes[0], cycle.extremes[1]].map((value) => html`<td data-value=${value}>${numbers.short(value)}</td>`)
        : html`<td colspan="4">${problems.map((problem) => sentence(problem, words)).join(" ")}</td>`;
      return html`<tr id="cycle-${name}"><td>${words.text(key)}</td><td data-value=${flywheel}>${numbers.short(flywheel)}</td>${cells}</tr>`;
    };
    const lines = shown.flatMap(([name, key, role]) => {
      const points = found[name].cycle?.points.map(([, input, value]) => /** @type {const} */ ([degrees(input), value])) ?? [];
      return points.length > 0 ? [{ points, role, name: words.text(key) }] : [];
    });
    const drive = words.text(this.#motor ? "under_load.at_motor" : "under_load.at_constant", {
      rate: `${numbers.short(found.rate)} ${words.text("unit.rad_per_s")}`,
      torque: `${numbers.short(found.torque)}${words.unit === "" ? "" : ` ${words.text("unit.newton_metre")}`}`,
    });
    return html`
      <p id="cycle-drive">${drive}</p>
      <div class="load-wide"><table id="cycle-wheels"><thead><tr>${["", `J${inertia}`, "δ", `ω_m${rate}`, `ω_min${rate}`, `ω_max${rate}`].map((name) => html`<th>${name.replace("ω_m,", "ωₘ,").replace("ω_min", "ωₘᵢₙ").replace("ω_max", "ωₘₐₓ")}</th>`)}</tr></thead>
      <tbody>${shown.map(row)}</tbody></table></div>
      <div class="load-buttons">${shown.filter(([name]) => name !== "given").map(([name, key]) => html`<button type="button" class="control" id="put-${name}" @click=${() => this.#put(found[name].flywheel)}>${words.text(key)}: ${words.text("under_load.put")}</button>`)}</div>
      ${found.wittenbauer.flywheel > 0 ? nothing : html`<p>${words.text("under_load.even")}</p>`}
      <p>${words.text("under_load.methods", { difference: numbers.short(found.difference) + energy.replace(",", ""), constant: numbers.short(found.constant) + inertia.replace(",", "") })}</p>
      <div class="load-plots">
        ${lines.length > 0 ? plot({ id: "cycle-rates", across: "φ, °", up: `ω${rate}`, lines, numbers }) : nothing}
        ${plot({ id: "wittenbauer", across: `J${inertia}`, up: `ΔE${energy}`, lines: this.#tangents(found, words), numbers, marks: found.touches.map(([, one, other]) => /** @type {const} */ ([one, other])) })}
      </div>`;
  }

  /** Whether the document of the answer has a motor. */
  get #motor() {
    return Boolean(this.#document && "motor" in this.#document && this.#document.motor);
  }

  /**
   * The diagram with its two tangents, from the axis of energies to the greatest inertia.
   * @param {Found} found
   * @param {Words} words
   */
  #tangents({ diagram, slopes, intercepts }, words) {
    const most = diagram.reduce((greatest, [, inertia]) => Math.max(greatest, inertia), 0);
    const tangents = slopes.map((slope, k) => ({
      points: /** @type {[number, number][]} */ ([[0, intercepts[k]], [most, intercepts[k] + slope * most]]),
      role: k === 0 ? "accent2" : "accent3",
      name: words.text(k === 0 ? "under_load.upper" : "under_load.lower"),
      dashed: true,
    }));
    return [{ points: diagram.map(([, inertia, energy]) => /** @type {const} */ ([inertia, energy])), role: "accent1", name: "" }, ...tangents];
  }
}
