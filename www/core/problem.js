// Refusals with their reasons. A reason is a code with parameters, which becomes a sentence where it is shown.

/** @typedef {import("assur/types/file.js").Problem} Problem */

/** Refusal of a request, with its reasons in `problems`, as in the errors of the engine. */
export class Refusal extends Error {
  /** @param {readonly Problem[]} problems */
  constructor(problems) {
    super(problems.map((problem) => problem.code).join(", "));
    this.problems = problems;
  }
}

/**
 * @param {unknown} thrown
 * @returns {readonly Problem[] | null} reasons of a refusal; null for any other exception
 */
export function problemsOf(thrown) {
  return thrown instanceof Error && "problems" in thrown ? /** @type {readonly Problem[]} */ (thrown.problems) : null;
}

/**
 * Returns the result of a call or, if the call is refused, the problems. Any other exception is a fault, and is thrown
 * again.
 * @template T
 * @param {() => T} work
 * @returns {{ value: T, problems: readonly Problem[] } | { value: null, problems: readonly Problem[] }}
 */
export function attempt(work) {
  try {
    return { value: work(), problems: [] };
  } catch (thrown) {
    const problems = problemsOf(thrown);
    if (!problems) throw thrown;
    return { value: null, problems };
  }
}
