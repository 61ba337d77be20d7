// All motions of the linkage that is shown, from the worker that finds them. It is asked one thing at a time, the newest first:
// while a length is dragged the map follows some times a second.
import { compiledWasm } from "assur/engine.js";

/**
 * @typedef {import("assur/types/web.js").MotionsMap} MotionsMap
 * @typedef {import("assur/types/web.js").Belonging} Belonging
 */

export class Motions {
  #changed;
  /** @type {Worker | null} */
  #worker = null;
  /** When the worker was asked last. */
  #since = 0;
  /** What is asked when the worker is free. */
  #next = /** @type {object | null} */ (null);
  #busy = true;
  #revision = 0;
  /** @type {object | null} the state of that linkage, by which a new worker begins */
  #state = null;
  /** The input and the assembly that were asked for last. */
  #asked = "";
  /** @type {MotionsMap | null} of the newest linkage whose map was found */
  map = null;
  /** Whether the map is that of the linkage as it is. */
  current = false;
  /** @type {Belonging | null} where the assemblies at the input that was asked for belong */
  belonging = null;
  /** Whether it could not be found. */
  lost = false;

  /** @param {() => void} changed when something was found */
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
    this.belonging = null;
    this.#asked = "";
    this.#ask({ revision, state });
  }

  /** Ends the worker, and forgets what was found: nobody looks at it. */
  close() {
    this.#end();
    this.#next = this.#state = this.map = this.belonging = null;
    this.#revision = 0;
    this.#asked = "";
    this.current = this.lost = false;
  }

  /**
   * @param {number} input
   * @param {number} number of the assembly that is shown, from 0
   */
  at(input, number) {
    const asked = `${input} ${number}`;
    if (!this.current || asked === this.#asked || this.#next) return;
    this.#asked = asked;
    this.belonging = null;
    this.#ask({ revision: this.#revision, input, number });
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
    worker.addEventListener("message", ({ data }) => this.#hear(data));
    worker.addEventListener("error", () => this.#hear({ lost: true, broken: true }));
    try {
      const wasm = await compiledWasm();
      if (worker !== this.#worker) return;
      // A worker knows nothing of the linkage that another one broke at: what is asked of it waits for the map.
      const question = this.#next && "state" in this.#next ? this.#next : { revision: this.#revision, state: this.#state };
      if (question === this.#next) this.#next = null;
      worker.postMessage({ wasm, ...question });
    } catch {
      if (worker !== this.#worker) return;
      this.#next = null;
      this.#hear({ lost: true, broken: true });
    }
  }

  #end() {
    this.#worker?.terminate();
    this.#worker = null;
    this.#busy = true;
  }

  /** @param {{ revision?: number, map?: MotionsMap, belonging?: Belonging, lost?: boolean, broken?: boolean }} answer */
  #hear({ revision, map, belonging, lost, broken }) {
    const current = revision === this.#revision;
    if (map) {
      this.map = map;
      this.current = current;
    }
    if (belonging && current) this.belonging = belonging;
    if (current && (map || belonging)) this.lost = false;
    if (lost) {
      this.lost = true;
      if (current) this.map = null;
    }
    if (broken) {
      // What is asked next gets a worker of its own.
      this.#end();
      if (this.#next) this.#begin();
      this.#changed();
      return;
    }
    // While a length is dragged it rests twice as long as it worked: the page draws with the same processors.
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
