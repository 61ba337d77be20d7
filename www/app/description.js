// Description of the drawing and the plots for screen readers. Poses are described only at rest.
import { sentence } from "assur/controls/problems.js";
import { degrees } from "assur/core/angles.js";
import { byId, write } from "assur/core/dom.js";
import { calledIn, numbered } from "assur/core/names.js";
import { Seen } from "assur/core/seen.js";
import { isLength } from "assur/core/symbols.js";
import { described } from "assur/plots/against.js";
import { differenceOf, whose } from "assur/plots/readouts.js";
import { axisTitle, axisValueText, levelText } from "assur/plots/units.js";
import { outputsOf } from "assur/state/details.js";
import { moves } from "assur/state/model.js";

/**
 * @typedef {import("assur/types/web.js").PanelLayout} Panel
 * @typedef {import("assur/types/web.js").ListedSummary} Listed
 * @typedef {import("assur/state/details.js").Summary} Summary
 * @typedef {import("assur/state/model.js").Snapshot} Snapshot
 * @typedef {import("assur/core/words.js").Words} Words
 * @typedef {{ readonly panels: readonly Panel[], readonly against: import("assur/types/web.js").AgainstLayout | null }} Charted
 */

/** Time without a change before the texts are written, in milliseconds. Poses passed in a drag are not described. */
const PAUSE = 500;

export class Description {
  #drawing = byId("mechanism-description", HTMLElement);
  #plots = byId("charts-description", HTMLElement);
  #now = byId("announcement", HTMLElement);
  #chart;
  #shown = new Seen();
  #told = new Seen();
  #asked;
  #timer = 0;

  /**
   * @param {Charted} chart
   * @param {boolean} asked whether the page opened in motion; if so, the first pose at rest is announced, too
   */
  constructor(chart, asked) {
    this.#chart = chart;
    this.#asked = asked;
  }

  /** @param {import("assur/state/model.js").AnySnapshot} snapshot */
  render(snapshot) {
    const { state, words, revision, problems, inputShown, withheld } = snapshot;
    const { playing } = state.view;
    if (this.#shown.same(words, revision, this.#chart.panels, this.#chart.against, playing || inputShown, withheld, ...problems.map(({ code }) => code))) return;
    clearTimeout(this.#timer);
    if (playing || !moves(snapshot)) this.#fallSilent(snapshot);
    if (moves(snapshot)) this.#timer = setTimeout(() => this.#tell(snapshot), PAUSE);
  }

  /**
   * Removes the description of a pose that is no longer shown. In motion, a text that says so replaces it.
   * @param {import("assur/state/model.js").AnySnapshot} snapshot
   */
  #fallSilent(snapshot) {
    const moving = moves(snapshot);
    write(this.#drawing, moving ? snapshot.words.text("told.moving") : "");
    if (!moving) write(this.#plots, "");
    write(this.#now, "");
  }

  /** @param {Snapshot} snapshot */
  #tell(snapshot) {
    const { state, words, revision, problems, inputShown } = snapshot;
    write(this.#plots, plots(snapshot, this.#chart));
    if (state.view.playing) return;
    // Problems are announced by an element of their own as they arise; here they replace the description.
    const failed = problems.map((problem) => sentence(problem, words, state.document)).join(" ");
    const here = positions(snapshot);
    write(this.#drawing, [failed || drawing(snapshot), ...here].join(" "));
    const moved = !this.#told.same(inputShown, revision, words.lang);
    if (this.#asked && !failed && moved) write(this.#now, [pose(snapshot), ...here].join(" "));
    this.#asked = true;
  }
}

/**
 * @param {number} angle
 * @param {Words} words
 */
function angleText(angle, words) {
  return `${words.numbers.fixed(degrees(angle), 1)}°`;
}

/**
 * @param {Listed} listed
 * @param {number | undefined} value
 * @param {Words} words
 */
function valueText({ what }, value, words) {
  if (value === undefined) return "—";
  return isLength(what) ? words.numbers.fixed(value, 3) : angleText(value, words);
}

/**
 * Text on the pose: the values of the input and of the listed quantities, and the comparison with mechanism A if there
 * is one.
 * @param {Snapshot} snapshot
 */
function pose(snapshot) {
  const { summary, coordinate, input, readouts, words, withheld } = snapshot;
  const values = summary.listed.map((one) => {
    const said = withheld.has(one.name) ? "?" : valueText(one, readouts?.value(one.name), words);
    return `${listedName(one, words)} ${said}`;
  });
  const now = words.text(`told.now.${coordinate.moves}`, { input: coordinate.text(input, words, 1), values: values.join(", ") });
  return [now, ...comparison(snapshot)].join(" ");
}

/**
 * A sentence with the output of the compared mechanism A, and the difference B − A; B is the shown mechanism.
 * @param {Snapshot} snapshot
 */
function comparison({ summary, readouts, compared, compares, words, withheld }) {
  if (!compares) return [];
  if (!compared) return [words.text("compare.apart")];
  const { listed } = summary;
  const output = listed.find(({ name }) => name === outputsOf(summary)[0]?.name) ?? listed[0];
  if (!output) return [];
  const value = compared.readouts?.value(output.name);
  const difference = differenceOf(output.what, 0, value, readouts?.value(output.name));
  const [of, by] = [value, difference].map((number) => valueText(output, number, words));
  // The difference B − A would reveal a withheld value of B.
  const told = withheld.has(output.name) ? "?" : by;
  return [words.text("told.compared", { name: listedName(output, words), value: of, difference: told })];
}

/** @param {Snapshot} snapshot */
function drawing(snapshot) {
  const { summary, coordinate, words } = snapshot;
  // Only linkages have a structure to describe.
  if (!("formula" in summary)) return pose(snapshot);
  const assembly = numbered(summary, coordinate, words);
  if (!assembly) return pose(snapshot);
  const { formula, four_bars: bars } = summary;
  const types = bars.map(({ grashof }) => words.text(`grashof.${grashof}`));
  const kind = words.text("told.kind", { type: types.join("; "), assembly });
  const structure = words.text("told.structure", { formula: calledIn(formula, words), assembly });
  return [pose(snapshot), types.length > 0 ? kind : structure].join(" ");
}

/**
 * Texts on the limit position, dead point and change point at the current input, if there are any.
 * @param {Snapshot} snapshot
 */
function positions({ summary, coordinate, input, words }) {
  const limits = outputsOf(summary)[0]?.limits ?? [];
  const [limit, dead] = [limits, summary.dead_points].map((positions) => positions.map((one) => one.input));
  /** @type {[string, number[]][]} */
  const kinds = [["limit", limit], ["dead", dead], ["change", summary.change_points]];
  return kinds.flatMap(([kind, inputs]) => {
    const here = inputs.find((one) => coordinate.near(one, input));
    return here === undefined ? [] : [words.text(`told.${kind}`, { angle: coordinate.text(here, words, 1) })];
  });
}

/**
 * @param {Snapshot} snapshot
 * @param {Charted} chart
 */
function plots(snapshot, { panels, against }) {
  if (against) return described(against, snapshot);
  const { summary: { listed, unsearched }, coordinate, inputShown, words } = snapshot;
  const { x0, x1 } = panels[0] ?? {};
  const ends = x0 === undefined ? Object.values(coordinate.axis(inputShown)) : [x0, x1].map((input) => coordinate.inputShown(input));
  const [from, to] = ends.map((end) => coordinate.written(end, words, 1));
  const axis = words.text(`told.axis.${coordinate.moves}`, { from, to });
  const told = panels.map((panel) => {
    const curves = panel.series.map((one) => {
      const marks = panel.marks.filter((mark) => mark.role === one.role);
      const row = listed.find(({ name }) => name === one.name);
      const level = one.level === null ? [] : [words.text("plots.throughout", { value: levelText(panel, one.level, words.numbers) })];
      return [row ? listedName(row, words) : one.name, ...level, ...peaks(panel, marks, coordinate, words)].join(", ");
    });
    return `${axisTitle(panel, coordinate, words)}: ${curves.join("; ")}.`;
  });
  const [turns, most] = [unsearched?.turns, unsearched?.most].map((count) => words.numbers.exact(count ?? 0));
  return [axis, ...told, ...(unsearched ? [words.text("plots.unsearched", { turns, most })] : [])].join(" ");
}

/**
 * @param {Panel} panel
 * @param {readonly import("assur/types/web.js").MarkLayout[]} marks of one curve
 * @param {Snapshot["coordinate"]} coordinate
 * @param {Words} words
 * @returns {string[]} texts on the least and the greatest value of the curve
 */
function peaks(panel, marks, coordinate, words) {
  return /** @type {const} */ (["min", "max"]).flatMap((kind) => {
    const sense = kind === "max" ? -1 : 1;
    const [peak] = marks.filter((mark) => mark.kind === kind).sort((a, b) => sense * (a.value - b.value));
    if (!peak) return [];
    const value = axisValueText(panel, peak.value, words.numbers);
    return [words.text(`told.${kind}`, { value, angle: coordinate.text(peak.phi, words, 1) })];
  });
}

/**
 * @param {Listed} listed
 * @param {Words} words
 * @returns {string} name of the quantity's point or link; for a coordinate, x or y follows the name
 */
function listedName(listed, words) {
  const { what } = listed;
  return what === "x" || what === "y" ? `${whose(listed, words)} ${what}` : whose(listed, words);
}
