// Edits of a drawing: the engine makes the changed document and determines whether the linkage moves.
import { attempt } from "assur/core/problem.js";
import { inputNow } from "assur/state/change.js";
import { PARTS, withMechanism, withView } from "assur/state/state.js";

/**
 * @typedef {import("assur/app/page.js").Page} Page
 * @typedef {import("assur/types/edit.js").Edit} Edit
 * @typedef {import("assur/state/state.js").State} State
 * @typedef {ReturnType<import("assur/pkg/assur_web.js").Simulator["edit"]>} Drawn the drawing after an edit
 */

/** Name of the field that shows the reason for refusing an edit. */
const FIELD = "edit";

/** Time for which a message about a press or a drag stays if nothing else is done, in milliseconds. */
const MESSAGE_PERIOD = 8000;

/** @type {ReturnType<typeof setTimeout> | undefined} */
let leaving;

/**
 * Edits the open document, and shows the result at rest, with the drawing tools. Shows the reason if the edit is refused, and then returns null.
 * @param {Page} page
 * @param {Edit} wanted
 * @returns {Drawn | null}
 */
export function edit(page, wanted) {
  const { engine, store, model, drafts } = page;
  const input = inputNow(page);
  const { value: drawn, problems } = attempt(() => engine.simulator.edit(wanted, input));
  if (!drawn) {
    drafts.keep(FIELD, problems);
    return null;
  }
  drafts.drop(FIELD);
  const { kind, document, held } = drawn;
  if (held) refuse(page, "held_by_locks");
  store.update((state) => withView(withMechanism(state, kind, document), { drawing: true, playing: false }));
  model.follow(store.get());
  if (model.hasDanglingReference) {
    store.update((state) => withView(state, PARTS));
    model.follow(store.get());
  }
  // The edited pose is now the drawn pose. The driver goes to the drawn input.
  if (model.accepted && model.summary.moves) store.update((state) => model.coordinate.put(state, model.coordinate.inputShown(model.home)));
  return drawn;
}

/**
 * Makes an edit as an undo step of its own.
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
 * Shows the reason for a refusal, or a message about the effect of a press, until the next edit.
 * @param {Page} page
 * @param {string} code of a problem
 * @param {Readonly<Record<string, string>>} [parameters] of its sentence
 */
export function refuse(page, code, parameters = {}) {
  page.drafts.keep(FIELD, [{ code, ...parameters }]);
}

/** @param {Page} page */
export function unsay(page) {
  clearTimeout(leaving);
  page.drafts.drop(FIELD);
}

/**
 * Removes a message after some seconds.
 * @param {Page} page
 */
export function unsayLater(page) {
  clearTimeout(leaving);
  if (page.drafts.has(FIELD)) leaving = setTimeout(() => unsay(page), MESSAGE_PERIOD);
}
