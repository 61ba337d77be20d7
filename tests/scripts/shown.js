// Read-outs of a mechanism, made by the views of the page.
import { clear } from "assur/tests/document.js";
import { StatusLine } from "assur/controls/status.js";
import { ENTRIES as TRAIN } from "assur/kinds/gear-train/status.js";
import { CourseView } from "assur/kinds/linkage/course.js";
import { ENTRIES as LINKAGE } from "assur/kinds/linkage/status.js";
import { ENTRIES as MIXER } from "assur/kinds/mixer/status.js";
import { ENTRIES as SCHEME } from "assur/kinds/scheme/status.js";
import { ENTRIES as SYNTHESIS } from "assur/kinds/synthesis/status.js";
import { Curvature } from "assur/plots/curvature.js";
import { ReadoutTable } from "assur/plots/readouts.js";
import { Shown } from "assur/controls/shown.js";
import { Drafts } from "assur/state/drafts.js";
import { Model, moves } from "assur/state/model.js";
import { wordsOf } from "assur/tests/words.js";

const ENTRIES = { "gear-train": TRAIN, linkage: LINKAGE, mixer: MIXER, scheme: SCHEME, synthesis: SYNTHESIS };

/**
 * @param {import("assur/engine.js").Engine} engine
 * @param {import("assur/state/state.js").State} state
 * @param {import("assur/core/words.js").Words} [words]
 */
export function snapshotOf(engine, state, words = wordsOf(state.view.lang)) {
  const model = new Model(engine, new Drafts(() => {}), state);
  return model.snapshot(state, words.measured(engine.lengths), true);
}

/** The views of read-outs, on a page of their own with nothing else. */
export class Views {
  shown = new Shown();
  /**
   * @param {import("assur/engine.js").Engine} engine
   * @param {string} kind of the documents
   */
  constructor(engine, kind) {
    clear();
    const page = { engine, shown: this.shown, model: { kind }, drafts: new Drafts(() => {}) };
    this.all = [new StatusLine(kind, ENTRIES[kind], page)];
    if (kind === "linkage") this.all.unshift(new CourseView(page));
    this.moving = [new ReadoutTable(page), new Curvature(page)];
  }

  /**
   * @param {import("assur/state/model.js").AnySnapshot} snapshot
   * @param {readonly string[]} [withheld]
   */
  render(snapshot, withheld = []) {
    const given = { ...snapshot, withheld: new Set(withheld) };
    for (const view of [...(moves(given) ? this.moving : []), ...this.all]) view.render(given);
    return this;
  }

  /** @returns {readonly import("assur/controls/shown.js").Cell[]} all read-outs that are shown */
  get cells() {
    return this.shown.rows("values", "curvature", "status", "course").flatMap(({ cells }) => cells).filter(({ id }) => id !== "");
  }
}

/**
 * @param {import("assur/engine.js").Engine} engine
 * @param {import("assur/state/state.js").State} state
 * @returns {Views} the views of the state's read-outs
 */
export function shownOf(engine, state) {
  return new Views(engine, state.kind).render(snapshotOf(engine, state));
}
