// The poses of the body: their coordinates and angles, added and removed.
import { CardList } from "assur/controls/card-list.js";
import { NumberBox, numberField } from "assur/controls/number-box.js";
import { section } from "assur/controls/section.js";
import { make, write } from "assur/core/dom.js";
import { Seen } from "assur/core/seen.js";

/**
 * @typedef {import("assur/state/model.js").OwnSnapshot<"poses">} Snapshot
 * @typedef {import("assur/state/state.js").Documents["poses"]} Document
 * @typedef {Document["poses"][number]} Pose
 */

/** Limits of the number of poses. */
const POSES = Object.freeze({ least: 2, most: 5 });

/** Coordinates and angle of a pose. `part`: the field. */
const PARTS = Object.freeze(/** @type {const} */ ([
  { part: "x", symbol: "x", unit: "" },
  { part: "y", symbol: "y", unit: "" },
  { part: "angle_deg", symbol: "θ", unit: "°" },
]));

/** Keys of the hints on the choice of hinges, by the number of poses. */
const HINTS = Object.freeze(/** @type {Readonly<Record<number, string>>} */ ({ 2: "poses.hint.two", 3: "poses.hint.three", 4: "poses.hint.four", 5: "poses.hint.five" }));

/** Coordinates and angle of a new pose are rounded to a multiple of one unit divided by this number. */
const PARTS_OF_UNIT = 100;

/** Turn from the last pose to a new one that would otherwise have the same angle, in degrees. */
const TURN = 20;

export class TaskView {
  #list;
  #hint = make("p", { id: "poses-hint" });
  #shown = new Seen();

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    this.#list = new CardList({
      kind: "poses", name: "poses", first: 1, ...POSES, written: String,
      words: { add: "poses.add", remove: "poses.remove" }, build: card, another,
    }, page);
    section("poses", "poses.heading", "poses", [this.#list.cards, this.#list.add, this.#hint]);
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    const { state, problems, words } = snapshot;
    const wrong = new Set(problems.map(({ field }) => field));
    if (this.#shown.same(state.document, words, ...wrong)) return;
    this.#list.show(snapshot, wrong);
    write(this.#hint, words.text(HINTS[state.document.poses.length] ?? "poses.hint.five"));
  }
}

/**
 * @param {Snapshot} snapshot
 * @returns {Pose} the next pose at the distance of the last two
 */
export function another({ state: { document: { poses } } }) {
  const [before, last] = poses.slice(-2);
  const next = (/** @type {keyof Pose} */ part) => Math.round((2 * last[part] - before[part]) * PARTS_OF_UNIT) / PARTS_OF_UNIT;
  const [x, y, angle] = [next("x"), next("y"), next("angle_deg")];
  return { x, y, angle_deg: angle === last.angle_deg ? angle + TURN : angle };
}

/** @type {import("assur/controls/card-list.js").ListKind<"poses", Pose>["build"]} */
function card(index, put, drafts, remove) {
  const n = String(index + 1);
  const boxes = PARTS.map(({ part, symbol, unit }) => {
    const field = `poses[${index}].${part}`;
    const input = numberField({ id: `field-pose-${part.replace("_deg", "")}-${n}`, "data-t-label": `field.poses.${part}`, "data-n": n });
    const box = new NumberBox(input, field, drafts, (value) => put({ [part]: value }));
    return { part, field, unit, box, label: make("label", {}, [make("b", {}, [symbol]), input]) };
  });
  const name = make("b", { "data-t": "poses.number", "data-n": n });
  return {
    lines: [make("div", { class: "pose" }, [name, remove, ...boxes.map(({ label }) => label)])],
    show(pose, { words: { numbers } }, wrong) {
      for (const { part, field, unit, box } of boxes) {
        const value = pose[part];
        box.show(value, { brief: numbers.brief(value) + unit, full: numbers.exact(value) + unit }, wrong.has(field));
      }
    },
  };
}
