// The table of current values; its rows are the legend of drawing and plots.
import { degrees } from "assur/core/angles.js";
import { byId, make, setData, write } from "assur/core/dom.js";
import { subscript, symbol } from "assur/core/symbols.js";
import { LISTS, wheelLink } from "assur/state/state.js";

/**
 * @typedef {import("assur/state/model.js").Snapshot} Snapshot
 * @typedef {{ name: string, order: number, output: HTMLElement }} Cell
 */

/** @type {readonly Readonly<{ name: string, role: string, symbol: string, value: string, curve?: boolean }>[]} */
const ROWS = Object.freeze([
  { name: "crank", role: "crank", symbol: "φ₁", value: "input" },
  { name: "coupler", role: "coupler", symbol: "φ₂", value: "coupler.angle" },
  { name: "rocker", role: "rocker", symbol: "φ₃", value: "rocker.angle", curve: true },
  ...[...Array(LISTS.wheels.most).keys()].map(wheelLink).map((name) => (
    { name, role: name, symbol: `φ${subscript(name.slice(5))}`, value: `${name}.angle`, curve: true }
  )),
  { name: "transmission", role: "secondary", symbol: "μ", value: "C.transmission" },
]);

/** Both coordinates of the point that is plotted, if one is. */
const AXES = Object.freeze(/** @type {const} */ (["x", "y"]));

/** What has no derivatives to be read. */
const BARE = Object.freeze(["input", "C.transmission"]);
/** @type {Readonly<Record<string, string>>} */
const IDS = Object.freeze({ input: "phi1", "C.transmission": "mu" });
const STROKES = Object.freeze(["", "′", "″"]);
const NONE = "—";

/** From these sizes on digits after the point would only take room. */
const LARGE = 1e3;
const HUGE = 1e6;

export class ReadoutTable {
  #table = byId("readouts", HTMLTableElement);
  #heads = STROKES.map(() => make("th", { scope: "col" }));
  /** @type {Cell[]} */
  #cells = [];
  /** @type {Cell[]} of what is plotted of a linkage */
  #others = [];
  #named = "";
  /** @type {HTMLElement[]} what stands beside the names of plotted angles */
  #swatches = [];
  /** @type {HTMLTableRowElement[]} of the peripheral wheels there may be */
  #wheels = [];
  /** @type {{ row: HTMLTableRowElement, point: HTMLElement }[]} */
  #coordinates = [];

  constructor() {
    this.#table.tHead?.append(make("tr", {}, [make("td"), ...this.#heads]));
    const body = this.#table.tBodies[0];
    for (const row of ROWS) {
      const [, n = ""] = /^wheel(.+)$/.exec(row.name) ?? [];
      const key = n ? "name.wheels.z" : `readouts.${row.name}`;
      const element = this.#row(row, make("span", { "data-t": key, "data-n": n }));
      if (n) this.#wheels.push(element);
      if (row.name !== "crank") element.classList.add("of-mixer");
      body.append(element);
    }
    for (const axis of AXES) {
      const point = make("span");
      const row = this.#row({ name: axis, role: axis, symbol: axis, value: axis, curve: true }, point);
      row.classList.add("of-mixer");
      this.#coordinates.push({ row, point });
      body.append(row);
    }
  }

  /** @param {Snapshot} snapshot */
  render({ state, kind, summary, readouts, phiDeg, words, stale, legible }) {
    setData(this.#table, "faded", String(stale));
    if (!legible) return;
    const { plot, axes } = state.view;
    const mixer = kind === "mixer";
    const plotted = mixer ? [] : summary.plotted;
    const ofPoint = mixer && plot !== "angles";
    if (!mixer) this.#name(plotted, summary.roles);
    this.#heads.forEach((head, order) => {
      const lengths = plotted.some((name) => !name.endsWith(".angle"));
      const shown = ofPoint ? [".angle", ".x"] : [lengths ? ".x" : ".angle"];
      const symbols = shown.map((name) => symbol({ name }, order, axes === "physical").trim());
      write(head, symbols.join(", "));
    });
    if ("ratios" in summary) for (const [index, row] of this.#wheels.entries()) row.hidden = index >= summary.ratios.length;
    for (const swatch of this.#swatches) swatch.classList.toggle("curve", !ofPoint);
    for (const { row, point } of this.#coordinates) {
      row.hidden = !ofPoint;
      write(point, subscript(plot));
    }
    for (const { name, order, output } of [...this.#cells, ...(mixer ? [] : this.#others)]) {
      const point = AXES.some((axis) => axis === name);
      if (point && !ofPoint) continue;
      const key = (point ? `${plot}.${name}` : name) + STROKES[order];
      const angle = !point && order === 0 && !/\.[xy]$/.test(name);
      const read = readouts?.[key];
      const value = key === "input" ? phiDeg : angle && read !== undefined ? degrees(read) : read;
      if (value === undefined) {
        write(output, NONE);
        output.removeAttribute("data-value");
        continue;
      }
      const size = Math.abs(value);
      const text = size < HUGE ? words.numbers.fixed(value, angle || size < LARGE ? 3 : 1) : words.numbers.brief(value);
      write(output, text + (angle ? "°" : ""));
      output.dataset.value = String(value);
    }
  }

  /**
   * Makes the rows of what is plotted of a linkage.
   * @param {readonly string[]} plotted
   * @param {Readonly<Record<string, string>>} roles of the links, by name
   */
  #name(plotted, roles) {
    if (this.#named === plotted.join()) return;
    this.#named = plotted.join();
    for (const old of this.#table.querySelectorAll("tr.of-linkage")) old.remove();
    this.#others = [];
    for (const name of plotted) {
      const [of, what] = [name.slice(0, name.lastIndexOf(".")), name.slice(name.lastIndexOf(".") + 1)];
      const label = make("span", {}, [what === "angle" ? of : subscript(of)]);
      const row = this.#row(
        { name, role: what === "angle" ? (roles[of] ?? "coupler") : what, symbol: what === "angle" ? "φ" : what, value: name, curve: true }, label, this.#others,
      );
      row.className = "of-linkage";
      this.#table.tBodies[0].append(row);
    }
  }

  /**
   * @param {(typeof ROWS)[number]} row
   * @param {HTMLElement} label
   * @param {Cell[]} [into]
   */
  #row({ name, role, symbol, value, curve }, label, into = this.#cells) {
    const swatch = make("i", { class: curve ? "swatch curve" : "swatch", "aria-hidden": "true" });
    const title = make("th", { scope: "row", style: `--accent: var(--role-${role})` }, [
      swatch,
      make("b", {}, [symbol]),
      " ",
      label,
    ]);
    if (curve && into === this.#cells && value.includes(".")) this.#swatches.push(swatch);
    const cells = STROKES.map((_, order) => {
      if (order > 0 && BARE.includes(value)) return make("td");
      const output = make("td", { id: `out-${IDS[value] ?? "d".repeat(order) + name}` });
      into.push({ name: value, order, output });
      return output;
    });
    return make("tr", {}, [title, ...cells]);
  }
}
