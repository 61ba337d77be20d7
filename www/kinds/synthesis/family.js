// The map of the solutions. For two positions also the choice of a linkage on their curve, and the ranges of lengths
// and coupler angles.
import { NumberRow } from "assur/controls/number-row.js";
import { make } from "assur/core/dom.js";
import { html, render } from "assur/core/html.js";
import { Seen } from "assur/core/seen.js";
import { FamilyMap, LOOKS } from "assur/kinds/synthesis/map.js";
import { section } from "assur/controls/section.js";
import { change, inputNow } from "assur/state/change.js";
import { edited } from "assur/state/state.js";

/** Symbols of the lengths, keys of their names, and roles of their colours. */
const LENGTHS = Object.freeze([
  { symbol: "l₁", key: "map.coupler", role: "coupler" },
  { symbol: "l₂", key: "map.output", role: "rocker" },
  { symbol: "l₃", key: "map.input", role: "crank" },
]);

/** Keys of the names of the curve's parts, by verdict. */
const PARTS = Object.freeze({ turns: "map.turns", rocks: "map.rocks", disorder: "map.disorder", branch: "map.branch" });

export class FamilyView {
  #theme;
  #map;
  #row;
  #ranges = make("tbody");
  #table = make("table", { class: "solutions" }, [this.#ranges]);
  #legend = make("p", { class: "legend" });
  #shown = new Seen();

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    const { store, drafts, theme, engine } = page;
    this.#theme = theme;
    this.#map = new FamilyMap(theme, (member) => {
      drafts.drop("output");
      store.update((state) => edited(state, "synthesis", () => ({ member, trial: null })));
    });
    const kind = { field: "output", symbol: "l₂", role: "rocker", slider: { min: 0.1, max: 20, step: 0.01 } };
    this.#row = new NumberRow(kind, drafts, (value) => change(() => engine.simulator.setDimension("output", value, inputNow(page)), "output", page));
    section("synthesis", "map.heading", "family", [this.#map.element, this.#legend, this.#row.element, this.#table]);
  }

  /** @param {import("assur/kinds/synthesis/positions.js").Snapshot} snapshot */
  render(snapshot) {
    const { summary, words, problems } = snapshot;
    const wrong = problems.some(({ field }) => field === "output");
    if (this.#shown.same(summary, words, wrong, this.#theme.revision)) return;
    this.#map.show(snapshot);
    const { family, drawn } = summary;
    this.#row.element.hidden = this.#table.hidden = this.#legend.hidden = !family;
    if (!family) return;
    this.#row.show(drawn.lengths[1], words, wrong);
    const parts = /** @type {(keyof typeof PARTS)[]} */ (Object.keys(PARTS));
    render(parts.filter((part) => family.curve.verdicts.includes(part)).map((part) => entry(part, words)), this.#legend);
    const long = (/** @type {number | null} */ end) => (end === null ? words.text("map.without_end") : words.numbers.short(end));
    const turned = (/** @type {number} */ end) => words.numbers.angle(end, 3);
    render([
      ...LENGTHS.map(({ symbol, key, role }, i) => range(symbol, words.text(key), role, family.lengths[i].map(long))),
      ...family.couplers.map((ends, k) => range("φ₁", words.text("positions.number", { n: String(k + 1) }), "coupler", ends.map(turned))),
    ], this.#ranges);
  }
}

/**
 * @param {string} symbol
 * @param {string} name
 * @param {string} role
 * @param {readonly string[]} ends
 */
function range(symbol, name, role, ends) {
  return html`<tr .style=${`--accent: var(--role-${role})`}><th scope="row"><b>${symbol}</b> ${name}</th><td>${ends.join(" … ")}</td></tr>`;
}

/**
 * @param {keyof typeof PARTS} part
 * @param {import("assur/core/words.js").Words} words
 */
function entry(part, words) {
  const { role, dash } = LOOKS[part];
  const look = dash.length > 0 ? "dashed" : "solid";
  return html`<span><i class="line ${look}" .style=${`--accent: var(--role-${role})`} aria-hidden="true"></i>${words.text(PARTS[part])}</span>`;
}
