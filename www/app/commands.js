// Commands of the header's buttons and of the keyboard, by name.
import { awaited } from "assur/app/busy.js";
import { takeFile } from "assur/app/opening.js";
import { copyLink, filePicker, saveFile } from "assur/app/share.js";
import { CUT, LONG, LOST } from "assur/app/notices.js";
import { toggleProjector } from "assur/app/projector.js";
import { SPEEDS } from "assur/controls/transport.js";
import { attempt } from "assur/core/problem.js";
import { compiledWasm } from "assur/core/wasm.js";
import { inputNow, take } from "assur/state/change.js";
import { INPUT } from "assur/state/drafts.js";
import { turned } from "assur/state/player.js";
import { extrasOf, withExtras, withMechanism, withView } from "assur/state/state.js";

/**
 * @typedef {import("assur/app/page.js").Page} Page
 * @typedef {Readonly<Record<string, () => void>>} Commands
 */

/** Length of a URL, in characters, from which messaging programs may cut the URL off. */
const LONG_LINK = 8000;

/**
 * @param {Page} page
 * @returns {Commands}
 */
export function commands(page) {
  return Object.freeze({ ...fileCommands(page), ...motionCommands(page) });
}

/**
 * Commands that open, save, share and print mechanisms, and commands that open parts of the page.
 * @param {Page} page
 * @returns {Commands}
 */
function fileCommands(page) {
  const { engine, model, notices, store } = page;
  // The last document that the engine accepted, with the current lesson, comparison and picture.
  const now = () => withExtras(model.lastAccepted, extrasOf(store.get()));
  const copy = async () => {
    const { link, copied } = await copyLink(now(), page.address);
    /** @type {readonly import("assur/app/notices.js").Done[]} */
    const done = copied ? [store.get().picture ? "copied_without" : "copied"] : [];
    notices.tell([...done, ...(link.length >= LONG_LINK ? CUT : [])]);
  };
  /**
   * Loads a part of the page on first use, and calls a function with that part.
   * @template Part
   * @param {() => Promise<Part>} load
   * @param {(part: Part) => void} act
   */
  const later = async (load, act) => {
    // Most modules loaded here call functions in the second part of the engine, so that part is always loaded too.
    const loaded = await awaited(Promise.all([load(), compiledWasm(), page.withFurther()])).catch(() => null);
    if (loaded) act(loaded[0]);
    else notices.tell(LOST);
  };
  return {
    open: filePicker((file) => page.take(takeFile(file, engine, page.ofNow()))),
    save: () => saveFile(now(), engine.catalogue.fileName(now())),
    copy: () => (page.address.holds(now()) ? copy() : notices.tell(LONG)),
    export: () => later(() => import("assur/export/dialog.js"), ({ openExport }) => openExport(page)),
    print: () => later(() => import("assur/export/worksheet.js"), () => window.print()),
    "new-drawing": () => later(() => import("assur/drawing/begin.js"), ({ newDrawing }) => newDrawing(page)),
    draw: () => later(() => import("assur/drawing/begin.js"), ({ toggleDrawing }) => toggleDrawing(page)),
    "write-lesson": () => later(() => import("assur/lesson/begin.js"), ({ writeLesson }) => writeLesson(page)),
    gallery: () => later(() => import("assur/gallery/gallery.js"), ({ openGallery }) => openGallery(page)),
    help: () => later(() => import("assur/help/help.js"), ({ openHelp }) => openHelp(page.words)),
  };
}

/**
 * Commands that move and change the mechanism.
 * @param {Page} page
 * @returns {Commands}
 */
function motionCommands(page) {
  const { store, model, drafts, history, engine } = page;
  const assemble = (/** @type {1 | 2} */ number) => {
    const { value: change } = attempt(() => engine.simulator.assemble(number, inputNow(page)));
    // A mechanism without this assembly stays as it is.
    if (change) history.step(() => take(change, page));
  };
  const hasten = (/** @type {1 | -1} */ by) => {
    store.update((state) => {
      const { speed } = state.view;
      const next = by > 0 ? SPEEDS.find((one) => one > speed) : SPEEDS.findLast((one) => one < speed);
      return next === undefined ? state : withView(state, { speed: next, true_time: false });
    });
  };

  // The preset to which a mixer is reset: the one shown last, or else the first of the catalogue. Any other mechanism
  // is reset to the preset that it comes from.
  const [first] = engine.catalogue.mixers;
  let preset = first;
  const note = (/** @type {import("assur/state/state.js").State} */ state) => {
    if (state.kind === first.kind) preset = engine.catalogue.presetOf(state) ?? preset;
  };
  note(store.get());
  store.subscribe((state, previous) => {
    if (state.document !== previous.document) note(state);
  });

  const inputShown = () => model.coordinate.of(store.get());
  return {
    play: () => {
      drafts.drop(INPUT);
      store.update((state) => withView(state, { playing: !state.view.playing }));
    },
    reverse: () => store.update((state) => withView(state, { direction: turned(state.view.direction) })),
    back: () => page.step(-1),
    forward: () => page.step(1),
    back10: () => page.step(-10),
    forward10: () => page.step(10),
    start: () => page.drive(model.coordinate.axis(inputShown()).start),
    end: () => page.drive(model.coordinate.last(inputShown())),
    faster: () => hasten(1),
    slower: () => hasten(-1),
    assembly1: () => assemble(1),
    assembly2: () => assemble(2),
    projector: () => toggleProjector(page),
    undo: () => history.undo(),
    redo: () => history.redo(),
    reset: () => {
      history.step(() => store.update((state) => {
        const original = state.kind === preset.kind ? preset : engine.catalogue.presetOf(state);
        return original ? withMechanism(state, original.kind, original.document) : state;
      }));
    },
  };
}
