// The task of a synthesis: the frame, and the wanted positions of output link and driver.
import { CardList } from "assur/controls/card-list.js";
import { NumberBox, numberField } from "assur/controls/number-box.js";
import { NumberRow } from "assur/controls/number-row.js";
import { degrees, radians } from "assur/core/angles.js";
import { make } from "assur/core/dom.js";
import { attempt } from "assur/core/problem.js";
import { section } from "assur/controls/section.js";
import { FunctionView } from "assur/kinds/synthesis/function.js";
import { Seen } from "assur/core/seen.js";
import { edited } from "assur/state/state.js";

/**
 * @typedef {import("assur/state/model.js").OwnSnapshot<"synthesis">} Snapshot
 * @typedef {import("assur/state/state.js").Documents["synthesis"]} Document
 * @typedef {Document["positions"][number]} Position
 */

/** Limit of the number of positions on the page. The engine accepts more, but a drawing could not show them apart. */
export const MAX_POSITIONS = 12;

/** Step of the input from the last position, in degrees, repeated until the linkage can reach a new position. */
const NEXT = 30;

/** @type {readonly (import("assur/controls/number-row.js").RowKind & { field: "frame" | "phi0_deg" })[]} */
const FRAME = Object.freeze([
  { field: "frame", symbol: "l₀", role: "secondary", slider: { min: 1, max: 20, step: 0.1 } },
  { field: "phi0_deg", symbol: "φ₀", role: "secondary", unit: "°" },
]);

/** Angles and weight of a position. `part`: the field. `role`: role of the colour. */
const PARTS = Object.freeze(/** @type {const} */ ([
  { part: "coupler_deg", symbol: "φ₁", role: "coupler", unit: "°" },
  { part: "output_deg", symbol: "φ₂", role: "rocker", unit: "°" },
  { part: "input_deg", symbol: "φ₃", role: "crank", unit: "°" },
  { part: "weight", symbol: "w", role: "secondary", unit: "" },
]));

/** Initial coupler angles are rounded to a multiple of one degree divided by this number. */
const PARTS_OF_DEGREE = 10;

/** @type {Omit<import("assur/controls/card-list.js").ListKind<"synthesis", Position>, "another">} */
const POSITIONS = Object.freeze({
  kind: "synthesis", name: "positions", first: 1, least: 2, most: MAX_POSITIONS, written: String,
  words: { add: "positions.add", remove: "positions.remove" }, build: card,
});

export class PositionsView {
  /** @type {{ row: NumberRow, field: "frame" | "phi0_deg" }[]} */
  #frame;
  #engine;
  #list;
  #function;
  #couplers = make("input", { id: "couplers", type: "checkbox" });
  #free = make("input", { id: "free", type: "checkbox" });
  /** @type {Snapshot | null} */
  #snapshot = null;
  #shown = new Seen();

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    const { store, drafts, engine } = page;
    const edit = (/** @type {Partial<Document>} */ change) => store.update((state) => edited(state, "synthesis", () => change));
    this.#frame = FRAME.map((kind) => ({ field: kind.field, row: new NumberRow(kind, drafts, (value) => edit({ [kind.field]: value })) }));
    this.#engine = engine;
    this.#list = new CardList({ ...POSITIONS, another: (snapshot) => this.#another(snapshot) }, page);
    this.#function = new FunctionView(page);
    this.#couplers.addEventListener("change", () => {
      if (this.#snapshot) edit({ positions: this.#couplers.checked ? withCouplers(this.#snapshot) : this.#snapshot.state.document.positions.map(({ output_deg, input_deg, weight }) => ({ output_deg, input_deg, weight })) });
    });
    this.#free.addEventListener("change", () => edit({ free: this.#free.checked }));
    section("synthesis", "positions.frame", "frame", this.#frame.map(({ row }) => row.element));
    section("synthesis", "positions.heading", "positions", [
      this.#list.cards, this.#list.add,
      make("label", { class: "check" }, [this.#couplers, " ", make("span", { "data-t": "positions.couplers" })]),
      make("label", { class: "check" }, [this.#free, " ", make("span", { "data-t": "positions.free" })]),
      this.#function.element,
    ]);
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    const { state, problems, words, summary } = snapshot;
    this.#snapshot = snapshot;
    this.#function.render(snapshot);
    const wrong = new Set(problems.map(({ field }) => field));
    if (this.#shown.same(state.document, words, summary, ...wrong)) return;
    for (const { row, field } of this.#frame) row.show(state.document[field], words, wrong.has(field));
    this.#list.show(snapshot, wrong);
    this.#couplers.checked = areGiven(state.document);
    this.#free.checked = state.document.free;
  }

  /**
   * @param {Snapshot} snapshot
   * @returns {Position} the next position that the drawn linkage reaches; if there is none, a copy of the last position with another input
   */
  #another({ state: { document: { positions } }, summary: { drawn: { starts: [outputStart, inputStart] } } }) {
    const last = positions[positions.length - 1];
    for (let by = NEXT; by < 360; by += NEXT) {
      const input = (last.input_deg + by) % 360;
      const here = attempt(() => this.#engine.at(radians(input) + inputStart)).value;
      const output = here?.readouts?.value("rocker.angle");
      if (output === undefined || positions.some(({ input_deg: given }) => given === input)) continue;
      const turned = degrees(output - outputStart) % 360;
      return { output_deg: turned < 0 ? turned + 360 : turned, input_deg: input, weight: 1 };
    }
    return { ...last, input_deg: (last.input_deg + NEXT) % 360 };
  }
}

/** @param {Document} document */
function areGiven({ positions }) {
  return positions.some(({ coupler_deg: angle }) => typeof angle === "number");
}

/**
 * @param {Snapshot} snapshot
 * @returns {Position[]} the positions with the rounded coupler angles of the drawn linkage
 */
function withCouplers({ state: { document: { positions } }, summary: { wanted } }) {
  return positions.map((position, k) => {
    const turned = Math.round(degrees(wanted[k]?.coupler ?? 0) * PARTS_OF_DEGREE) / PARTS_OF_DEGREE;
    return { ...position, coupler_deg: turned };
  });
}

/** @type {import("assur/controls/card-list.js").ListKind<"synthesis", Position>["build"]} */
function card(index, put, drafts, remove) {
  const n = String(index + POSITIONS.first);
  const boxes = PARTS.map(({ part, symbol, role, unit }) => {
    const field = `positions[${index}].${part}`;
    const input = numberField({ id: `field-${part.replace("_deg", "")}-${n}`, "data-t-label": `field.positions.${part}`, "data-n": n });
    const box = new NumberBox(input, field, drafts, (value) => put({ [part]: value }));
    const label = make("label", { class: `position-part ${part}`, style: `--accent: var(--role-${role})` }, [make("b", {}, [symbol]), input]);
    return { part, field, unit, box, label };
  });
  const name = make("b", { "data-t": "positions.number", "data-n": n });
  return {
    lines: [make("div", { class: "position" }, [name, ...boxes.map(({ label }) => label), remove])],
    show(position, { words: { numbers }, state, summary }, wrong) {
      // Three positions or fewer are met exactly, whatever their weights.
      const weighed = state.document.positions.length > 3;
      const shown = { output_deg: true, input_deg: true, weight: weighed, coupler_deg: areGiven(state.document) };
      for (const { part, field, unit, box, label } of boxes) {
        label.hidden = !shown[part];
        const value = position[part] ?? degrees(summary.wanted[index]?.coupler ?? 0);
        box.show(value, { brief: numbers.brief(value) + unit, full: numbers.exact(value) + unit }, wrong.has(field));
      }
    },
  };
}
