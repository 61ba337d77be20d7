// Page without elements: state, model and history with the engine, connected as in app/page.js.
import "assur/tests/window.js";
import { Shown } from "assur/controls/shown.js";
import { choose } from "assur/state/change.js";
import { Drafts } from "assur/state/drafts.js";
import { History } from "assur/state/history.js";
import { Model } from "assur/state/model.js";
import { Store } from "assur/state/store.js";
import { newEngine, stateOf } from "assur/tests/engine.js";
import { wordsOf } from "assur/tests/words.js";

export class Page {
  engine = newEngine();
  drafts = new Drafts(() => {});
  mechanism = { fit() {} };
  words = wordsOf("en");
  shown = new Shown();
  habits = { calm: false, lang: "en" };
  onPaper = new Map();

  /** @param {string} id of the mechanism of the catalogue that is open */
  constructor(id, view = {}) {
    this.store = new Store(stateOf(this.engine, id, view));
    this.history = new History(this.store, this.drafts);
    this.model = new Model(this.engine, this.drafts, this.store.get());
  }

  choose(kind, document, edits = [], look = () => ({})) {
    choose(kind, document, edits, look, this);
  }

  /** @returns the snapshot of the current state, with numbers due */
  now() {
    this.model.follow(this.store.get());
    return this.model.snapshot(this.store.get(), this.words.measured(this.engine.lengths), true);
  }
}
