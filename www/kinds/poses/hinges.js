// The hinges that choose the two dyads of up to four poses: on the frame or on the body, with their coordinates.
import { NumberBox, numberField } from "assur/controls/number-box.js";
import { section } from "assur/controls/section.js";
import { make } from "assur/core/dom.js";
import { Seen } from "assur/core/seen.js";
import { edited } from "assur/state/state.js";

/**
 * @typedef {import("assur/kinds/poses/task.js").Snapshot} Snapshot
 * @typedef {import("assur/types/file.js").HingeDocument} Hinge
 */

const AXES = Object.freeze(["x", "y"]);
const PLACES = Object.freeze(/** @type {const} */ (["frame", "body"]));
/** Number of dyads. */
const DYADS = 2;

export class HingesView {
  #store;
  #section;
  #rows;
  /** @type {Snapshot | null} */
  #snapshot = null;
  #shown = new Seen();

  /** @param {import("assur/app/page.js").Page} page */
  constructor({ store, drafts }) {
    this.#store = store;
    this.#rows = Array.from({ length: DYADS }, (_, k) => {
      const n = String(k + 1);
      const on = make("select", { id: `hinge-on-${n}`, class: "control", "data-t-label": "poses.hinge.on", "data-n": n }, PLACES.map((place) => make("option", { value: place, "data-t": `poses.hinge.${place}` })));
      on.addEventListener("change", () => this.#turn(k));
      const boxes = AXES.map((axis, i) => {
        const field = `hinges[${k}].${axis}`;
        const input = numberField({ id: `field-hinge-${axis}-${n}`, "data-t-label": `field.hinges.${axis}`, "data-n": n });
        const label = make("label", {}, [make("b", {}, [axis]), input]);
        return { field, i, label, box: new NumberBox(input, field, drafts, (value) => this.#put(k, i, value)) };
      });
      return { on, boxes, element: make("div", { class: "pose card" }, [on, ...boxes.map(({ label }) => label)]) };
    });
    this.#section = section("poses", "poses.hinges", "hinges", this.#rows.map(({ element }) => element));
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    const { summary, words, problems } = snapshot;
    this.#snapshot = snapshot;
    const wrong = new Set(problems.map(({ field }) => field));
    if (this.#shown.same(summary, words, ...wrong)) return;
    const { hinges } = summary;
    this.#section.hidden = hinges.length === 0;
    for (const [k, { on, boxes, element }] of this.#rows.entries()) {
      element.hidden = hinges[k] === undefined;
      if (element.hidden) continue;
      const { on: place, at } = read(hinges[k]);
      on.value = place;
      for (const { box, field, i } of boxes) {
        box.show(at[i], { brief: words.numbers.brief(at[i]), full: words.numbers.exact(at[i]) }, wrong.has(field));
      }
    }
  }

  /**
   * @param {number} k
   * @param {number} i axis
   * @param {number} value
   */
  #put(k, i, value) {
    const hinges = this.#snapshot?.summary.hinges;
    if (!hinges?.[k]) return;
    const { on, at } = read(hinges[k]);
    this.#write(hinges.with(k, hinge(on, i === 0 ? [value, at[1]] : [at[0], value])));
  }

  /**
   * Chooses the dyad by its other hinge, which stays where it is.
   * @param {number} k
   */
  #turn(k) {
    const snapshot = this.#snapshot;
    if (!snapshot) return;
    const { hinges, pairs, number, dyads } = snapshot.summary;
    const dyad = dyads[(pairs[(number ?? 0) - 1]?.dyads[k] ?? 0) - 1];
    const on = PLACES[this.#rows[k].on.selectedIndex];
    const at = on === "frame" ? dyad?.centre : dyad?.own;
    if (at) this.#write(hinges.with(k, hinge(on, [at[0], at[1]])));
    else this.#rows[k].on.value = read(hinges[k]).on;
  }

  /** @param {readonly Hinge[]} hinges */
  #write(hinges) {
    this.#store.update((state) => edited(state, "poses", () => ({ hinges, solution: null })));
  }
}

/**
 * @param {Hinge} hinge
 * @returns {{ on: "frame" | "body", at: readonly [number, number] }}
 */
function read(hinge) {
  return "frame" in hinge ? { on: "frame", at: hinge.frame } : { on: "body", at: hinge.body };
}

/**
 * @param {"frame" | "body"} on
 * @param {[number, number]} at
 * @returns {Hinge}
 */
function hinge(on, at) {
  return on === "frame" ? { frame: at } : { body: at };
}
