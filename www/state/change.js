// Changes that the engine makes, put into the state: fields of the document, and the input.
import { attempt } from "assur/core/problem.js";
import { PARTS, edited, withDocument, withFurther, withMechanism, withView } from "assur/state/state.js";

/**
 * @typedef {import("assur/state/state.js").State} State
 * @typedef {{ asked: (home: number) => import("assur/engine.js").Changed, field: string }} Edit of a document: the request to the engine,
 * given the drawn input; the field that shows the reason of a refusal
 * @typedef {Extract<keyof import("assur/state/state.js").Documents, "linkage" | "draft">} TracedKind
 */

/**
 * @param {import("assur/engine.js").Changed} change
 * @param {Pick<import("assur/app/page.js").Page, "store" | "model" | "drafts">} page
 * @returns {boolean} whether it was taken: dragging a drawing that a refused state left behind does not change a document of
 * another kind
 */
export function take({ document, input }, { store, model, drafts }) {
  if (model.kind !== store.get().kind) return false;
  if (document) {
    drafts.dropAll(Object.keys(document));
    store.update((state) => withDocument(state, document));
  }
  if (input === undefined) return true;
  // The input belongs to the motion of the new document.
  model.follow(store.get());
  store.update((state) => model.coordinate.put(state, model.coordinate.place(input)));
  return true;
}

/**
 * Takes a change from the engine, or shows the reason of its refusal.
 * @param {() => import("assur/engine.js").Changed} asked request to the engine, which already has the state
 * @param {string} field that shows the reason of a refusal
 * @param {Pick<import("assur/app/page.js").Page, "store" | "model" | "drafts">} page
 */
export function change(asked, field, page) {
  const { value: changed, problems } = attempt(asked);
  if (changed) take(changed, page);
  else page.drafts.keep(field, problems);
}

/**
 * Places a traced point on the link that carries it.
 * @param {import("assur/state/store.js").Store<State>} store
 * @param {string} name
 * @param {number} axis 0: along the link from its first point to its second, 1: to the left of that
 * @param {number} value
 * @returns {number} the value, which the document then holds
 */
export function placeTraced(store, name, axis, value) {
  store.update((state) => edited(state, /** @type {TracedKind} */ (state.kind), ({ tracers = [] }) => ({
    tracers: tracers.map((one) => (one.name === name ? { ...one, at: /** @type {[number, number]} */ (one.at.with(axis, value)) } : one)),
  })));
  return value;
}

/**
 * The current input, for the engine, which then has the state.
 * @param {Pick<import("assur/app/page.js").Page, "store" | "model">} page
 * @returns {number}
 */
export function inputNow({ store, model }) {
  const state = store.get();
  model.follow(state);
  return model.coordinate.input(model.coordinate.of(state));
}

/**
 * Replaces the document by another, in one step of undo.
 * @param {State["kind"]} kind
 * @param {State["document"]} document of that kind
 * @param {readonly Edit[]} edits changes that the engine makes to it
 * @param {(summary: import("assur/engine.js").Summary | null) => Partial<State["view"]>} look gives its view from the engine's summary, which
 * is null if the engine refuses it
 * @param {Pick<import("assur/app/page.js").Page, "store" | "model" | "drafts" | "history" | "mechanism">} page
 */
export function choose(kind, document, edits, look, page) {
  const { store, model, history, mechanism } = page;
  history.step(() => {
    store.update((state) => withView(withFurther(withMechanism(state, kind, document), { compared: undefined, picture: undefined }), PARTS));
    mechanism.fit();
    for (const { asked, field } of edits) {
      model.follow(store.get());
      change(() => asked(model.home), field, page);
    }
    // The previous input may lie outside the range of the new driver.
    model.follow(store.get());
    const { coordinate, home } = model;
    if (!model.placed) store.update((state) => coordinate.put(state, coordinate.place(home)));
    store.update((state) => withView(state, look(model.sound ? model.summary : null)));
  });
}
