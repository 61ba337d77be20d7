// What the engine changes, put into the state: fields of the document, and where the driver is.
import { attempt } from "assur/core/problem.js";
import { PARTS, edited, withDocument, withFurther, withMechanism, withView } from "assur/state/state.js";

/**
 * @typedef {import("assur/state/state.js").State} State
 * @typedef {{ asked: (home: number) => import("assur/engine.js").Changed, field: string }} Edit of a document: what is asked of the engine,
 * with the input where it is drawn; the field where it stands why it is not done
 * @typedef {Extract<keyof import("assur/state/state.js").Documents, "linkage" | "draft">} TracedKind
 */

/**
 * @param {import("assur/engine.js").Changed} change
 * @param {Pick<import("assur/app/page.js").Page, "store" | "model" | "drafts">} page
 * @returns {boolean} whether it was taken: a hand on a drawing that a refused state left behind changes nothing of a document of
 * another kind
 */
export function take({ document, input }, { store, model, drafts }) {
  if (model.kind !== store.get().kind) return false;
  if (document) {
    drafts.dropAll(Object.keys(document));
    store.update((state) => withDocument(state, document));
  }
  if (input === undefined) return true;
  // The place is one of the motion that is now.
  model.follow(store.get());
  store.update((state) => model.coordinate.put(state, model.coordinate.place(input)));
  return true;
}

/**
 * Takes what the engine is asked to change, or says why it does not.
 * @param {() => import("assur/engine.js").Changed} asked of the engine, which knows the state
 * @param {string} field where it stands why it is not done
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
 * Where the driver is, for the engine, which then knows the state.
 * @param {Pick<import("assur/app/page.js").Page, "store" | "model">} page
 * @returns {number}
 */
export function inputNow({ store, model }) {
  const state = store.get();
  model.follow(state);
  return model.coordinate.input(model.coordinate.of(state));
}

/**
 * Puts another document in the place of the one there is, in one step of undo.
 * @param {State["kind"]} kind
 * @param {State["document"]} document of that kind
 * @param {readonly Edit[]} edits what the engine makes other in it
 * @param {(summary: import("assur/engine.js").Summary | null) => Partial<State["view"]>} look how it is looked at, by what the engine says of it
 * if it takes it
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
    // The driver of another mechanism may not go where this one's stands.
    model.follow(store.get());
    const { coordinate, home } = model;
    if (!model.placed) store.update((state) => coordinate.put(state, coordinate.place(home)));
    store.update((state) => withView(state, look(model.sound ? model.summary : null)));
  });
}
