// The path: what its points mean, their coordinates, and the pen that draws a path on the paper.
import { CardList } from "assur/controls/card-list.js";
import { NumberBox, numberField } from "assur/controls/number-box.js";
import { section } from "assur/controls/section.js";
import { make, write } from "assur/core/dom.js";
import { parseNumber } from "assur/core/numbers.js";
import { Seen } from "assur/core/seen.js";
import { Pen, nextAngles } from "assur/kinds/point-path/pen.js";
import { Photograph } from "assur/kinds/point-path/photograph.js";
import { saidOf } from "assur/kinds/point-path/verdict.js";
import { edited } from "assur/state/state.js";

/**
 * @typedef {import("assur/kinds/point-path/verdict.js").Snapshot} Snapshot
 * @typedef {import("assur/state/state.js").Documents["point-path"]} Document
 * @typedef {Document["path"][number]} Place
 */

const COURSES = Object.freeze(/** @type {const} */ (["points", "open", "closed"]));

/** Limits of the number of points that are listed one by one. */
const POINTS = Object.freeze({ least: 3, most: 24 });

/** Field of the crank angles. */
const ANGLES = "angles_deg";

const AXES = Object.freeze(/** @type {const} */ (["x", "y"]));

/** A new point is rounded to a multiple of a power of ten near its distance from the last divided by this number. */
const PARTS_OF_STEP = 1000;

export class TaskView {
  #store;
  #course = make("select", { id: "path-course", class: "control", "data-t-label": "path.course" }, COURSES.map((course) => make("option", { value: course, "data-t": `path.course.${course}` })));
  #angles = make("input", { id: "field-angles", class: "control", type: "text", autocomplete: "off", spellcheck: "false" });
  #anglesLabel = make("label", { class: "path-angles" }, [make("span", { "data-t": "path.angles" }), this.#angles]);
  /** The crank angles of the document as text. */
  #written = "";
  #list;
  #count = make("p", { id: "path-count" });
  #said = make("p", { id: "path-said" });
  #pen;
  #photograph;
  #shown = new Seen();

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    this.#store = page.store;
    this.#pen = new Pen(page);
    this.#photograph = new Photograph(page);
    this.#course.addEventListener("change", () => {
      const course = COURSES[this.#course.selectedIndex];
      this.#store.update((state) => edited(state, "point-path", ({ angles_deg: angles }) => ({ course, angles_deg: course === "points" ? angles : [], linkage: null })));
    });
    this.#angles.addEventListener("input", () => this.#putAngles(page));
    this.#angles.addEventListener("blur", () => {
      if (!page.drafts.has(ANGLES)) this.#angles.value = this.#written;
    });
    this.#list = new CardList({
      kind: "point-path", name: "path", first: 1, ...POINTS, written: String,
      words: { add: "path.add", remove: "path.remove" }, build: card, another,
      beside: (document) => ({ angles_deg: nextAngles(document) }),
      without: (index, { path, angles_deg: angles = [] }) => ({ path: path.filter((_, at) => at !== index), angles_deg: angles?.filter((_, at) => at !== index) }),
    }, page);
    section("point-path", "path.heading", "path", [this.#course, this.#pen.button, this.#pen.hint, this.#photograph.element, this.#list.cards, this.#list.add, this.#anglesLabel, this.#count, this.#said]);
  }

  /**
   * Takes the typed crank angles: numbers with spaces or semicolons between them, none if the angles are free.
   * @param {import("assur/app/page.js").Page} page
   */
  #putAngles({ drafts, store }) {
    const angles = this.#angles.value.split(/[;\s]+/).filter(Boolean).map((text) => parseNumber(text.replace("°", "")));
    if (angles.includes(null)) {
      drafts.keep(ANGLES);
      return;
    }
    drafts.drop(ANGLES);
    const numbers = angles.map(Number);
    store.update((state) => edited(state, "point-path", () => ({ angles_deg: numbers, linkage: null })));
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    const { state, problems, words, summary } = snapshot;
    const { course = "points", path, angles_deg: angles } = state.document;
    this.#photograph.render(snapshot);
    const wrong = new Set(problems.map(({ field }) => field));
    if (this.#shown.same(state.document, summary, words, ...wrong)) return;
    this.#course.value = course;
    const listed = path.length <= POINTS.most;
    this.#list.cards.hidden = this.#list.add.hidden = !listed;
    this.#count.hidden = listed;
    if (listed) this.#list.show(snapshot, wrong);
    this.#anglesLabel.hidden = course !== "points";
    this.#written = (angles ?? []).map((angle) => words.numbers.exact(angle)).join("; ");
    if (document.activeElement !== this.#angles) this.#angles.value = this.#written;
    this.#angles.setAttribute("aria-invalid", String([...wrong].some((field) => field?.startsWith(ANGLES)) || problems.some(({ code }) => code === "angles_of_points")));
    write(this.#count, words.text("path.count", { count: words.numbers.exact(path.length) }));
    write(this.#said, saidOf(snapshot).join(" "));
  }
}

/**
 * @param {Snapshot} snapshot
 * @returns {Place} the next point at the distance of the last two
 */
export function another({ state: { document: { path } } }) {
  const [before, last] = path.slice(-2);
  const step = Math.max(Math.hypot(last[0] - before[0], last[1] - before[1]), Number.MIN_VALUE);
  const parts = 10 ** Math.min(Math.ceil(Math.log10(PARTS_OF_STEP / step)), 300);
  const next = (/** @type {0 | 1} */ axis) => Math.round((2 * last[axis] - before[axis]) * parts) / parts;
  return [next(0), next(1)];
}

/** @type {import("assur/controls/card-list.js").ListKind<"point-path", Place>["build"]} */
function card(index, put, drafts, remove) {
  const n = String(index + 1);
  /** @type {Place} */
  let here = [0, 0];
  const boxes = AXES.map((axis, i) => {
    const field = `path[${index}].${axis}`;
    const input = numberField({ id: `field-point-${axis}-${n}`, "data-t-label": `field.path.${axis}`, "data-n": n });
    const box = new NumberBox(input, field, drafts, (value) => put(i === 0 ? [value, here[1]] : [here[0], value]));
    return { field, i, box, label: make("label", {}, [make("b", {}, [axis]), input]) };
  });
  return {
    lines: [make("div", { class: "path-point" }, [make("b", {}, [n]), ...boxes.map(({ label }) => label), remove])],
    show(point, { words: { numbers } }, wrong) {
      here = point;
      for (const { field, i, box } of boxes) box.show(point[i], { brief: numbers.brief(point[i]), full: numbers.exact(point[i]) }, wrong.has(field));
    },
  };
}
