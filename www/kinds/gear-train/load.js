// Motion under load: its switch, the duration of the run, the load on the free shaft, and the limits of the magnets.
import { NumberRow } from "assur/controls/number-row.js";
import { section } from "assur/controls/section.js";
import { make, write } from "assur/core/dom.js";
import { html, render } from "assur/core/html.js";
import { called } from "assur/core/names.js";
import { Seen } from "assur/core/seen.js";
import { change, inputNow } from "assur/state/change.js";
import { edited, withView } from "assur/state/state.js";

/**
 * @typedef {import("assur/kinds/gear-train/drives.js").Snapshot} Snapshot
 * @typedef {import("assur/core/words.js").Words} Words
 */

/** Terms of the energy balance, in the order of the rows. */
const ENERGIES = Object.freeze(["driven", "delivered", "dissipated", "kinetic", "potential", "imbalance"]);

/** Longest run under load, in seconds. */
const MAX_RUN = 30;

export class LoadView {
  #page;
  #loaded = make("input", { id: "field-loaded", type: "checkbox" });
  #span;
  #pull;
  #limit = make("p", { id: "train-limit" });
  #meshes = make("p", { id: "train-meshes" });
  #energies = make("tbody");
  #account;
  #shown = new Seen();

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    const { store, drafts, engine } = page;
    this.#page = page;
    this.#loaded.addEventListener("change", () => this.#load(this.#loaded.checked));
    this.#span = new NumberRow({ field: "span_s", symbol: "t", role: "secondary" }, drafts, (value) => store.update((state) => edited(state, "gear-train", () => ({ span_s: value }))));
    this.#pull = new NumberRow({ field: "load", key: "load", symbol: "T", role: "rocker", slider: { min: 0, max: 10, step: 0.1 } }, drafts, (value) =>
      change(() => engine.simulator.setDimension("load", value, inputNow(page)), "load", page));
    this.#account = make("details", { id: "train-energies" }, [
      make("summary", { "data-t": "energy.heading" }), make("table", { class: "solutions", "data-t-label": "energy.heading" }, [this.#energies]),
    ]);
    // The table is filled only in a frame, and at rest no frame follows by itself.
    this.#account.addEventListener("toggle", () => page.redraw());
    section("gear-train", "load.heading", "load", [
      make("label", { class: "check" }, [this.#loaded, " ", make("span", { "data-t": "field.loaded" })]),
      this.#pull.element, this.#limit, this.#meshes, this.#span.element, this.#account,
    ]);
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    const { state: { document }, summary, words, problems, readouts, numbersDue, stale, withheld } = snapshot;
    if (numbersDue && !stale && this.#account.open) this.#tell(readouts, words);
    const wrong = new Set(problems.map(({ field }) => field));
    if (this.#shown.same(document, summary, words, stale, withheld, ...wrong)) return;
    const { load, limits, slips, halt, free } = summary;
    const loaded = document.loaded ?? false;
    this.#loaded.checked = loaded;
    this.#loaded.disabled = !loaded && !limits;
    this.#span.show(document.span_s ?? 6, words, wrong.has("span_s"));
    this.#pull.element.hidden = this.#account.hidden = !loaded;
    if (load) this.#pull.fit(0, load.max);
    if (load) this.#pull.show(load.value, words, wrong.has("load"));
    this.#limit.hidden = !limits;
    const hidden = withheld.has("train-limit");
    if (limits) {
      const limit = hidden ? "?" : words.numbers.upTo(limits[/** @type {"sun" | "carrier" | "ring"} */ (free)], 3);
      write(this.#limit, words.text("load.limit", { shaft: called(free, words), limit }));
    }
    const lines = loaded && slips ? slips.map((count, mesh) => slipped(["sun", "ring"][mesh], count, words)) : [];
    if (halt) lines.push(words.text("load.halt", { body: called(halt.body, words), time: words.numbers.upTo(halt.time, 2) }));
    write(this.#meshes, lines.join(" "));
  }

  /**
   * Switches the load on or off. The run then restarts at time zero; under load, the load angles are plotted.
   * @param {boolean} loaded
   */
  #load(loaded) {
    this.#page.history.step(() => {
      this.#page.store.update((state) => {
        const next = edited(state, "gear-train", ({ span_s: span = 6 }) => ({ loaded, span_s: loaded ? Math.min(span, MAX_RUN) : span }));
        return withView(next, { t: 0, plot: loaded ? "load" : "angles" });
      });
    });
  }

  /**
   * @param {Snapshot["readouts"]} readouts
   * @param {Words} words
   */
  #tell(readouts, words) {
    const known = ENERGIES.filter((name) => readouts?.value(name) !== undefined);
    const titled = known.map((name) => ({ title: words.text(`energy.${name}`), value: words.numbers.brief(readouts?.value(name) ?? 0) }));
    render(titled.map(({ title, value }) => html`<tr><th scope="row">${title}</th><td>${value}</td></tr>`), this.#energies);
  }
}

/**
 * @param {string} mesh
 * @param {number} count number of periods by which the mesh has slipped
 * @param {Words} words
 */
function slipped(mesh, count, words) {
  const said = count === 0 ? words.text("load.synchronous") : words.counted("load.slipped", Math.abs(count));
  return words.text("load.slip", { mesh: words.text(`mesh.${mesh}`), said });
}
