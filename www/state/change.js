// What the engine changes, put into the state: fields of the document, and where the driver is.
import { attempt } from "assur/core/problem.js";
import { withDocument } from "assur/state/state.js";

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
 * Where the driver is, for the engine, which then knows the state.
 * @param {Pick<import("assur/app/page.js").Page, "store" | "model">} page
 * @returns {number}
 */
export function inputNow({ store, model }) {
  const state = store.get();
  model.follow(state);
  return model.coordinate.input(model.coordinate.of(state));
}
