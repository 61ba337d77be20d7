import type { Summaries, SweepTable } from "./types/web.js";

export * from "./engine/assur_web.js";
export type * from "./types/file.js";
export type * from "./types/web.js";

/** A problem of the input. If the engine rejects its input, it throws an array of problems. */
export type Problem = { readonly code: string; readonly field?: string; readonly [parameter: string]: unknown };

/** A mechanism, from the catalogue or from a document. */
export class Mechanism<K extends keyof Summaries = keyof Summaries> {
  /**
   * @param document the field `document` of a file saved by the page
   * @throws readonly Problem[]
   */
  constructor(kind: K, document: object, view?: object);
  /**
   * @param id name in the catalogue, such as `jansen`
   * @throws RangeError if the catalogue has no mechanism of this name
   */
  static named(id: string): Mechanism;
  /** Summary of the whole motion: structure, range of the input, dead points, swings. */
  readonly summary: Summaries[K];
  /**
   * @param input input of the driver: radians, a length or seconds
   * @throws readonly Problem[] if there is no pose at this input
   */
  pose(input: number): {
    /** x, y and angle of each rigid body of the drawing. */
    bodies: [number, number, number][];
    /** Values by name; `′` and `″` mark derivatives with respect to the input. Null if derivatives are unbounded. */
    readouts: Record<string, number> | null;
  };
  /** The motion as a table with this number of steps per turn of the crank. */
  sweep(steps: number): SweepTable;
  /** Frees the memory that the engine uses for the mechanism. */
  free(): void;
}
