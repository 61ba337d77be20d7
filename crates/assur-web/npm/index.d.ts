import type { Summaries, SweepTable } from "./types/web.js";

export * from "./engine/assur_web.js";
export type * from "./types/file.js";
export type * from "./types/web.js";

/** What the engine refuses is thrown as a list of these. */
export type Problem = { readonly code: string; readonly field?: string; readonly [parameter: string]: unknown };

/** A mechanism of the catalogue, or of a document of yours. */
export class Mechanism<K extends keyof Summaries = keyof Summaries> {
  /**
   * @param document as the page saves it
   * @throws readonly Problem[]
   */
  constructor(kind: K, document: object, view?: object);
  /**
   * @param id as in the address of the page: `jansen`
   * @throws RangeError where there is none of that name
   */
  static named(id: string): Mechanism;
  /** What holds of the whole motion: structure, where the input goes, dead points, swings. */
  readonly summary: Summaries[K];
  /**
   * @param input of the driver: radians, a length or seconds
   * @throws readonly Problem[] where it cannot be assembled
   */
  pose(input: number): {
    /** x, y and angle of each rigid body of the drawing. */
    bodies: [number, number, number][];
    /** Values by name, `′` and `″` are their derivatives by the input; null where derivatives are unbounded. */
    readouts: Record<string, number> | null;
  };
  /** The motion as a table of so many steps to a turn. */
  sweep(steps: number): SweepTable;
  /** Gives the memory of the engine back. */
  free(): void;
}
