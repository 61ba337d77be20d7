// What was refused, and why: codes with parameters, which become sentences where they are shown.

/** @typedef {Readonly<{ code: string, field?: string, [parameter: string]: string | number | undefined }>} Problem */

/** The engine did not do what was asked, and says why. */
export class Refusal extends Error {
  /** @param {readonly Problem[]} problems */
  constructor(problems) {
    super(problems.map((problem) => problem.code).join(", "));
    this.problems = problems;
  }
}

/**
 * What the engine refuses comes back as problems; anything else is a fault and goes on up.
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
