// Structure of the state and the few ways to change it. The state is plain JSON: it can be saved, sent and undone.

/**
 * @template T
 * @typedef {import("assur/types/file.js").Frozen<T>} Frozen value that is never changed in place
 */

/**
 * @typedef {Frozen<import("assur/types/file.js").View>} Saved the view as it is saved
 * @typedef {Omit<Saved, "lesson" | "against"> & { readonly [K in "lesson" | "against"]: NonNullable<Saved[K]> | null }} View
 * @typedef {Frozen<import("assur/types/file.js").MixerDocument>} MixerDocument
 * @typedef {Frozen<import("assur/types/file.js").LinkageDocument>} LinkageDocument
 * @typedef {Frozen<import("assur/types/file.js").Document>} Document
 * @typedef {Document["kind"]} Kind of document
 * @typedef {{ [K in Kind]: Extract<Document, { kind: K }>["document"] }} Documents
 * @typedef {{ [K in Kind]: Partial<Documents[K]> }[Kind]} Change of a document
 * @typedef {Frozen<import("assur/types/file.js").LessonDocument>} Written a lesson that a lecturer has written
 */

/**
 * @typedef {Frozen<import("assur/types/file.js").PictureDocument>} Picture behind the drawing
 * @typedef {Readonly<{ lesson?: Written, compared?: Document, picture?: Picture }>} Extras optional parts of a state. `lesson`: a lecturer's lesson;
 * `compared`: mechanism A, with which the document's is compared; `picture`: a picture behind the drawing
 */

/**
 * @template {Kind} [K=Kind]
 * @typedef {K extends Kind ? Readonly<{ format: 2, kind: K, document: Documents[K], view: View } & Extras> : never} State
 */

/** Overlays of the drawing. */
export const OVERLAYS = Object.freeze(/** @type {const} */ (["traces", "centres", "vectors", "loop_vectors", "transmission", "groups", "numbers", "others", "instant_centres", "centrodes", "curvature", "forces"]));

/** Fields of the view that show or hide something in the drawing, in the plots or beside them. */
export const SWITCHES = Object.freeze(/** @type {const} */ ([...OVERLAYS, "all_assemblies", "polygons", "force_plan", "under_load", "differenced"]));

/** Fields of the view that affect the engine's drawing or that the engine may refuse. */
export const DRAWN = Object.freeze(
  /** @type {const} */ ([...SWITCHES, "about", "relative_to", "measures", "plot", "against", "axes", "omega", "epsilon", "true_time"]),
);

/** Fields of the view that name a part of the document, with values that suit any document. */
export const PARTS = Object.freeze({ plot: "angles", against: null, about: "", relative_to: "", measures: Object.freeze([]) });

/** Fields of the view that are undone with the document. Changes of other fields lose no work. */
export const UNDOABLE_VIEW = Object.freeze(/** @type {const} */ ([...OVERLAYS, "measures", "against"]));

/** Optional parts of a state besides its document and its view. */
export const EXTRAS = Object.freeze(/** @type {const} */ (["lesson", "compared", "picture"]));

/** Limit of the number of traced points of a mechanism. */
export const TRACERS = Object.freeze({ most: 6 });

/**
 * @param {Partial<View>} view
 * @returns {View} the view, with the usual value for each missing field
 */
export function usualView(view) {
  return Object.freeze({
    phi_deg: 62,
    s: 0,
    t: 0,
    playing: true,
    direction: 1,
    speed: 1,
    traces: true,
    centres: false,
    vectors: false,
    loop_vectors: false,
    transmission: false,
    groups: false,
    numbers: false,
    all_assemblies: false,
    others: false,
    polygons: false,
    forces: false,
    force_plan: false,
    under_load: false,
    instant_centres: false,
    centrodes: false,
    curvature: false,
    about: "",
    relative_to: "",
    measures: Object.freeze([]),
    plot: "angles",
    against: null,
    only: "all",
    axes: "analogues",
    omega: 1,
    omega_unit: "rad_per_s",
    epsilon: 0,
    true_time: false,
    drawing: false,
    differenced: false,
    lesson: null,
    projector: false,
    lang: "en",
    ...view,
  });
}

/**
 * @template {Kind} K
 * @param {K} kind
 * @param {Documents[K]} document
 * @param {Partial<View>} view
 * @param {Extras} [extras]
 * @returns {State}
 */
export function initialState(kind, document, view, extras) {
  return stateOf(kind, document, usualView(view), extras);
}

/**
 * @template {Kind} K
 * @param {K} kind
 * @param {Documents[K]} document
 * @param {View} view
 * @param {Extras} [extras]
 */
function stateOf(kind, document, view, extras = {}) {
  const there = EXTRAS.filter((name) => extras[name]).map((name) => [name, extras[name]]);
  return /** @type {State} */ (Object.freeze({ format: 2, kind, document, view, ...Object.fromEntries(there) }));
}

/**
 * @param {Extras} state
 * @returns {Extras} the optional parts of the state, undefined if missing
 */
export function extrasOf(state) {
  return Object.fromEntries(EXTRAS.map((name) => [name, state[name]]));
}

/**
 * @param {Pick<State, "kind" | "document" | "view">} state
 * @returns {State} the state without its optional parts, which the engine does not need
 */
export function withoutExtras({ kind, document, view }) {
  return stateOf(kind, document, view);
}

/**
 * @param {State} state
 * @param {Extras} change of the optional parts
 * @returns {State} the changed state; the same object if nothing changes
 */
export function withExtras(state, change) {
  const next = stateOf(state.kind, state.document, state.view, { ...state, ...change });
  return EXTRAS.every((name) => next[name] === state[name]) ? state : next;
}

/**
 * Replaces the mechanism of a state. The view and the optional parts of the state stay.
 * @template {Kind} K
 * @param {State} state
 * @param {K} kind
 * @param {Documents[K]} document
 * @returns {State}
 */
export function withMechanism(state, kind, document) {
  return stateOf(kind, document, state.view, state);
}

/**
 * @param {State} state
 * @param {Change} change of a document of the state's kind
 * @returns {State} the changed state; the same object if nothing changes
 */
export function withDocument(state, change) {
  const document = merged(state.document, change);
  return document === state.document ? state : /** @type {State} */ (Object.freeze({ ...state, document }));
}

/**
 * Changes a document of one kind; a state of another kind stays as it is.
 * @template {Kind} K
 * @param {State} state
 * @param {K} kind
 * @param {(document: Documents[K]) => Partial<Documents[K]>} change
 * @returns {State}
 */
export function edited(state, kind, change) {
  if (state.kind !== kind) return state;
  return withDocument(state, /** @type {Change} */ (change(/** @type {Documents[K]} */ (state.document))));
}

/**
 * @param {State} state
 * @param {Partial<View>} change
 * @returns {State} the changed state; the same object if nothing changes
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
  return keys.every((key) => same(value[key], part[key]));
}

/**
 * @param {unknown} one
 * @param {unknown} other
 * @returns {boolean} whether the values are equal; lists and objects are compared by content
 */
function same(one, other) {
  return Object.is(one, other) || (one instanceof Object && JSON.stringify(one) === JSON.stringify(other));
}
