// The table of current values; its rows are the legend of drawing and plots.
import { degrees } from "assur/angles.js";
import { byId, make, setData, write } from "assur/dom.js";

/**
 * @typedef {import("assur/model.js").Snapshot} Snapshot
 * @typedef {{ name: string, angle: boolean, output: HTMLElement }} Cell
 */

/** @type {readonly Readonly<{ name: string, role: string, symbol: string, curve?: boolean, values: readonly string[] }>[]} */
const ROWS = Object.freeze([
  { name: "crank", role: "crank", symbol: "φ₁", values: ["phi1"] },
  { name: "coupler", role: "coupler", symbol: "φ₂", values: ["coupler", "dcoupler", "ddcoupler"] },
  { name: "rocker", role: "rocker", symbol: "φ₃", curve: true, values: ["rocker", "drocker", "ddrocker"] },
  { name: "wheel5", role: "wheel5", symbol: "φ₅", curve: true, values: ["wheel5", "dwheel5", "ddwheel5"] },
  { name: "transmission", role: "secondary", symbol: "μ", values: ["transmission"] },
]);

const HEAD = Object.freeze(["φ", "φ′", "φ″"]);
const NONE = "—";

export class ReadoutTable {
  #table = byId("readouts", HTMLTableElement);
  /** @type {Cell[]} */
  #cells = [];

  constructor() {
    const head = HEAD.map((symbol) => make("th", { scope: "col" }, [symbol]));
    this.#table.tHead?.append(make("tr", {}, [make("td"), ...head]));
    for (const row of ROWS) this.#table.tBodies[0].append(this.#row(row));
  }

  /** @param {Snapshot} snapshot */
  render({ readouts, phiDeg, words, stale, legible }) {
    setData(this.#table, "faded", String(stale));
    if (!legible) return;
    for (const { name, angle, output } of this.#cells) {
      const value = name === "phi1" ? phiDeg : readouts && (angle ? degrees(readouts[name]) : readouts[name]);
      if (value === null) {
        write(output, NONE);
        output.removeAttribute("data-value");
        continue;
      }
      write(output, words.numbers.fixed(value, 3) + (angle ? "°" : ""));
      output.dataset.value = String(value);
    }
  }

  /** @param {(typeof ROWS)[number]} row */
  #row({ name, role, symbol, curve, values }) {
    const title = make("th", { scope: "row", style: `--accent: var(--role-${role})` }, [
      make("i", { class: curve ? "swatch curve" : "swatch", "aria-hidden": "true" }),
      make("b", {}, [symbol]),
      " ",
      make("span", { "data-t": `readouts.${name}` }),
    ]);
    const cells = HEAD.map((_, order) => {
      const value = values[order];
      if (!value) return make("td");
      const output = make("td", { id: value === "transmission" ? "out-mu" : `out-${value}` });
      this.#cells.push({ name: value, angle: order === 0, output });
      return output;
    });
    return make("tr", {}, [title, ...cells]);
  }
}
