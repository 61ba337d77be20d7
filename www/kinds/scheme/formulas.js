// Mobility and redundant constraints, by the formulas of textbooks and contour by contour.
import { section } from "assur/controls/section.js";
import { make } from "assur/core/dom.js";
import { html, render } from "assur/core/html.js";
import { Seen } from "assur/core/seen.js";
import { actual, asked, freedomsOf, structural, sum, symbolOf } from "assur/kinds/scheme/sums.js";

/** @typedef {import("assur/kinds/scheme/opening.js").Snapshot} Snapshot */

export class FormulasView {
  #body = make("div", { id: "scheme-formulas" });
  #element;
  #shown = new Seen();

  constructor() {
    this.#element = section("scheme", "formulas.heading", "formulas", [this.#body]);
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    const { state, summary, words, stale, withheld } = snapshot;
    this.#element.hidden = state.document.task != null;
    if (stale || this.#shown.same(summary, words, stale, withheld)) return;
    const lines = [...classical(snapshot), ...byLoops(snapshot)];
    const said = lines.map(([name, ...formulas]) => html`<h3>${name}</h3>${formulas.map((one) => html`<p>${one}</p>`)}`);
    render(html`<p>${words.text("formulas.symbols")}</p>${said}`, this.#body);
  }
}

/**
 * @param {Snapshot} snapshot
 * @returns {string[][]} for each formula, its name followed by its lines
 */
function classical(snapshot) {
  const { summary, words } = snapshot;
  const { counts, redundant_by_plane: byPlane, planar } = summary;
  const { mobility, redundant, ranked } = actual(summary);
  const { numbers } = words;
  const lines = [];
  if (planar && counts.planar !== null) {
    const [symbols, values] = structural(3, counts.links, counts.pairs, words);
    lines.push([words.text("formulas.planar"), `W = ${symbols} = ${values} = ${asked(counts.planar, "w", snapshot)}`]);
  }
  const [symbols, values] = structural(6, counts.links, counts.spatial_pairs, words);
  lines.push([words.text("formulas.spatial"), `W = ${symbols} = ${values} = ${planar ? numbers.exact(counts.spatial) : asked(counts.spatial, "w", snapshot)}`]);
  const [constraints, constrained] = counts.spatial_pairs.reduce(
    ([one, other], { freedoms, count }) => {
      const by = 6 - freedoms;
      const more = (/** @type {string} */ name) => (by === 1 ? name : `${by}${name}`);
      return [[...one, more(symbolOf(freedoms))], [...other, by === 1 ? numbers.exact(count) : `${by}·${numbers.exact(count)}`]];
    },
    [/** @type {string[]} */ ([]), /** @type {string[]} */ ([])],
  );
  const all = `${constraints.join(" + ")} − 6n + W`;
  lines.push([
    words.text(ranked ? "formulas.redundant_ranked" : "formulas.redundant"),
    `q = ${all} = ${constrained.join(" + ")} − 6·${numbers.exact(counts.links)} + ${asked(mobility, "w", snapshot)} = ${asked(redundant, "q", snapshot)}`,
  ]);
  if (byPlane !== null && !ranked) {
    const pairs = counts.pairs.reduce((total, { count }) => total + count, 0);
    const removed = 5 * (pairs - counts.links);
    const inner = `(${numbers.exact(counts.links)} − ${numbers.exact(pairs)})`;
    lines[lines.length - 1].push(`q = ΣS + 2(n − P₁) = ${numbers.exact(removed)} + 2·${inner} = ${asked(byPlane, "q", snapshot)}`);
  }
  return lines;
}

/** @param {Snapshot} snapshot */
function byLoops(snapshot) {
  const { summary, words } = snapshot;
  const { sections, counts } = summary;
  const { numbers } = words;
  const name = words.text("formulas.loops");
  if (!sections) return [[name, words.text("formulas.needs_open")]];
  if (sections.loops.length === 0) return [];
  const all = counts.spatial_pairs.reduce((total, { freedoms, count }) => total + freedoms * count, 0);
  const spaces = sections.loops.map((loop) => loop.motion_space);
  // The redundant constraints of a contour are found by count, so they are omitted if the rank gives another number.
  const { ranked } = actual(summary);
  const said = sections.loops.map(({ cut, pairs, motion_space: space, redundant }) => (
    words.text("formulas.loop", { cut, pairs: pairs.join(", "), space: numbers.exact(space) }) + (ranked ? "" : `, q = ${asked(redundant, "q", snapshot)}`)
  ));
  return [[
    name, ...said,
    `ΣiP = ${freedomsOf(counts.spatial_pairs, numbers.exact(all), words)}; Σλ = ${sum(spaces, words)}`,
    `W = ΣiP − Σλ = ${numbers.exact(all)} − ${numbers.exact(spaces.reduce((total, one) => total + one, 0))} = ${asked(sections.by_loops, "w", snapshot)}`,
  ]];
}
