// Parts of a linkage's summary that take time to compute: ranges of the outputs, transmission angles, dwell, equations, the number
// of the moving assembly, and the forces at the drawn input. Each is computed when it is first read.
import { attempt } from "assur/core/problem.js";

/**
 * @typedef {{ number: number, count: number, complete: boolean } | null} Assembled the moving assembly at the drawn
 * input; null if unknown. `number`: its number, from 1. `count`: number of assemblies known there. `complete`: whether
 * these are all
 * @typedef {Pick<import("assur/pkg/assur_web.js").Simulator, "assemblies" | "constraints" | "cycle" | "forces" | "forcePlan" | "outputs" | "profile" | "transmissions">} Simulator
 * @typedef {{
 *   readonly outputs: readonly import("assur/types/web.js").OutputSummary[],
 *   readonly transmissions: readonly import("assur/types/web.js").TransmissionSummary[],
 *   readonly profile: import("assur/types/web.js").ProfileSummary | null,
 *   readonly equations: readonly import("assur/types/web.js").EquationSummary[],
 *   readonly assembled: Assembled,
 *   readonly forces: import("assur/types/web.js").ForcesHere | null,
 *   readonly steady: import("assur/types/web.js").CycleHere | null,
 *   readonly plan: readonly import("assur/types/web.js").ForceStepHere[],
 * }} Details
 */

/**
 * @template S
 * @typedef {S extends import("assur/types/web.js").MotionSummary ? S & Details : S} Detailed
 */

/** @typedef {{ [K in import("assur/types/web.js").Kind]: Detailed<import("assur/types/web.js").Summaries[K]> }} Summaries */
/** @typedef {Summaries[import("assur/types/web.js").Kind]} Summary */
/** @typedef {Summaries["linkage" | "mixer"]} MotionSummary */

/** Coefficient of non-uniformity for which the flywheels of a steady cycle are found. */
const NON_UNIFORMITY = 0.05;

/** @type {{ [K in keyof Details]: (simulator: Simulator, home: number) => Details[K] | undefined }} undefined if the answer may come later */
const QUESTIONS = Object.freeze({
  outputs: (simulator) => simulator.outputs(),
  transmissions: (simulator) => simulator.transmissions(),
  profile: (simulator) => simulator.profile(),
  equations: (simulator) => simulator.constraints(),
  forces: (simulator, home) => attempt(() => simulator.forces(home)).value,
  plan: (simulator, home) => attempt(() => simulator.forcePlan(home, 1)).value?.steps ?? [],
  steady: (simulator) => attempt(() => simulator.cycle(0, NON_UNIFORMITY)).value,
  assembled: (simulator, home) => {
    const { value: here, problems } = attempt(() => simulator.assemblies(home));
    if (problems.some(({ code }) => code === "not_arrived")) return undefined;
    return here && here.shown !== null ? { number: here.shown + 1, count: here.all.length, complete: here.whole } : null;
  },
});

/**
 * @template {object} S
 * @param {S} summary
 * @param {<T>(question: (simulator: Simulator) => T) => T} ask puts a question to a simulator with the document of the summary
 * @returns {Detailed<S>} the summary; that of a linkage now has its {@link Details}
 */
export function withDetails(summary, ask) {
  const detailed = /** @type {Detailed<S>} */ (summary);
  if (!("groups" in summary && "home" in summary)) return detailed;
  const home = Number(summary.home);
  for (const [name, question] of Object.entries(QUESTIONS)) {
    /** @type {unknown} */
    let found;
    const get = () => {
      if (found === undefined) found = ask((simulator) => question(simulator, home));
      return found ?? null;
    };
    Object.defineProperty(summary, name, { get });
  }
  return detailed;
}

/**
 * @param {Summary} summary
 * @returns {Details["outputs"]} outputs of a linkage; none for other mechanisms
 */
export function outputsOf(summary) {
  return "outputs" in summary ? summary.outputs : [];
}
