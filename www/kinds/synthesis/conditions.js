// The conditions of the paper for one position at its coupler angle: each with its value and verdict, and beside them what is true.
import { degrees } from "assur/core/angles.js";
import { make } from "assur/core/dom.js";
import { Seen } from "assur/core/seen.js";
import { Plane } from "assur/kinds/synthesis/plane.js";
import { section } from "assur/controls/section.js";

/**
 * @typedef {import("assur/kinds/synthesis/positions.js").Snapshot} Snapshot
 * @typedef {import("assur/types/web.js").WantedSummary} Wanted
 * @typedef {import("assur/core/words.js").Words} Words
 */

export class ConditionsView {
  #theme;
  #region;
  #content = make("div");
  /** @type {Snapshot | null} */
  #snapshot = null;
  #shown = new Seen();

  /** @param {import("assur/app/page.js").Page} page */
  constructor({ theme }) {
    this.#theme = theme;
    this.#region = new Plane("synthesis-region", theme, ["l₁", "l₂"], () => this.#paint());
    section("synthesis", "conditions.heading", "conditions", [
      make("details", { id: "synthesis-conditions" }, [
        make("summary", { "data-t": "conditions.show" }), this.#content,
        make("p", { class: "legend", "data-t": "region.heading" }), this.#region.element,
      ]),
    ]);
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    const { summary, words } = snapshot;
    if (this.#shown.same(summary, words, this.#theme.revision)) return;
    this.#snapshot = snapshot;
    this.#content.replaceChildren(...summary.wanted.map((one, k) => table(one, k + 1, words)));
    this.#region.element.ariaLabel = words.text("region.label");
    this.#paint();
  }

  /** The region in which some input closes the contour in every position, and the lengths that are drawn. */
  #paint() {
    if (!this.#snapshot) return;
    const { summary: { frame, closed, wanted, drawn }, words } = this.#snapshot;
    if (!this.#region.begin(frame, words)) return;
    this.#region.shade(closed, (count) => (count / wanted.length) ** 2);
    this.#region.dot(drawn.lengths, "ink");
    this.#region.end();
  }
}

/**
 * @param {Wanted} wanted
 * @param {number} k
 * @param {Words} words
 */
function table({ at, conditions, theorems, interval }, k, words) {
  const { numbers } = words;
  const rows = conditions.map(({ number, about, value, holds }) => make("tr", {}, [
    make("th", { scope: "row" }, [[number, about ?? ""].join(" ").trim()]),
    make("td", {}, [value === null ? "—" : numbers.short(value)]),
    make("td", { "data-holds": String(holds) }, [holds ? "✓" : "✗", make("span", { class: "unseen" }, [words.text(holds ? "conditions.holds" : "conditions.fails")])]),
  ]));
  const judged = theorems.map(({ number, conditions: asked, truth }) => make("tr", {}, [
    make("th", { scope: "row" }, [words.text("conditions.theorem", { n: String(number) })]),
    make("td", { colspan: "2", "data-holds": String(!asked || truth) }, [words.text(asked ? (truth ? "conditions.right" : "conditions.wrong") : "conditions.silent")]),
  ]));
  const ends = interval && interval.map((end) => (end === null ? words.text("map.without_end") : numbers.short(end)));
  const truth = ends ? words.text("conditions.interval", { from: ends[0], to: ends[1] }) : words.text("conditions.empty");
  const name = words.text("conditions.of", { n: String(k), coupler: `${numbers.upTo(degrees(at), 3)}°` });
  return make("table", { class: "solutions conditions" }, [
    make("caption", {}, [name]),
    make("tbody", {}, [...rows, ...judged, make("tr", { class: "truth" }, [make("th", { scope: "row" }, [words.text("conditions.truth")]), make("td", { colspan: "2" }, [truth])])]),
  ]);
}
