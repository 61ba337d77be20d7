// Description of poses without a linkage for screen readers. The page itself describes a linkage that moves.
import { byId, write } from "assur/core/dom.js";
import { saidOf } from "assur/kinds/poses/verdicts.js";

export class Description {
  #drawing = byId("mechanism-description", HTMLElement);

  /** @param {import("assur/kinds/poses/task.js").Snapshot} snapshot */
  render(snapshot) {
    const { summary, state: { document: { poses } }, words } = snapshot;
    if (summary.moves) return;
    const { numbers } = words;
    const said = poses.map(({ x, y, angle_deg: angle }, k) => words.text("poses.told", {
      n: String(k + 1), x: numbers.short(x), y: numbers.short(y), angle: `${numbers.short(angle)}°`,
    }));
    write(this.#drawing, [...said, ...saidOf(snapshot)].join(" "));
  }
}
