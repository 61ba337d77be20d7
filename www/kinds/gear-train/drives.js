// Drives of a train. Two of its three shafts are held or driven at given speeds. One of the two can have a multiple of
// the other's speed instead.
import { NumberRow } from "assur/controls/number-row.js";
import { section } from "assur/controls/section.js";
import { isAsked } from "assur/controls/shown.js";
import { make, write } from "assur/core/dom.js";
import { called } from "assur/core/names.js";
import { idOf } from "assur/core/quantity.js";
import { Seen } from "assur/core/seen.js";
import { subscript } from "assur/core/symbols.js";
import { edited } from "assur/state/state.js";

/**
 * @typedef {import("assur/state/model.js").OwnSnapshot<"gear-train">} Snapshot
 * @typedef {import("assur/state/state.js").Documents["gear-train"]} Document
 * @typedef {Document["drives"][number]} Drive
 * @typedef {Drive["shaft"]} Shaft
 * @typedef {import("assur/app/page.js").Page} Page
 */

/** The shafts, with the numbers of their links and the roles of their colours. */
export const SHAFTS = Object.freeze({
  sun: Object.freeze({ number: "1", role: "crank" }),
  carrier: Object.freeze({ number: "3", role: "rocker" }),
  ring: Object.freeze({ number: "4", role: "accent2" }),
});

const SPEEDS = Object.freeze({ min: -120, max: 120, step: 1 });
const FACTORS = Object.freeze({ min: -3, max: 3, step: 0.01 });

/**
 * @param {string} body
 * @returns {RegExp} the name by which a lesson asks for the body's speed
 */
export function speedOf(body) {
  return new RegExp(`^${body}\\.${idOf("angle", 1)}$`);
}

/**
 * @param {string} body
 * @param {ReadonlySet<string>} withheld
 * @returns {boolean} whether a lesson asks for the body's speed
 */
export function asksSpeed(body, withheld) {
  return isAsked(withheld, `train-${body}`, speedOf(body));
}

export class DrivesView {
  #store;
  #free = make("select", { id: "train-free", class: "control", "data-t-label": "drives.free" });
  #follows = make("output", { id: "train-follows" });
  #rows;
  #shown = new Seen();
  /** @type {Snapshot["summary"] | null} */
  #summary = null;

  /** @param {Page} page */
  constructor(page) {
    this.#store = page.store;
    this.#rows = [0, 1].map((index) => new DriveRow(index, page));
    this.#free.append(...Object.keys(SHAFTS).map((shaft) => make("option", { value: shaft, "data-t": `link.${shaft}` })));
    this.#free.addEventListener("change", () => this.#release(/** @type {Shaft} */ (this.#free.value)));
    section("gear-train", "drives.heading", "drives", [
      ...this.#rows.map(({ element }) => element),
      make("div", { class: "row train-choice" }, [make("label", { class: "name", for: "train-free", "data-t": "drives.free" }), this.#free, this.#follows]),
    ]);
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    const { state: { document }, summary, words, problems, stale, withheld } = snapshot;
    const wrong = new Set(problems.map(({ field }) => field));
    if (this.#shown.same(document.drives, summary, words, stale, withheld, ...wrong)) return;
    this.#summary = summary;
    this.#rows.forEach((row) => row.show(snapshot, wrong));
    const { free, speeds } = summary;
    if (!stale) this.#free.value = free;
    const speed = asksSpeed(free, withheld) ? "?" : words.numbers.upTo(speeds[/** @type {Shaft} */ (free)], 3);
    write(this.#follows, stale ? "" : words.text("drives.follows", { speed }));
  }

  /**
   * Frees another shaft. The shaft that was free is then driven at its present speed, so that no speed jumps.
   * @param {Shaft} shaft
   */
  #release(shaft) {
    const summary = this.#summary;
    if (!summary || shaft === summary.free) return;
    const before = /** @type {Shaft} */ (summary.free);
    this.#store.update((state) => edited(state, "gear-train", ({ drives }) => ({
      drives: drives.map((drive) => (drive.shaft === shaft
        ? { shaft: before, rpm: summary.speeds[before], start_s: drive.start_s, factor: 1 }
        : { ...drive, to: null, rpm: summary.speeds[drive.shaft] })),
    })));
  }
}

class DriveRow {
  #index;
  #store;
  #name = make("b");
  #speed;
  #factor;
  #start;
  #hold;
  #tie;

  /**
   * @param {number} index of the drive in the document
   * @param {Page} page
   */
  constructor(index, { store, drafts }) {
    this.#index = index;
    this.#store = store;
    const n = String(index + 1);
    const row = (/** @type {"rpm" | "factor" | "start_s"} */ part, /** @type {string} */ symbol, /** @type {string} */ unit, /** @type {import("assur/controls/number-row.js").SliderRange | undefined} */ slider) =>
      new NumberRow({ field: `drives[${index}].${part}`, id: `${part}-${n}`, key: `drives.${part}`, n, symbol, role: "secondary", unit, slider }, drafts, (value) => this.#put({ [part]: value }));
    this.#speed = row("rpm", "n", "", SPEEDS);
    this.#factor = row("factor", "c", "", FACTORS);
    this.#start = row("start_s", "t₀", "", undefined);
    const button = (/** @type {string} */ name, /** @type {() => void} */ press) => {
      return make("button", { id: `train-${name}-${n}`, class: "control add", type: "button", "data-t": `drives.${name}`, onclick: press });
    };
    this.#hold = button("hold", () => this.#put({ rpm: 0, to: null }));
    this.#tie = button("tie", () => this.#toggle());
    this.element = make("div", { class: "train-drive", role: "group", "aria-labelledby": `train-drive-${n}` }, [
      make("div", { class: "train-head" }, [this.#name, this.#hold, this.#tie]),
      this.#speed.element, this.#factor.element, this.#start.element,
    ]);
    this.#name.id = `train-drive-${n}`;
  }

  /**
   * @param {Snapshot} snapshot
   * @param {ReadonlySet<string | undefined>} wrong
   */
  show({ state: { document }, words }, wrong) {
    const drive = document.drives[this.#index];
    this.element.hidden = !drive;
    if (!drive) return;
    const { shaft, to, rpm, factor = 1, start_s: start = 0 } = drive;
    const { number, role } = SHAFTS[shaft];
    write(this.#name, to ? `${called(shaft, words)}: ω${subscript(number)} = cω${subscript(SHAFTS[to].number)}` : `${called(shaft, words)}: n${subscript(number)}, ${words.text("unit.per_min")}`);
    this.#name.style.setProperty("--accent", `var(--role-${role})`);
    this.element.style.setProperty("--accent", `var(--role-${role})`);
    this.#hold.setAttribute("aria-pressed", String(!to && rpm === 0));
    this.#tie.setAttribute("aria-pressed", String(Boolean(to)));
    this.#speed.element.hidden = this.#start.element.hidden = Boolean(to);
    this.#factor.element.hidden = !to;
    for (const [row, value] of /** @type {const} */ ([[this.#speed, rpm ?? 0], [this.#factor, factor], [this.#start, start]])) row.show(value, words, wrong.has(row.field));
  }

  /** Switches between a given speed and a multiple of the other driven shaft's. Only one speed can be a multiple. */
  #toggle() {
    this.#store.update((state) => edited(state, "gear-train", ({ drives }) => ({
      drives: drives.map((drive, i) => (i === this.#index ? { ...drive, to: drive.to ? null : drives[1 - i].shaft } : { ...drive, to: null })),
    })));
  }

  /** @param {Partial<Drive>} part */
  #put(part) {
    this.#store.update((state) => edited(state, "gear-train", ({ drives }) => ({
      drives: drives.map((drive, i) => (i === this.#index ? { ...drive, ...part } : drive)),
    })));
  }
}
