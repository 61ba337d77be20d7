// All motions of the shown linkage, found by a worker, which gets one question at a time, always the newest.
import { compiledWasm } from "assur/core/wasm.js";

/**
 * @typedef {import("assur/types/web.js").MotionsMap} MotionsMap
 * @typedef {import("assur/types/web.js").Belonging} Belonging
 */

export class Motions {
  #changed;
  /** @type {Worker | null} */
  #worker = null;
  /** Time at which the last question was sent, in milliseconds on the clock of `performance.now`. */
  #since = 0;
  /** The question to be sent once the worker is free. */
  #next = /** @type {object | null} */ (null);
  #busy = true;
  #revision = 0;
  /** @type {object | null} state of the linkage, from which a new worker starts */
  #state = null;
  /** Input and assembly of the last question, as text, and this assembly. */
  #asked = "";
  #number = 0;
  /** @type {MotionsMap | null} the newest map; it may be that of an earlier linkage */
  map = null;
  /** Whether the map is that of the linkage shown now. */
  current = false;
  /** @type {Belonging | null} branches of the assemblies at the input of the last question */
  #belonging = null;
  /** Whether the last question failed. */
  lost = false;

  /** @param {() => void} changed called when the worker has answered */
  constructor(changed) {
    this.#changed = changed;
  }

  /**
   * @param {number} revision of the linkage
   * @param {object} state
   */
  of(revision, state) {
    if (this.#revision === revision) return;
    this.#revision = revision;
    this.#state = state;
    this.current = this.lost = false;
    this.#belonging = null;
    this.#asked = "";
    this.#ask({ revision, state });
  }

  /** Ends the worker and forgets its results, when the panel is closed. */
  close() {
    this.#end();
    this.#next = this.#state = this.map = this.#belonging = null;
    this.#revision = 0;
    this.#asked = "";
    this.current = this.lost = false;
  }

  /**
   * @param {number} input
   * @param {number} number of the shown assembly, from 0
   */
  at(input, number) {
    const asked = `${input} ${number}`;
    if (!this.current || asked === this.#asked || this.#next) return;
    this.#asked = asked;
    this.#number = number;
    this.#belonging = null;
    this.#ask({ revision: this.#revision, input, number });
  }

  /** @returns {number | null} index of the branch of the shown assembly, null if it is not known; a motion stays on its branch */
  get branch() {
    return this.current ? (this.#belonging?.branches[this.#number] ?? null) : null;
  }

  /**
   * @param {number} input
   * @param {number} number of the shown assembly, from 0
   * @returns {Belonging["reached"] | null} how each assembly at the input can be reached from the shown one; null if it is not known
   */
  reached(input, number) {
    return (this.current && `${input} ${number}` === this.#asked && this.#belonging?.reached) || null;
  }

  /** @param {object} question */
  #ask(question) {
    this.#next = question;
    if (!this.#worker) this.#begin();
    else if (!this.#busy) this.#send();
  }

  #send() {
    if (!this.#next) return;
    this.#worker?.postMessage(this.#next);
    this.#next = null;
    this.#busy = true;
    this.#since = performance.now();
  }

  async #begin() {
    const worker = new Worker(import.meta.resolve("assur/assemblies/worker.js"), { type: "module" });
    this.#worker = worker;
    worker.addEventListener("message", ({ data }) => this.#receive(data));
    worker.addEventListener("error", () => this.#receive({ lost: true, broken: true }));
    try {
      const wasm = await compiledWasm();
      if (worker !== this.#worker) return;
      // A new worker first needs the linkage; a question about an input waits until the map is found.
      const question = this.#next && "state" in this.#next ? this.#next : { revision: this.#revision, state: this.#state };
      if (question === this.#next) this.#next = null;
      worker.postMessage({ wasm, ...question });
    } catch {
      if (worker !== this.#worker) return;
      this.#next = null;
      this.#receive({ lost: true, broken: true });
    }
  }

  #end() {
    this.#worker?.terminate();
    this.#worker = null;
    this.#busy = true;
  }

  /** @param {{ revision?: number, map?: MotionsMap, belonging?: Belonging, lost?: boolean, broken?: boolean }} answer */
  #receive({ revision, map, belonging, lost, broken }) {
    const current = revision === this.#revision;
    if (map) {
      this.map = map;
      this.current = current;
    }
    if (belonging && current) this.#belonging = belonging;
    if (current && (map || belonging)) this.lost = false;
    // The answer of a broken worker may lack the revision.
    if (lost && (current || broken)) this.lost = true;
    if (lost && current) this.map = null;
    if (broken) {
      // The next question goes to a new worker.
      this.#end();
      if (this.#next) this.#begin();
      this.#changed();
      return;
    }
    // During a drag the worker rests twice as long as it worked, because the page needs the same processors to draw.
    const rest = map && this.#next ? 2 * (performance.now() - this.#since) : 0;
    const worker = this.#worker;
    setTimeout(() => {
      if (worker !== this.#worker) return;
      this.#busy = false;
      this.#send();
    }, rest);
    this.#changed();
  }
}
