// Rank of the constraints in the given geometry, and replacements of pairs after which no constraint is redundant.
import { section } from "assur/controls/section.js";
import { make } from "assur/core/dom.js";
import { html, nothing, render } from "assur/core/html.js";
import { called } from "assur/core/names.js";
import { Seen } from "assur/core/seen.js";
import { asked } from "assur/kinds/scheme/sums.js";
import { change } from "assur/state/change.js";

/**
 * @typedef {import("assur/kinds/scheme/opening.js").Snapshot} Snapshot
 * @typedef {Snapshot["summary"]} Summary
 */

/** Number of replacements shown. The others are folded away. */
const SHOWN = 12;

export class GeometryView {
  #page;
  #body = make("div", { id: "scheme-geometry" });
  #mended = make("div", { id: "scheme-mended" });
  #sections;
  #shown = new Seen();

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    this.#page = page;
    this.#sections = [
      section("scheme", "geometry.heading", "geometry", [this.#body]),
      section("scheme", "replace.heading", "replace", [this.#mended]),
    ];
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    const { state, summary, words, stale, withheld } = snapshot;
    const [geometry, mended] = this.#sections;
    geometry.hidden = state.document.task != null;
    mended.hidden = geometry.hidden || !summary.mended || (summary.space?.redundant ?? 0) === 0;
    if (stale || this.#shown.same(summary, words, stale, withheld)) return;
    render(lines(snapshot).map((line) => html`<p>${line}</p>`), this.#body);
    this.#showMended(summary, words);
  }

  /**
   * @param {Summary} summary
   * @param {import("assur/core/words.js").Words} words
   */
  #showMended({ mended }, words) {
    const { list, complete } = mended ?? { list: [], complete: true };
    const rows = list.map((changes, i) => {
      const n = i + 1;
      const said = changes.map(({ pair, kind }) => words.text("replace.change", { pair, kind: words.text(`pair.${kind}`) })).join("; ");
      const take = words.text("replace.take");
      const act = () => change(() => this.#page.engine.simulator.setDimension("mended", n, 0), "pairs", this.#page);
      return html`<li><span>${said}</span><button id="mended-${n}" class="control" type="button" aria-label="${take}: ${said}" @click=${act}>${take}</button></li>`;
    });
    const rest = rows.slice(SHOWN);
    render(html`
      <p>${words.text(rows.length > 0 ? "replace.said" : "replace.none")}</p>
      <ul class="mended">${rows.slice(0, SHOWN)}</ul>
      ${rest.length > 0 ? html`<details><summary>${words.text("replace.more")}</summary><ul class="mended">${rest}</ul></details>` : nothing}
      ${complete ? nothing : html`<p>${words.text("replace.beyond")}</p>`}`, this.#mended);
  }
}

/** @param {Snapshot} snapshot */
function lines(snapshot) {
  const { summary: { plane, space, missing, mobility }, words } = snapshot;
  const { numbers } = words;
  if (!space) return missing === null ? [] : [words.text("geometry.unknown", { pair: missing })];
  const said = [];
  const own = plane ?? space;
  if (plane) said.push(words.text("geometry.plane", { rank: numbers.exact(plane.rank), w: asked(plane.mobility, "rank", snapshot) }));
  const values = { rank: numbers.exact(space.rank), w: asked(space.mobility, "rank", snapshot), q: asked(space.redundant, "q", snapshot) };
  said.push(words.text("geometry.space", values));
  const right = own.mobility === mobility;
  said.push(words.text(right ? "geometry.agrees" : "geometry.differs", { counted: asked(mobility, "w", snapshot) }));
  const borne = [...(plane?.redundancies ?? []), ...(plane && plane.redundant > 0 ? [] : space.redundancies)];
  // If a lesson asks for q, the lines on redundant constraints would give it away.
  if (snapshot.withheld.has("scheme-q")) return said;
  for (const { count, pairs } of borne) said.push(words.counted("geometry.redundant", count, { pairs: pairs.join(", ") }));
  for (const links of own.idle) said.push(words.counted("geometry.idle", links.length, { links: links.map((link) => called(link, words)).join(", ") }));
  if (own.instantaneous) said.push(words.text("geometry.instantaneous"));
  else if (own.generic !== null && own.generic !== own.mobility) said.push(words.text("geometry.generic", { w: numbers.exact(own.generic) }));
  return said;
}
