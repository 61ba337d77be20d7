import type { DocumentOf, Problem, View } from "./types/file.js";
import type { Kind, OutputSummary, ProfileSummary, Summaries, SweepTable, TransmissionSummary } from "./types/web.js";

export * from "./engine/assur_web.js";
export type * from "./types/edit.js";
export type * from "./types/file.js";
export type * from "./types/web.js";

/** Error of the engine if it refuses a request. */
export interface EngineError extends Error {
  readonly problems: readonly Problem[];
}

/** A mechanism, from the catalogue or from a document. */
export class Mechanism<K extends Kind = Kind> {
  /**
   * @param document the field `document` of a file saved by the page
   * @throws EngineError
   */
  constructor(kind: K, document: DocumentOf<K>["document"], view?: Partial<View>);
  /**
   * @param id name in the catalogue, such as `jansen`
   * @throws RangeError if the catalogue has no mechanism of this name
   */
  static named<K extends Kind = Kind>(id: string): Mechanism<K>;
  /** Structure of the mechanism, and its motion as a whole: range of the input, dead points, change points. */
  readonly summary: Summaries[K];
  /**
   * @param input input of the driver: radians, a length or seconds
   * @throws EngineError if there is no pose at this input
   */
  pose(input: number): {
    /** x, y and angle of each rigid body of the drawing. */
    bodies: [number, number, number][];
    /** Values by name, `′` and `″` are their derivatives by the input; null where derivatives are unbounded. */
    readouts: Record<string, number> | null;
  };
  /**
   * Swings or strokes, limit positions and time ratios of a linkage's outputs.
   * @throws EngineError if the mechanism is not a moving linkage; so do the two methods below
   */
  outputs(): OutputSummary[];
  /** The worst transmission or pressure angle of each dyad. */
  transmissions(): TransmissionSummary[];
  /** Stroke, longest dwell and phases of the first plotted quantity; null if it is not an output. */
  profile(): ProfileSummary | null;
  /** The motion as a table with the given number of steps per turn. */
  sweep(steps: number): SweepTable;
  /** Frees the memory of the engine. */
  free(): void;
}
