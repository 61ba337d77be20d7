// Description of a path without a linkage for screen readers. The page itself describes a linkage that moves.
import { byId, write } from "assur/core/dom.js";
import { saidOf } from "assur/kinds/point-path/verdict.js";

export class Description {
  #drawing = byId("mechanism-description", HTMLElement);

  /** @param {import("assur/kinds/point-path/verdict.js").Snapshot} snapshot */
  render(snapshot) {
    if (snapshot.summary.moves) return;
    write(this.#drawing, saidOf(snapshot).join(" "));
  }
}
