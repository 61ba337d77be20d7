// What buttons of the header and keys do, by name.
import { degrees } from "assur/angles.js";
import { placed, turned } from "assur/player.js";
import { contains, withDocument, withMechanism, withView } from "assur/state.js";
import { SPEEDS } from "assur/transport.js";

/**
 * @typedef {import("assur/engine.js").Engine} Engine
 * @typedef {import("assur/state.js").State} State
 * @typedef {Readonly<Record<string, () => void>>} Commands
 */

/**
 * @param {{
 *   store: import("assur/store.js").Store<State>,
 *   model: import("assur/model.js").Model,
 *   drafts: import("assur/drafts.js").Drafts,
 *   history: import("assur/history.js").History,
 *   engine: Engine,
 * }} parts
 * @returns {Commands}
 */
export function commands({ store, model, drafts, history, engine }) {
  const { presets } = engine;
  const put = (/** @type {(state: State) => number} */ where) => {
    drafts.drop("phi_deg");
    store.update((state) => placed(state, where(state), model));
  };
  const turn = (/** @type {number} */ by) => put(({ view }) => view.phi_deg + by);
  const assemble = (/** @type {1 | 2} */ assembly) => {
    const { assemblies = 2 } = /** @type {{ assemblies?: number }} */ (model.summary);
    if (assembly > assemblies) return;
    history.step(() => store.update((state) => withDocument(state, { assembly })));
  };
  const hasten = (/** @type {1 | -1} */ by) => {
    store.update((state) => {
      const { speed } = state.view;
      const next = by > 0 ? SPEEDS.find((one) => one > speed) : SPEEDS.findLast((one) => one < speed);
      return next === undefined ? state : withView(state, { speed: next, true_time: false });
    });
  };

  // The preset that the mechanism was last; of an opened one that was none, the first.
  let preset = presets[0].document;
  const note = (/** @type {State} */ { lesson, document }) => {
    if (lesson !== "mixer") return;
    preset = presets.find((one) => contains(document, one.document))?.document ?? preset;
  };
  note(store.get());
  store.subscribe(note);

  return Object.freeze({
    play: () => {
      drafts.drop("phi_deg");
      store.update((state) => withView(state, { playing: !state.view.playing }));
    },
    reverse: () => store.update((state) => withView(state, { direction: turned(state.view.direction) })),
    back: () => turn(-1),
    forward: () => turn(1),
    back10: () => turn(-10),
    forward10: () => turn(10),
    start: () => put(() => degrees(model.summary.cycle.start)),
    end: () => put(() => degrees(model.summary.cycle.end)),
    faster: () => hasten(1),
    slower: () => hasten(-1),
    assembly1: () => assemble(1),
    assembly2: () => assemble(2),
    projector: () => store.update((state) => withView(state, { projector: !state.view.projector })),
    undo: () => history.undo(),
    redo: () => history.redo(),
    reset: () => {
      history.step(() => store.update((state) => {
        if (state.lesson === "mixer") return withDocument(state, { ...preset, tracers: [] });
        const original = engine.original(state.document);
        return original ? withMechanism(state, state.lesson, original.document) : state;
      }));
    },
  });
}
