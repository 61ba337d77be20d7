// The moving assembly of a document at its drawn input. Finding it takes time, so it is computed on first access.
import { attempt } from "assur/core/problem.js";

/**
 * @typedef {{ number: number, count: number, complete: boolean } | null} Assembled the moving assembly at the drawn
 * input; null if unknown. `number`: its number, from 1. `count`: number of assemblies known there. `complete`: whether
 * these are all
 * @typedef {Pick<import("assur/pkg/assur_web.js").Simulator, "assemblies">} Simulator
 */

/** @type {WeakMap<object, object>} for each simulator, the summary of the document that was set last */
const last = new WeakMap();

/**
 * @template {object} S
 * @param {S} summary of the document just set
 * @param {Simulator} simulator with the document
 * @returns {S} the summary; that of a linkage has a field `assembled`, which is null if another document has been set since
 */
export function withAssembled(summary, simulator) {
  last.set(simulator, summary);
  if (!("groups" in summary && "home" in summary)) return summary;
  const home = Number(summary.home);
  /** @type {Assembled | undefined} */
  let found;
  return Object.defineProperty(summary, "assembled", { get: () => {
    if (found === undefined && last.get(simulator) === summary) {
      const { value: here, problems } = attempt(() => simulator.assemblies(home));
      if (problems.some(({ code }) => code === "not_arrived")) return null;
      found = here ? { number: (here.shown ?? 0) + 1, count: here.all.length, complete: here.whole } : null;
    }
    return found ?? null;
  } });
}
