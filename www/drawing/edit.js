// Edits of what is drawn: the engine says what becomes of it, and whether it moves then.
import { attempt } from "assur/core/problem.js";
import { inputNow } from "assur/state/change.js";
import { PARTS, withMechanism, withView } from "assur/state/state.js";

/**
 * @typedef {import("assur/app/page.js").Page} Page
 * @typedef {import("assur/types/edit.js").Edit} Edit
 * @typedef {import("assur/state/state.js").State} State
 * @typedef {{ kind: "draft" | "linkage", document: import("assur/state/state.js").Documents["linkage"], point: string | null, link: string | null, held: boolean }} Drawn
 */

/** Where it stands why an edit is not done. */
const FIELD = "edit";

/**
 * Edits what is open, or says why it cannot be done.
 * @param {Page} page
 * @param {Edit} wanted
 * @returns {Drawn | null}
 */
export function edit(page, wanted) {
  const { engine, store, model, drafts } = page;
  const input = inputNow(page);
  const { value: drawn, problems } = attempt(() => engine.ask((simulator) => /** @type {Drawn} */ (simulator.edit(wanted, input))));
  if (!drawn) {
    drafts.keep(FIELD, problems);
    return null;
  }
  drafts.drop(FIELD);
  const { kind, document, held } = drawn;
  if (held) refuse(page, "held_by_locks");
  store.update((state) => withView(withMechanism(state, kind, document), { drawing: true, playing: false }));
  model.follow(store.get());
  if (model.astray) {
    store.update((state) => withView(state, PARTS));
    model.follow(store.get());
  }
  // It is drawn where it is: the driver stands there.
  if (model.sound && model.summary.moves) store.update((state) => model.coordinate.put(state, model.coordinate.place(model.home)));
  return drawn;
}

/**
 * The same as a step of its own.
 * @param {Page} page
 * @param {Edit} wanted
 * @returns {Drawn | null}
 */
export function step(page, wanted) {
  /** @type {Drawn | null} */
  let drawn = null;
  page.history.step(() => {
    drawn = edit(page, wanted);
  });
  return drawn;
}

/**
 * Says what is not done, until the next edit.
 * @param {Page} page
 * @param {string} code of a problem
 */
export function refuse(page, code) {
  page.drafts.keep(FIELD, [{ code }]);
}

/** @param {Page} page */
export function unsay(page) {
  page.drafts.drop(FIELD);
}
