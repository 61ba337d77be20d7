// A mechanism from the catalogue or from a document, with its poses. The caller needs no state of the page.
import { Simulator, catalogue } from "./engine/assur_web.js";

/** Default view of a mechanism, in the form that the engine expects. */
const VIEW = Object.freeze({
  phi_deg: 0, s: 0, t: 0, playing: false, direction: 1, speed: 1, lang: "en", traces: false, plot: "angles", omega: 1, epsilon: 0,
});

/** Number of lists in the result of the simulator's `at`. */
const LISTS = 4;

export class Mechanism {
  #simulator = new Simulator();

  constructor(kind, document, view = {}) {
    this.summary = this.#simulator.set({ format: 2, kind, document, view: { ...VIEW, ...view } });
  }

  static named(id) {
    const found = catalogue().find((one) => one.id === id);
    if (!found) throw new RangeError(`no mechanism ${id} in the catalogue`);
    return new Mechanism(found.kind, found.document);
  }

  pose(input) {
    const flat = this.#simulator.at(input);
    let end = LISTS;
    const [frame, , values] = [...flat.subarray(0, LISTS)].map((length) => flat.subarray(end, (end += length)));
    const names = this.#simulator.readoutNames();
    const readouts = values.length === 0 ? null : Object.fromEntries(names.map((name, at) => [name, values[at]]));
    const bodies = Array.from({ length: frame[0] }, (_, body) => [...frame.subarray(1 + 3 * body, 4 + 3 * body)]);
    return { bodies, readouts };
  }

  sweep(steps) {
    return this.#simulator.sweep(steps);
  }

  free() {
    this.#simulator.free();
  }
}
