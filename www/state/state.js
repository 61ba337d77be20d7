// The shape of the state and the few ways to change it. Plain JSON: it can be saved, sent and undone.

/**
 * @typedef {"external" | "internal" | "as_printed"} Mesh
 * @typedef {"l1" | "l2" | "l3" | "l4" | "z4" | "module"} NumberField
 * @typedef {Readonly<{ z: number, centre_line_deg: number }>} Wheel
 * @typedef {Readonly<{ link: string, x: number, y: number }>} Tracer
 *
 * @typedef {Readonly<{
 *   l1: number, l2: number, l3: number, l4: number, z4: number, wheels: readonly Wheel[],
 *   mesh: Mesh, module: number, assembly: 1 | 2, tracers: readonly Tracer[],
 * }>} MixerDocument
 *
 * @typedef {Readonly<{
 *   phi_deg: number, s: number, playing: boolean, direction: 1 | -1, speed: number, lang: string,
 *   traces: boolean, centres: boolean, vectors: boolean, loop_vectors: boolean, transmission: boolean, groups: boolean,
 *   plot: string, axes: "analogues" | "physical", omega: number, omega_unit: "rad_per_s" | "per_min", epsilon: number,
 *   true_time: boolean, differenced: boolean,
 *   lesson: Readonly<{ id: string, step: number }> | null,
 *   projector: boolean,
 * }>} View
 *
 * @typedef {Readonly<{ crank?: string, base?: string, slide?: number, range?: readonly number[] }>} Driver
 * @typedef {Readonly<{ name: string, points: readonly string[], length?: number | null, shape?: readonly (readonly [number, number])[] | null, fixed_to?: string | null }>} LinkEntry
 * @typedef {Readonly<{
 *   title?: string | null, origin?: string | null, points: readonly Readonly<{ name: string, at: readonly [number, number] }>[], frame: readonly string[],
 *   links: readonly LinkEntry[], drivers: readonly Driver[], slides?: readonly Readonly<{ point: string, line: readonly string[] }>[],
 *   tracers?: readonly Readonly<{ name: string, link: string, at: readonly [number, number] }>[],
 *   assembly?: number | null, band?: number | null,
 * }>} LinkageDocument and what else docs/file-format.md has, which the page only passes on
 *
 * @typedef {{ mixer: MixerDocument, linkage: LinkageDocument }} Documents
 * @typedef {keyof Documents} Kind of document
 * @typedef {Partial<MixerDocument> | Partial<LinkageDocument>} Change of a document
 */

/**
 * @template {Kind} [K=Kind]
 * @typedef {K extends Kind ? Readonly<{ format: 2, kind: K, document: Documents[K], view: View }> : never} State
 */

/** What can be laid over the drawing. */
export const OVERLAYS = Object.freeze(/** @type {const} */ (["traces", "centres", "vectors", "loop_vectors", "transmission", "groups"]));

/** What is shown or not: over the drawing, and over the plots. */
export const SWITCHES = Object.freeze(/** @type {const} */ ([...OVERLAYS, "differenced"]));

/** What of the view the engine draws by, or may refuse. */
export const DRAWN = Object.freeze(
  /** @type {const} */ ([...SWITCHES, "plot", "axes", "omega", "epsilon", "true_time"]),
);

/** Of a list of the document: the number of its first entry as readers count, and how many it may have. */
export const LISTS = Object.freeze({
  wheels: Object.freeze({ first: 5, least: 1, most: 6 }),
  tracers: Object.freeze({ first: 1, least: 0, most: 6 }),
});

/**
 * @param {string} link that carries a traced point
 * @returns {number} which peripheral wheel it is, from 0; below 0 where it is none
 */
export function wheelOf(link) {
  return link.startsWith("wheel") ? Number(link.slice(5)) - LISTS.wheels.first : -1;
}

/**
 * @param {number} index of a peripheral wheel, from 0
 * @returns {string} the link's name, which is also its role's
 */
export function wheelLink(index) {
  return `wheel${index + LISTS.wheels.first}`;
}

/**
 * @param {Partial<View>} view
 * @returns {View} with what it says, else the usual
 */
function completeView(view) {
  return Object.freeze({
    phi_deg: 62,
    s: 0,
    playing: true,
    direction: 1,
    speed: 1,
    traces: true,
    centres: false,
    vectors: false,
    loop_vectors: false,
    transmission: false,
    groups: false,
    plot: "angles",
    axes: "analogues",
    omega: 1,
    omega_unit: "rad_per_s",
    epsilon: 0,
    true_time: false,
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
 * @returns {State}
 */
export function initialState(kind, document, view) {
  return stateOf(kind, document, completeView(view));
}

/**
 * @template {Kind} K
 * @param {K} kind
 * @param {Documents[K]} document
 * @param {View} view
 */
function stateOf(kind, document, view) {
  return /** @type {State} */ (Object.freeze({ format: 2, kind, document, view }));
}

/**
 * Another mechanism instead of the one there is, in one state: drawing, plots, saving and undo go on alike.
 * @template {Kind} K
 * @param {State} state
 * @param {K} kind
 * @param {Documents[K]} document
 * @returns {State}
 */
export function withMechanism(state, kind, document) {
  const { plot } = state.view;
  const kept = "links" in document ? plotsOf(document).includes(plot) : state.kind === kind;
  return withView(stateOf(kind, document, state.view), { plot: kept ? plot : "angles" });
}

/**
 * @param {LinkageDocument} document
 * @returns {string[]} what can be plotted of a linkage
 */
export function plotsOf({ links, points, tracers = [] }) {
  return ["angles", ...links.map(({ name }) => `${name}.angle`), ...[...points, ...tracers].map(({ name }) => name)];
}

/**
 * @param {State} state
 * @param {Change} change of a document of its kind
 * @returns {State} the same state where nothing changes
 */
export function withDocument(state, change) {
  const document = merged(state.document, change);
  if (document === state.document) return state;
  if ("links" in document) return withMechanism(state, "linkage", document);
  // With a wheel goes what was traced of it.
  const tracers = document.tracers.filter(({ link }) => wheelOf(link) < document.wheels.length);
  const { plot } = state.view;
  const gone = /^P\d$/.test(plot) && Number(plot.slice(1)) > tracers.length;
  const left = tracers.length < document.tracers.length ? Object.freeze({ ...document, tracers }) : document;
  return withView(stateOf("mixer", left, state.view), { plot: gone ? "angles" : plot });
}

/**
 * A change of a mechanism of one kind; another stays as it is.
 * @template {Kind} K
 * @param {State} state
 * @param {K} kind
 * @param {(document: Documents[K]) => Change} change
 * @returns {State}
 */
export function edited(state, kind, change) {
  return state.kind === kind ? withDocument(state, change(/** @type {Documents[K]} */ (state.document))) : state;
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
  return keys.every((key) => same(value[key], part[key]));
}

/**
 * @param {unknown} one
 * @param {unknown} other
 * @returns {boolean} lists are the same where all in them is
 */
function same(one, other) {
  return Object.is(one, other) || (Array.isArray(one) && JSON.stringify(one) === JSON.stringify(other));
}
