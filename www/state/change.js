// Changes made by the engine and their transfer to the state: fields of the document, and the input.
import { attempt } from "assur/core/problem.js";
import { PARTS, edited, withDocument, withExtras, withMechanism, withView } from "assur/state/state.js";

/**
 * @typedef {import("assur/state/state.js").State} State
 * @typedef {{ asked: (home: number) => import("assur/types/web.js").Changed, field: string }} Edit edit of a document. `asked`: the request to
 * the engine, given the drawn input; `field`: the field of the page that shows the reason for a refusal
 * @typedef {Extract<keyof import("assur/state/state.js").Documents, "linkage" | "draft">} TracedKind
 */

/**
 * @param {import("assur/types/web.js").Changed} change
 * @param {Pick<import("assur/app/page.js").Page, "store" | "model" | "drafts">} page
 * @returns {boolean} whether the change was taken. It is not if the drawing is of another kind than the document: after
 * the engine has refused a document, the previous drawing is still shown and can be dragged.
 */
export function take({ document, input }, { store, model, drafts }) {
  if (model.kind !== store.get().kind) return false;
  if (document) {
    drafts.dropAll(Object.keys(document));
    store.update((state) => withDocument(state, document));
  }
  if (input === undefined) return true;
  // The model takes the new document first, because the range of the input may have changed.
  model.follow(store.get());
  store.update((state) => model.coordinate.put(state, model.coordinate.inputShown(input)));
  return true;
}

/**
 * Takes a change from the engine, or shows the reason for the engine's refusal.
 * @param {() => import("assur/types/web.js").Changed} asked request to the engine, which already has the state
 * @param {string} field that shows the reason for a refusal
 * @param {Pick<import("assur/app/page.js").Page, "store" | "model" | "drafts">} page
 */
export function change(asked, field, page) {
  const { value: changed, problems } = attempt(asked);
  if (changed) take(changed, page);
  else page.drafts.keep(field, problems);
}

/**
 * Changes a coordinate of a traced point on its link.
 * @param {import("assur/state/store.js").Store<State>} store
 * @param {string} name
 * @param {number} axis 0: along the link from its first point to its second; 1: perpendicular to this line, to the left
 * @param {number} value
 * @returns {number} the value, which is now in the document
 */
export function placeTraced(store, name, axis, value) {
  store.update((state) => edited(state, /** @type {TracedKind} */ (state.kind), ({ tracers = [] }) => ({
    tracers: tracers.map((one) => (one.name === name ? { ...one, at: /** @type {[number, number]} */ (one.at.with(axis, value)) } : one)),
  })));
  return value;
}

/**
 * Returns the current input in the engine's unit, after the engine has taken the current state.
 * @param {Pick<import("assur/app/page.js").Page, "store" | "model">} page
 * @returns {number}
 */
export function inputNow({ store, model }) {
  const state = store.get();
  model.follow(state);
  return model.coordinate.input(model.coordinate.of(state));
}

/**
 * Replaces the document with another, without comparison and picture, in one undo step. The view is fitted to the new document.
 * @param {State["kind"]} kind
 * @param {State["document"]} document of that kind
 * @param {readonly Edit[]} edits changes that the engine makes to the document
 * @param {(summary: import("assur/state/details.js").Summary | null) => Partial<State["view"]>} look returns the view, given the engine's summary,
 * which is null if the engine refuses the document
 * @param {Pick<import("assur/app/page.js").Page, "store" | "model" | "drafts" | "history" | "mechanism">} page
 */
export function choose(kind, document, edits, look, page) {
  const { store, model, history, mechanism } = page;
  history.step(() => {
    store.update((state) => withView(withExtras(withMechanism(state, kind, document), { compared: undefined, picture: undefined }), PARTS));
    mechanism.fit(true);
    for (const { asked, field } of edits) {
      model.follow(store.get());
      change(() => asked(model.home), field, page);
    }
    // The previous input may lie outside the range of the new driver.
    model.follow(store.get());
    const { coordinate, home } = model;
    if (!model.hasPose) store.update((state) => coordinate.put(state, coordinate.inputShown(home)));
    store.update((state) => withView(state, look(model.accepted ? model.summary : null)));
  });
}
