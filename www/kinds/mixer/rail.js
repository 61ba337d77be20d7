// The rail of the mixer: presets, lengths, wheels, mesh, assembly, traced points.
import { CardList } from "assur/controls/card-list.js";
import { NumberRow } from "assur/controls/number-row.js";
import { fold } from "assur/controls/section.js";
import { make } from "assur/core/dom.js";
import { Seen } from "assur/core/seen.js";
import { TEETH, TRACER_LIST, WHEEL_LIST, staying } from "assur/kinds/mixer/lists.js";
import { contains, edited } from "assur/state/state.js";

/**
 * @typedef {import("assur/state/model.js").OwnSnapshot<"mixer">} Snapshot
 * @typedef {import("assur/state/state.js").MixerDocument} MixerDocument
 * @typedef {"l1" | "l2" | "l3" | "l4" | "z4" | "module"} NumberField
 * @typedef {import("assur/controls/number-row.js").RowKind} RowKind
 */

const LENGTH = Object.freeze({ min: 0.05, max: 1.5, step: 0.01 });

/** @type {readonly RowKind[]} */
const LENGTHS = Object.freeze([
  { field: "l1", symbol: "l₁", role: "crank", slider: LENGTH },
  { field: "l2", symbol: "l₂", role: "coupler", slider: LENGTH },
  { field: "l3", symbol: "l₃", role: "rocker", slider: LENGTH },
  { field: "l4", symbol: "l₄", role: "secondary", slider: LENGTH },
]);

/** @type {readonly RowKind[]} */
const WHEELS = Object.freeze([
  { field: "module", symbol: "m", role: "secondary" },
  { field: "z4", symbol: "z₄", role: "accent1", slider: TEETH, counted: "wheels.teeth" },
]);

const MESHES = /** @type {const} */ (["external", "internal", "as_printed"]);
const ASSEMBLIES = /** @type {const} */ ([1, 2]);

export class Rail {
  /** @type {NumberRow[]} */
  #rows = [];
  /** @type {{ button: HTMLButtonElement, document: Partial<MixerDocument> }[]} */
  #presets = [];
  /** @type {{ input: HTMLInputElement, field: "mesh" | "assembly", value: string | number }[]} */
  #choices = [];
  #lists;
  #shown = new Seen();

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    const { store, engine, drafts, mechanism } = page;
    const edit = (/** @type {Partial<MixerDocument>} */ change) => store.update((state) => edited(state, "mixer", () => change));
    const rows = (/** @type {readonly RowKind[]} */ kinds) => kinds.map((kind) => {
      const row = new NumberRow(kind, drafts, (value) => edit({ [kind.field]: value }));
      this.#rows.push(row);
      return row.element;
    });
    const wheels = new CardList(WHEEL_LIST, page);
    const tracers = new CardList(TRACER_LIST, page);
    this.#lists = [wheels, tracers];
    const presets = make("div", { id: "presets", class: "segments", role: "group", "data-t-label": "preset.heading" });
    for (const { id, document: preset } of engine.catalogue.mixers) {
      const { tracers: _, ...document } = /** @type {MixerDocument} */ (preset);
      const name = id.replace("mixer-", "");
      const button = make("button", { id: `preset-${name}`, type: "button", class: "segment", "data-t": `preset.${id}` });
      button.addEventListener("click", () => {
        drafts.dropAll(Object.keys(document));
        store.update((state) => edited(state, "mixer", ({ tracers: traced }) => ({ ...document, tracers: staying(traced, document.wheels) })));
        mechanism.fit();
      });
      presets.append(button);
      this.#presets.push({ button, document });
    }
    const mesh = MESHES.map((value) => this.#choice("mesh", value, () => edit({ mesh: value })));
    const assembly = ASSEMBLIES.map((value) => this.#choice("assembly", value, () => edit({ assembly: value })));
    fold("dimensions", [
      section("preset.heading", [presets]),
      section("lengths.heading", [make("div", { id: "lengths" }, rows(LENGTHS))]),
      folded("wheels.heading", [make("div", { id: "train" }, rows(WHEELS)), wheels.cards, wheels.add]),
    ]);
    fold("show", [section("tracers.heading", [tracers.cards, tracers.add])]);
    fold("structure", [
      choices("field.mesh", make("div", { id: "mesh", class: "choices" }, mesh)),
      choices("field.assembly", make("div", { id: "assembly", class: "segments" }, assembly)),
    ]);
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    const { state, problems, words, summary } = snapshot;
    const wrong = new Set(problems.map(({ field }) => field));
    if (this.#shown.same(state.document, words, summary, ...wrong)) return;
    for (const row of this.#rows) row.show(state.document[/** @type {NumberField} */ (row.field)], words, wrong.has(row.field));
    for (const list of this.#lists) list.show(snapshot, wrong);
    for (const { button, document } of this.#presets) {
      button.setAttribute("aria-pressed", String(contains(state.document, document)));
    }
    for (const { input, field, value } of this.#choices) input.checked = state.document[field] === value;
  }

  /**
   * @param {"mesh" | "assembly"} field
   * @param {string | number} value
   * @param {() => void} choose
   */
  #choice(field, value, choose) {
    const input = make("input", { id: `${field}-${value}`, type: "radio", name: field, value: String(value), onchange: choose });
    if (field === "assembly") input.setAttribute("aria-keyshortcuts", String(value));
    this.#choices.push({ input, field, value });
    return make("label", { class: field === "mesh" ? "choice" : "segment" }, [input, make("span", { "data-t": `${field}.${value}` })]);
  }
}

/**
 * @param {string} key of the heading
 * @param {readonly HTMLElement[]} content
 */
function section(key, content) {
  return make("section", { "data-of": "mixer" }, [make("h2", { "data-t": key }), ...content]);
}

/**
 * @param {string} key of the heading
 * @param {readonly HTMLElement[]} content
 */
function folded(key, content) {
  return make("details", { id: "fold-wheels", "data-of": "mixer", class: "fold within" }, [make("summary", { "data-t": key }), ...content]);
}

/**
 * @param {string} key of the legend
 * @param {HTMLElement} content
 */
function choices(key, content) {
  return make("fieldset", { "data-of": "mixer", "data-field": content.id }, [make("legend", { "data-t": key }), content]);
}
