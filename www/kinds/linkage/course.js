// The plotted output over a turn: stroke, dwell and cyclogram in the rail; the dwell shaded and magnified on the plots.
import { NumberRow } from "assur/controls/number-row.js";
import { readoutCell } from "assur/controls/readout.js";
import { fold } from "assur/controls/section.js";
import { cellOf } from "assur/controls/shown.js";
import { make, write } from "assur/core/dom.js";
import { html, render } from "assur/core/html.js";
import { called } from "assur/core/names.js";
import { attempt } from "assur/core/problem.js";
import { Seen } from "assur/core/seen.js";
import { DesignView } from "assur/kinds/linkage/design.js";
import { across, down } from "assur/plots/panel.js";
import { setChartFont } from "assur/plots/text.js";
import { withDocument } from "assur/state/state.js";

/**
 * @typedef {import("assur/types/web.js").ProfileSummary} Profile
 * @typedef {import("assur/types/web.js").PanelLayout} Panel
 * @typedef {import("assur/kinds/linkage/rail.js").Snapshot} Snapshot
 * @typedef {import("assur/canvas/theme.js").Theme} Theme
 * @typedef {import("assur/canvas/boxes.js").Box} Box
 * @typedef {import("assur/core/words.js").Words} Words
 */

/** Opacity of the shade over a dwell. */
const SHADE = 0.14;
/** Number of intervals of the magnified curve. */
const POINTS = 96;
/** Share of the dwell's arc that is magnified in plots of derivatives, which rise steeply at the ends of the arc. */
const INNER = 0.8;
/** Size of an inset relative to the plot. */
const INSET = Object.freeze({ width: 0.42, height: 0.42 });
/** Height of the line of text above the magnified curve, in pixels at the usual text size. */
const HEAD = 15;

/**
 * Paints the dwell over the plots of the output, if the document has a band for this output.
 * @type {import("assur/plots/chart.js").Overlay}
 */
export function paintCourse(context, panels, { kind, state, summary, words }, engine, theme) {
  if (kind !== "linkage" || state.kind !== "linkage") return [];
  const { profile, cycle, plotted } = summary;
  const { band, plots } = state.document;
  const dwell = profile?.dwell;
  if (!band || !dwell || (plots?.[0] ?? plotted[0]) !== plotted[0]) return [];
  return panels.map((panel) => {
    const value = (/** @type {number} */ input) => attempt(() => engine.simulator.plotted(input)).value?.[panel.order];
    return paintDwell(context, panel, dwell, cycle, value, words, theme);
  });
}

/**
 * Shades the dwell on a plot of the output or of a derivative. Magnifies it in an inset as in fig. 2 of the paper.
 * @param {import("assur/canvas/painter.js").Context} context
 * @param {Panel} panel
 * @param {NonNullable<Profile["dwell"]>} dwell
 * @param {{ start: number, end: number }} cycle
 * @param {(input: number) => number | undefined} value of the plot's curve at a crank angle
 * @param {Words} words
 * @param {Theme} theme
 * @returns {Box | null} box of the inset; null if there is nothing to magnify
 */
function paintDwell(context, panel, dwell, { start, end }, value, words, theme) {
  const period = end - start;
  const turns = period * Math.floor((dwell.arc[0] - start) / period);
  const [from, to] = [dwell.arc[0] - turns, dwell.arc[1] - turns];
  context.fillStyle = theme.colours.coupler;
  context.globalAlpha = SHADE;
  // A dwell that crosses the end of the axis continues at the start of the axis.
  for (const shift of [-period, 0]) {
    const [left, right] = [Math.max(from + shift, start), Math.min(to + shift, end)].map((input) => across(panel, input));
    if (right > left) context.fillRect(left, panel.top, right - left, panel.height);
  }
  context.globalAlpha = 1;
  const spared = panel.order === 0 ? 0 : ((1 - INNER) / 2) * (to - from);
  return paintInset(context, panel, [from + spared, to - spared], panel.order === 0 ? dwell.band : null, value, words, theme);
}

/**
 * @param {import("assur/canvas/painter.js").Context} context
 * @param {Panel} panel
 * @param {readonly [number, number]} arc to magnify
 * @param {readonly [number, number] | null} band range of the output in the inset; null for the range of the curve
 * @param {(input: number) => number | undefined} value
 * @param {Words} words
 * @param {Theme} theme
 * @returns {Box | null}
 */
function paintInset(context, panel, [from, to], band, value, words, theme) {
  const curve = Array.from({ length: POINTS + 1 }, (_, i) => value(from + ((to - from) * i) / POINTS));
  const known = curve.filter((at) => at !== undefined);
  const [least, most] = band ?? [Math.min(...known), Math.max(...known)];
  if (!(most > least)) return null;
  const [width, height] = [INSET.width * panel.width, INSET.height * panel.height];
  // The inset lies in the upper or lower half of the plot, opposite the dwell.
  const middle = down(panel, (least + most) / 2) - panel.top;
  const top = panel.top + (middle > panel.height / 2 ? 6 : panel.height - height - 6);
  const shown = Math.min(Math.max(across(panel, (from + to) / 2), panel.left + width / 2 + 6), panel.left + panel.width - width / 2 - 6);
  const left = shown - width / 2;
  context.fillStyle = theme.colours.paper;
  context.fillRect(left, top, width, height);
  context.beginPath();
  context.moveTo(left, top);
  context.lineTo(left + width, top);
  context.lineTo(left + width, top + height);
  context.lineTo(left, top + height);
  context.closePath();
  context.strokeStyle = theme.colours.secondary;
  context.lineWidth = theme.weight;
  context.stroke();
  context.beginPath();
  let drawn = false;
  for (const [i, at] of curve.entries()) {
    if (at === undefined) continue;
    const x = left + 4 + ((width - 8) * i) / POINTS;
    const y = top + height - 4 - ((height - 8 - HEAD * theme.scale) * (at - least)) / (most - least);
    if (drawn) context.lineTo(x, y);
    else context.moveTo(x, y);
    drawn = true;
  }
  context.strokeStyle = theme.colours[panel.series[0].role];
  context.lineWidth = 1.5 * theme.weight;
  context.stroke();
  setChartFont(context, theme);
  context.textAlign = "right";
  context.textBaseline = "top";
  context.fillStyle = theme.colours.secondary;
  const span = most - least;
  const angle = panel.kind === "angle" && panel.order === 0;
  const said = angle ? words.numbers.angle(span, 3) : panel.order > 0 ? words.numbers.short(span) : words.length(words.numbers.short(span));
  context.fillText(`↕ ${said}`, left + width - 4, top + 3);
  return { left, top, right: left + width, bottom: top + height };
}

/** Values in the rows of the table, in order. */
const ROWS = Object.freeze(/** @type {const} */ (["stroke", "arc", "residual"]));
/** Names of the quantities, as lessons ask for them, that the stroke reveals. */
const SWING = /:swing$/;
/** Decimals of an input. */
const DECIMALS = 3;

/** Roles of the colours of the phases. */
const ROLES = Object.freeze({ rise: "crank", dwell: "coupler", return: "rocker" });

export class CourseView {
  #design;
  #row;
  /** The foldable section, initially open if the document asks for a dwell. */
  #fold = make("details", { id: "course", class: "fold within" });
  /** Key of the mechanism for which the page last folded or unfolded the section. */
  #folded = "";
  #name = make("caption");
  #rows = make("tbody");
  #readouts;
  #bars = make("div", { id: "cyclogram", class: "cyclogram", role: "img" });
  #phases = make("p", { class: "note phases" });
  #shown = new Seen();

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    const { store, drafts, shown } = page;
    this.#readouts = shown;
    this.#design = new DesignView(page);
    this.#row = new NumberRow({ field: "band", symbol: "δ", role: "coupler" }, drafts, (band) =>
      store.update((state) => withDocument(state, { band })),
    );
    this.#fold.append(
      make("summary", { "data-t": "dwell.heading" }),
      this.#row.element,
      make("table", { class: "course" }, [this.#name, this.#rows]),
      make("div", { id: "cyclogram-figure" }, [this.#bars, this.#phases]),
      this.#design.element,
    );
    fold("structure", [make("section", { "data-of": "linkage" }, [this.#fold])]);
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    this.#design.render(snapshot);
    const { state, summary, coordinate, words, problems, stale, withheld } = snapshot;
    const { profile, plotted } = summary;
    // A refused band stays in the field as typed. Otherwise 0.01 could not be typed, because its first 0 is refused.
    const band = state.document.band ?? profile?.width;
    const wrong = problems.some(({ field, path }) => (field ?? path) === "band");
    if (this.#shown.same(profile, words, wrong, band, stale, withheld)) return;
    this.#fold.hidden = !profile;
    if (!profile) {
      this.#readouts.put("course", []);
      return;
    }
    const folded = `${state.document.origin} ${state.document.title} ${state.document.band !== undefined}`;
    if (folded !== this.#folded) this.#fold.open = Boolean(state.document.band);
    this.#folded = folded;
    this.#row.show(band ?? profile.width, words, wrong);
    if (stale) return;
    write(this.#name, called(plotted[0].replace(/\.angle$/, ""), words));
    const rows = courseRows(profile, snapshot);
    render(rows.map(({ title, cells }) => html`<tr><th scope="row">${title}</th>${cells.map(readoutCell)}</tr>`), this.#rows);
    this.#readouts.put("course", rows);
    this.#draw(profile, summary, (input) => coordinate.short(input, words, DECIMALS), words);
  }

  /**
   * @param {Profile} profile
   * @param {Snapshot["summary"]} summary
   * @param {(input: number) => string} turned
   * @param {Words} words
   */
  #draw({ phases }, { cycle: { start, end }, plotted }, turned, words) {
    const period = end - start;
    /** @type {string[]} */
    const told = [];
    /** @type {import("lit-html").TemplateResult[]} */
    const bars = [];
    for (const { kind, arc: [from, to] } of phases) {
      told.push(words.text("dwell.bar", { phase: words.text(`dwell.${kind}`), from: turned(from % period), to: turned(to % period) }));
      // A phase that crosses the end of the turn continues at the start of the turn.
      for (const shift of [-period, 0, period]) {
        const [left, right] = [Math.max(from + shift, start), Math.min(to + shift, end)].map((input) => (100 * (input - start)) / period);
        if (right <= left) continue;
        bars.push(html`<i class=${kind} .style=${`left: ${left.toFixed(3)}%; width: ${(right - left).toFixed(3)}%; --accent: var(--role-${ROLES[kind]})`}></i>`);
      }
    }
    render(bars, this.#bars);
    this.#bars.ariaLabel = [words.text("dwell.chart", { name: called(plotted[0].replace(/\.angle$/, ""), words) }), ...told].join("; ");
    this.#bars.title = told.join("\n");
    render(told.map((one, i) => html`<span><i class="swatch" aria-hidden="true" .style=${`background: var(--role-${ROLES[phases[i].kind]})`}></i>${one}</span>`), this.#phases);
  }
}

/**
 * @param {Profile} profile
 * @param {Snapshot} snapshot
 * @returns {readonly import("assur/controls/shown.js").Row[]}
 */
function courseRows({ stroke, dwell }, snapshot) {
  const { summary: { plotted }, coordinate, words } = snapshot;
  const angle = plotted[0].endsWith(".angle");
  const said = (/** @type {number} */ value) => (angle ? words.numbers.angle(value, 4) : words.length(words.numbers.short(value)));
  const none = words.text("dwell.none");
  // The travel of an angle is a swing, that of a length a stroke.
  const told = {
    stroke: [words.text(angle ? "dwell.swing" : "dwell.stroke"), stroke === null ? none : said(stroke)],
    arc: [words.text("dwell.arc"), dwell ? coordinate.short(dwell.arc[1] - dwell.arc[0], words, DECIMALS) : none],
    residual: [words.text("dwell.residual"), dwell ? said(dwell.band[1] - dwell.band[0]) : none],
  };
  return ROWS.map((name) => {
    const [title, text] = told[name];
    return { title, cells: [cellOf(`course-${name}`, { title, text }, snapshot, name === "stroke" ? SWING : undefined)] };
  });
}
