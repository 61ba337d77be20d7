// Refusals with their reasons. A reason is a code with parameters, which becomes a sentence where it is shown.

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
 * Does work, and returns the problems of a refusal by the engine. Any other exception is a fault, and is thrown again.
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
