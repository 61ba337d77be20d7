// A mechanism from the catalogue or from a document, with its poses. The caller needs no state of the page.
import { Simulator, catalogue, defaultView } from "./engine/assur_web.js";

/** Suffixes of the names of derivatives, by order. */
const STROKES = Object.freeze(["", "′", "″"]);

export class Mechanism {
  #simulator = new Simulator();

  constructor(kind, document, view = {}) {
    this.summary = this.#simulator.set({ format: 2, kind, document, view: { ...defaultView(), ...view } });
  }

  static named(id) {
    const found = catalogue().find((one) => one.id === id);
    if (!found) throw new RangeError(`no mechanism ${id} in the catalogue`);
    return new Mechanism(found.kind, found.document);
  }

  pose(input) {
    const { frame, readouts: values } = this.#simulator.at(input);
    const named = this.#simulator.readouts().map(({ quantity, order }, at) => [quantity + STROKES[order], values[at]]);
    const readouts = values.length === 0 ? null : Object.fromEntries(named);
    const bodies = Array.from({ length: frame[0] }, (_, body) => [...frame.subarray(1 + 3 * body, 4 + 3 * body)]);
    return { bodies, readouts };
  }

  outputs() {
    return this.#simulator.outputs();
  }

  transmissions() {
    return this.#simulator.transmissions();
  }

  profile() {
    return this.#simulator.profile();
  }

  sweep(steps) {
    return this.#simulator.sweep(steps);
  }

  free() {
    this.#simulator.free();
  }
}
