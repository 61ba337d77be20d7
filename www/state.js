// The shape of the state and the few ways to change it. Plain JSON: it can be saved, sent and undone.

/**
 * @typedef {"external" | "internal" | "as_printed"} Mesh
 * @typedef {"l1" | "l2" | "l3" | "l4" | "z4" | "z5" | "module" | "centre_line_deg"} NumberField
 *
 * @typedef {Readonly<{
 *   l1: number, l2: number, l3: number, l4: number, z4: number, z5: number,
 *   mesh: Mesh, module: number, centre_line_deg: number, assembly: 1 | 2,
 * }>} MixerDocument
 *
 * @typedef {Readonly<{
 *   phi_deg: number, playing: boolean, direction: 1 | -1, speed: number, lang: string,
 *   traces: boolean, centres: boolean, vectors: boolean, loop_vectors: boolean, transmission: boolean,
 *   plot: string, axes: "analogues" | "physical", omega: number, omega_unit: "rad_per_s" | "per_min", epsilon: number,
 *   true_time: boolean, differenced: boolean,
 * }>} View
 *
 * @typedef {Readonly<{ format: 1, lesson: "mixer", document: MixerDocument, view: View }>} State
 */

/** What can be laid over the drawing. */
export const OVERLAYS = Object.freeze(/** @type {const} */ (["traces", "centres", "vectors", "loop_vectors", "transmission"]));

/** What is shown or not: over the drawing, and over the plots. */
export const SWITCHES = Object.freeze(/** @type {const} */ ([...OVERLAYS, "differenced"]));

/** What of the view the engine draws by, or may refuse. */
export const DRAWN = Object.freeze(
  /** @type {const} */ ([...SWITCHES, "plot", "axes", "omega", "epsilon", "true_time"]),
);

/**
 * @param {MixerDocument} document
 * @param {Partial<View>} view
 * @returns {State}
 */
export function initialState(document, view) {
  return Object.freeze({
    format: 1,
    lesson: "mixer",
    document: Object.freeze({ ...document }),
    view: Object.freeze({
      phi_deg: 62,
      playing: true,
      direction: 1,
      speed: 1,
      traces: true,
      centres: false,
      vectors: false,
      loop_vectors: false,
      transmission: false,
      plot: "angles",
      axes: "analogues",
      omega: 1,
      omega_unit: "rad_per_s",
      epsilon: 0,
      true_time: false,
      differenced: false,
      lang: "en",
      ...view,
    }),
  });
}

/**
 * @param {State} state
 * @param {Partial<MixerDocument>} change
 * @returns {State} the same state where nothing changes
 */
export function withDocument(state, change) {
  const document = merged(state.document, change);
  return document === state.document ? state : Object.freeze({ ...state, document });
}

/**
 * @param {State} state
 * @param {Partial<View>} change
 * @returns {State} the same state where nothing changes
 */
export function withView(state, change) {
  const view = merged(state.view, change);
  return view === state.view ? state : Object.freeze({ ...state, view });
}

/**
 * @template {object} T
 * @param {T} value
 * @param {Partial<T>} change
 * @returns {T}
 */
function merged(value, change) {
  return contains(value, change) ? value : Object.freeze({ ...value, ...change });
}

/**
 * @template {object} T
 * @param {T} value
 * @param {Partial<T>} part
 * @returns {boolean} whether every entry of the part is in the value already
 */
export function contains(value, part) {
  const keys = /** @type {(keyof T)[]} */ (Object.keys(part));
  return keys.every((key) => Object.is(value[key], part[key]));
}
