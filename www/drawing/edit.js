// Edits of a drawing: the engine makes the changed document and decides whether it moves.
import { attempt } from "assur/core/problem.js";
import { inputNow } from "assur/state/change.js";
import { PARTS, withMechanism, withView } from "assur/state/state.js";

/**
 * @typedef {import("assur/app/page.js").Page} Page
 * @typedef {import("assur/types/edit.js").Edit} Edit
 * @typedef {import("assur/state/state.js").State} State
 * @typedef {{ kind: "draft" | "linkage", document: import("assur/state/state.js").Documents["linkage"], point: string | null, link: string | null, held: boolean }} Drawn
 */

/** Name of the field that shows the reason of a refused edit. */
const FIELD = "edit";

/**
 * Edits the open document, or shows the reason of a refusal.
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
  // The edit was made in the drawn pose: the driver goes there.
  if (model.sound && model.summary.moves) store.update((state) => model.coordinate.put(state, model.coordinate.place(model.home)));
  return drawn;
}

/**
 * The edit as a step of its own.
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
 * Shows the reason of a refusal until the next edit.
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
