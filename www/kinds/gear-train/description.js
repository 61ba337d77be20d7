// Description of a train for screen readers, in addition to the description of its pose.
import { byId, make, write } from "assur/core/dom.js";
import { Seen } from "assur/core/seen.js";
import { asksSpeed } from "assur/kinds/gear-train/drives.js";

/** @typedef {import("assur/kinds/gear-train/drives.js").Snapshot} Snapshot */

/** Milliseconds without a change before an announcement. */
const PAUSE = 700;

export class TrainDescription {
  #element = make("p", { id: "train-description", class: "unseen", "data-of": "gear-train" });
  #shown = new Seen();
  #timer = 0;

  constructor() {
    byId("mechanism-description", HTMLElement).after(this.#element);
  }

  /** @param {Snapshot} snapshot */
  render({ summary, words, stale, withheld }) {
    if (this.#shown.same(summary, words, stale, withheld) || stale) return;
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => write(this.#element, speedsText(summary, words, withheld)), PAUSE);
  }
}

/**
 * @param {Snapshot["summary"]} summary
 * @param {Snapshot["words"]} words
 * @param {ReadonlySet<string>} withheld
 */
function speedsText({ speeds, slips }, words, withheld) {
  const said = Object.fromEntries(Object.entries(speeds).map(([body, speed]) => [body, asksSpeed(body, withheld) ? "?" : words.numbers.upTo(speed, 2)]));
  const parts = [words.text("told.train", said)];
  if (slips) parts.push(words.text("told.slipped", { sun: words.numbers.exact(slips[0]), ring: words.numbers.exact(slips[1]) }));
  return parts.join(" ");
}
