// What a screen reader is told of drawing and plots: the state at rest, in sentences.
import { sentence } from "assur/controls/problems.js";
import { degrees, radians } from "assur/core/angles.js";
import { byId, write } from "assur/core/dom.js";
import { subscript } from "assur/core/symbols.js";
import { powerOf, unitOf, written } from "assur/plots/units.js";
import { wheelLink } from "assur/state/state.js";

/**
 * @typedef {import("assur/engine.js").Mark} Mark
 * @typedef {import("assur/engine.js").Panel} Panel
 * @typedef {import("assur/engine.js").MotionSummary} MotionSummary
 * @typedef {import("assur/engine.js").MixerSummary} MixerSummary
 * @typedef {import("assur/engine.js").Summary} Summary
 * @typedef {import("assur/state/model.js").Snapshot} Snapshot
 * @typedef {import("assur/core/words.js").Words} Words
 */

/** So long nothing changes before it is told, in milliseconds: nobody listens to every value of a drag. */
const PAUSE = 500;

/** So near a special position the driver is said to be there, in radians. */
const NEAR = radians(0.5);

export class Description {
  #drawing = byId("mechanism-description", HTMLElement);
  #plots = byId("charts-description", HTMLElement);
  #now = byId("announcement", HTMLElement);
  #chart;
  /** @type {readonly unknown[]} what the last sentences are made of */
  #shown = [];
  /** @type {readonly unknown[]} angle and mechanism that were told last */
  #told = [];
  #asked;
  #timer = 0;

  /**
   * @param {{ readonly panels: readonly Panel[] }} chart
   * @param {boolean} asked whether the first rest is a reader's doing, of which it hears
   */
  constructor(chart, asked) {
    this.#chart = chart;
    this.#asked = asked;
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    const { state, words, revision, problems, phiDeg } = snapshot;
    const { playing } = state.view;
    const shown = [words, revision, this.#chart.panels, playing || phiDeg, ...problems.map(({ code }) => code)];
    if (shown.length === this.#shown.length && shown.every((part, i) => part === this.#shown[i])) return;
    this.#shown = shown;
    clearTimeout(this.#timer);
    if (playing) write(this.#drawing, words.text("told.moving"));
    this.#timer = setTimeout(() => this.#tell(snapshot), PAUSE);
  }

  /** @param {Snapshot} snapshot */
  #tell(snapshot) {
    const { state, words, revision, problems, phiDeg, summary } = snapshot;
    write(this.#plots, plots(summary, this.#chart.panels, words));
    if (state.view.playing) return;
    // Problems are told as they arise, by an element of their own.
    const failed = problems.map((problem) => sentence(problem, words, state.document)).join(" ");
    const here = positions(summary, radians(phiDeg), words);
    write(this.#drawing, [failed || drawing(snapshot), ...here].join(" "));
    const told = [phiDeg, revision];
    if (this.#asked && !failed && told.some((part, i) => part !== this.#told[i])) {
      write(this.#now, [pose(snapshot), ...here].join(" "));
    }
    this.#told = told;
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

/** @param {Snapshot} snapshot */
function pose(snapshot) {
  const { summary, words } = snapshot;
  return "ratios" in summary ? words.text("told.now", angles(snapshot, summary)) : linkage(snapshot, summary, "told.linkage_now");
}

/**
 * @param {Snapshot} snapshot
 * @param {MixerSummary} summary
 * @returns {Record<string, string>} the angles of the links
 */
function angles({ readouts, phiDeg, words }, summary) {
  const text = (/** @type {string} */ name) => (readouts ? angleText(readouts[name], words) : "");
  const wheels = summary.ratios.map((_, index) => {
    const link = wheelLink(index);
    return `${linkName(link, summary.numbers, words)} ${text(`${link}.angle`)}`;
  });
  return {
    crank: angleText(radians(phiDeg), words),
    coupler: text("coupler.angle"),
    rocker: text("rocker.angle"),
    wheels: wheels.join(", "),
    transmission: text("C.transmission"),
  };
}

/** @param {Snapshot} snapshot */
function drawing(snapshot) {
  const { summary, state, words } = snapshot;
  if (!("ratios" in summary)) return linkage(snapshot, summary, "told.linkage");
  return words.text("told.drawing", {
    ...angles(snapshot, summary),
    type: words.text(`grashof.${summary.four_bars[0].grashof}`),
    assembly: words.numbers.exact(state.document.assembly ?? 1),
  });
}

/**
 * @param {Snapshot} snapshot
 * @param {MotionSummary} summary
 * @param {string} key
 */
function linkage({ readouts, phiDeg, words }, { formula, plotted, numbers }, key) {
  const value = (/** @type {string} */ name) => {
    if (!readouts) return "—";
    return name.endsWith(".angle") ? angleText(readouts[name], words) : words.numbers.fixed(readouts[name], 3);
  };
  const values = plotted.map((name) => `${quantityName({ name, number: numbers[name.replace(/\.angle$/, "")] }, words)} ${value(name)}`).join(", ");
  return words.text(key, { formula, input: angleText(radians(phiDeg), words), values });
}

/**
 * The special positions that the driver is at.
 * @param {Summary} summary
 * @param {number} crank
 * @param {Words} words
 * @returns {string[]}
 */
function positions(summary, crank, words) {
  const limits = summary.outputs[0]?.limits ?? [];
  const [limit, dead] = [limits, summary.dead_points].map((places) => places.map(({ input }) => input));
  /** @type {[string, number[]][]} */
  const kinds = [["limit", limit], ["dead", dead], ["change", summary.change_points]];
  return kinds.flatMap(([kind, places]) => {
    const phi = places.find((place) => Math.abs(Math.sin((place - crank) / 2)) < NEAR / 2);
    return phi === undefined ? [] : [words.text(`told.${kind}`, { angle: angleText(phi, words) })];
  });
}

/**
 * @param {Summary} summary
 * @param {readonly Panel[]} panels
 * @param {Words} words
 */
function plots({ cycle }, panels, words) {
  const axis = words.text("told.axis", { from: angleText(cycle.start, words), to: angleText(cycle.end, words) });
  const told = panels.map((panel) => {
    const unit = words.text(unitOf(panel), { power: powerOf(panel) });
    const curves = panel.series.map((one) => {
      const marks = panel.marks.filter((mark) => mark.role === one.role);
      return [quantityName(one, words), ...peaks(panel, marks, words)].join(", ");
    });
    return `${unit}: ${curves.join("; ")}.`;
  });
  return [axis, ...told].join(" ");
}

/**
 * @param {Panel} panel
 * @param {readonly Mark[]} marks of one curve
 * @param {Words} words
 * @returns {string[]} its least and its greatest value
 */
function peaks(panel, marks, words) {
  return /** @type {const} */ (["min", "max"]).flatMap((kind) => {
    const sense = kind === "max" ? -1 : 1;
    const [peak] = marks.filter((mark) => mark.kind === kind).sort((a, b) => sense * (a.value - b.value));
    if (!peak) return [];
    const value = written(panel, peak.value, words.numbers);
    return [words.text(`told.${kind}`, { value, angle: angleText(peak.phi, words) })];
  });
}

/**
 * @param {{ name: string, number?: string | null }} quantity by its name, as `rocker.angle`, `C2.x`
 * @param {Words} words
 */
function quantityName({ name, number }, words) {
  const dot = name.lastIndexOf(".");
  const [of, what] = [name.slice(0, dot), name.slice(dot + 1)];
  return what === "angle" ? linkName(of, number ? { [of]: number } : {}, words) : `${subscript(of)} ${what}`;
}

/** The number of the rocker, on whose shaft wheel 4 is; greater ones are wheels'. */
const ROCKER = 3;

/**
 * @param {string} link
 * @param {Readonly<Record<string, string>>} numbers of the links that go by one
 * @param {Words} words
 */
function linkName(link, numbers, words) {
  const number = Number(numbers[link] ?? 0);
  if (number < ROCKER) return link;
  return number === ROCKER ? words.text("readouts.rocker") : words.text("name.wheels.z", { n: numbers[link] });
}
