// Description of a scheme for screen readers.
import { byId, write } from "assur/core/dom.js";
import { actual, asked } from "assur/kinds/scheme/sums.js";

/** @typedef {import("assur/kinds/scheme/opening.js").Snapshot} Snapshot */

export class Description {
  #drawing = byId("mechanism-description", HTMLElement);

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    const { state: { document }, summary, words } = snapshot;
    const { links, pairs } = summary;
    const { mobility, redundant } = actual(summary);
    const { numbers } = words;
    const [moving, joined] = [links.length - 1, pairs.length].map((one) => numbers.exact(one));
    const [w, q] = [asked(mobility, "w", snapshot), asked(redundant, "q", snapshot)];
    const parts = [document.task == null ? words.text("told.scheme", { links: moving, pairs: joined, w, q }) : ""];
    if (document.cut.length > 0) parts.push(words.text("told.cut", { pairs: document.cut.join(", ") }));
    write(this.#drawing, parts.join(" ").trim());
  }
}
