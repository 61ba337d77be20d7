// The conditions of the paper for one position at its coupler angle: each with its value and verdict, and beside them what is true.
import { degrees } from "assur/core/angles.js";
import { make } from "assur/core/dom.js";
import { section } from "assur/kinds/synthesis/section.js";

/**
 * @typedef {import("assur/kinds/synthesis/positions.js").Snapshot} Snapshot
 * @typedef {import("assur/types/web.js").WantedSummary} Wanted
 * @typedef {import("assur/core/words.js").Words} Words
 */

export class ConditionsView {
  #content = make("div");
  /** @type {readonly unknown[]} what was shown last */
  #shown = [];

  constructor() {
    section("conditions.heading", "conditions", [
      make("details", { id: "synthesis-conditions" }, [make("summary", { "data-t": "conditions.show" }), this.#content]),
    ]);
  }

  /** @param {Snapshot} snapshot */
  render({ summary, words }) {
    const shown = [summary, words];
    if (shown.every((part, i) => part === this.#shown[i])) return;
    this.#shown = shown;
    this.#content.replaceChildren(...summary.wanted.map((one, k) => table(one, k + 1, words)));
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
