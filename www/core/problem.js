// Refusals with their reasons: codes with parameters, which become sentences where they are shown.

/** @typedef {Readonly<{ code: string, field?: string, [parameter: string]: string | number | undefined }>} Problem */

/** Refusal of a request by the engine, with its reasons. */
export class Refusal extends Error {
  /** @param {readonly Problem[]} problems */
  constructor(problems) {
    super(problems.map((problem) => problem.code).join(", "));
    this.problems = problems;
  }
}

/**
 * Does work and returns a refusal by the engine as problems; any other exception is a fault and is thrown on.
 * @template T
 * @param {() => T} work
 * @returns {{ value: T, problems: readonly Problem[] } | { value: null, problems: readonly Problem[] }}
 */
export function attempt(work) {
  try {
    return { value: work(), problems: [] };
  } catch (thrown) {
    if (thrown instanceof Refusal) return { value: null, problems: thrown.problems };
    throw thrown;
  }
}
