// What the read-outs of the page have, by their ids, from the same summary and values.
import { readoutOf } from "assur/core/symbols.js";
import { quantityText } from "assur/plots/values.js";
import { Drafts } from "assur/state/drafts.js";
import { Model } from "assur/state/model.js";
import { wordsOf } from "assur/tests/words.js";

const STROKES = ["", "′", "″"];

/** Entries of status lines that links of tests/links.txt show. */
const STATUS = {
  ratio: ({ ratios }) => ratios?.[0],
  "scheme-w": ({ counts, mobility }) => (counts && "pairs" in counts ? mobility : undefined),
  "scheme-q": ({ redundant, space }) => space?.redundant ?? redundant,
  "scheme-rank": ({ plane, space }) => (plane ?? space)?.mobility,
  "scheme-links": ({ counts }) => counts?.links,
};

/**
 * @param {import("assur/engine.js").Engine} engine
 * @param {import("assur/state/state.js").State} state
 * @param {import("assur/core/words.js").Words} [words]
 */
export function snapshotOf(engine, state, words = wordsOf(state.view.lang)) {
  const model = new Model(engine, new Drafts(() => {}), state);
  return model.snapshot(state, words.measured(engine.lengths), true);
}

/**
 * @param {import("assur/state/model.js").AnySnapshot} snapshot
 * @returns {Record<string, number>} values by the ids of their read-outs, after `out-`
 */
export function readoutsOf({ summary, inputShown, readouts, words }) {
  const shown = { input: inputShown };
  for (const { name, what } of summary.listed ?? []) {
    for (const [order, stroke] of STROKES.entries()) {
      const value = readouts?.[name + stroke];
      if (value !== undefined) shown[readoutOf(name, order)] = quantityText(value, what, order, words).value;
    }
  }
  for (const [id, value] of Object.entries(STATUS)) {
    const found = value(summary);
    if (found !== undefined && found !== null) shown[id] = found;
  }
  return shown;
}
