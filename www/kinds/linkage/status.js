// The status line of a linkage: its structure, its assembly, what its crank cannot pass.
import { degrees } from "assur/core/angles.js";
import { byId, make, setData } from "assur/core/dom.js";

/**
 * @typedef {import("assur/engine.js").MotionSummary} Summary
 * @typedef {import("assur/kinds/linkage/rail.js").Snapshot} Snapshot
 * @typedef {import("assur/core/words.js").Words} Words
 * @typedef {import("assur/state/state.js").State<"linkage">} LinkageState
 */

/** @type {Readonly<Record<string, (summary: Summary, words: Words, state: LinkageState) => string | (Node | string)[]>>} */
const ENTRIES = Object.freeze({
  mobility: ({ counts: { mobility } }, words) => words.numbers.exact(mobility),
  class: ({ class: highest, order }, words) => `${highest}, ${words.numbers.exact(order)}`,
  formula: ({ formula, groups }, _, { view }) => (view.groups ? coloured(groups) : formula),
  "linkage-assembly": ({ assembly, assemblies }, words) =>
    words.text("status.assembly_of", { number: words.numbers.exact(assembly), count: words.numbers.exact(assemblies) }),
  "linkage-range": ({ cycle }, words) => (cycle.full ? "" : cycle.arcs.map((arc) => arc.map((end) => angle(end, words)).join("…")).join(", ")),
  "linkage-dead": ({ dead_points: dead }, words) =>
    dead.map(({ input, kind, links }) => `${angle(input, words)} ${words.text(`dead.${kind}`)} (${links.join(", ")})`).join("; "),
  "linkage-change": ({ change_points: points }, words) => points.map((phi) => angle(phi, words)).join(", "),
});

const TITLES = Object.freeze({
  "linkage-assembly": "assembly", "linkage-range": "range", "linkage-dead": "dead-points", "linkage-change": "change-points",
});

export class LinkageStatus {
  #list = byId("status", HTMLElement);
  /** @type {{ name: string, entry: HTMLElement, output: HTMLElement }[]} */
  #entries = [];
  #shown = "";

  constructor() {
    for (const name of Object.keys(ENTRIES)) {
      const output = make("dd", { id: `out-${name}` });
      const title = make("dt", { "data-t": `status.${/** @type {Record<string, string>} */ (TITLES)[name] ?? name}` });
      const entry = make("div", { class: "entry of-linkage" }, [title, " ", output, " "]);
      this.#list.append(entry);
      this.#entries.push({ name, entry, output });
    }
  }

  /** @param {Snapshot} snapshot */
  render({ state, summary, words, revision, stale }) {
    setData(this.#list, "faded", String(stale));
    if (stale && this.#shown.endsWith(` ${words.lang}`)) return;
    const shown = `${revision} ${words.lang}`;
    if (shown === this.#shown) return;
    this.#shown = shown;
    for (const { name, entry, output } of this.#entries) {
      const said = ENTRIES[name](summary, words, state);
      entry.hidden = said === "";
      output.replaceChildren(...(typeof said === "string" ? [said] : said));
    }
  }
}

/**
 * @param {Summary["groups"]} groups
 * @returns {(Node | string)[]} the structural formula, beside each term the colour of its links in the drawing
 */
function coloured(groups) {
  const swatch = (/** @type {string} */ role) => make("i", { class: "swatch", style: `--accent: var(--role-${role})`, "data-role": role, "aria-hidden": "true" });
  return groups.flatMap(({ term, role }, i) => [...(i > 0 ? [" → "] : []), make("span", { class: "group" }, [swatch(role), term])]);
}

/**
 * @param {number} phi
 * @param {Words} words
 */
function angle(phi, words) {
  return `${words.numbers.upTo(degrees(phi), 2)}°`;
}
