// The workers of a search through nine points: one collects the results and gives out the work, the others follow
// paths.
import { fetched } from "assur/core/fetched.js";
import { compiledWasm } from "assur/core/wasm.js";

/**
 * @typedef {import("assur/types/web.js").PathWork} Work
 * @typedef {{
 *   progress?: import("assur/types/web.js").NinePointProgress, found?: readonly import("assur/types/web.js").FoundTracing[],
 *   ended?: boolean, problems?: readonly import("assur/core/problem.js").Problem[],
 * }} Said
 */

/** Greatest number of workers that follow paths; it is less on a device with fewer processors. */
const MOST = 8;

/** Paths that a worker follows before it reports. */
const CHUNK = 24;

const START = "assur/data/nine-points.bin";

export class NineWorkers {
  /** @type {Worker[]} */
  #workers = [];
  /** @type {Worker[]} workers without work */
  #idle = [];
  /** @type {Work[]} parts of the present work that no worker has yet */
  #parts = [];
  #say;
  #stopped = false;

  /**
   * @param {object} state of the path
   * @param {(said: Said) => void} say receives the state of the search whenever it changes
   */
  constructor(state, say) {
    this.#say = say;
    this.#begin(state).catch(() => this.#fail([{ code: "not_arrived" }]));
  }

  stop() {
    this.#stopped = true;
    for (const worker of this.#workers) worker.terminate();
  }

  /** @param {object} state */
  async #begin(state) {
    const [wasm, start] = await Promise.all([compiledWasm(), fetched(START, "application/octet-stream").then((response) => response.arrayBuffer())]);
    if (this.#stopped) return;
    const keeper = this.#worker(({ data }) => this.#kept(data));
    for (let k = 0; k < Math.min(MOST, navigator.hardwareConcurrency || 2); k++) {
      const tracker = this.#worker(({ data }) => {
        if (data.problems) this.#fail(data.problems);
        if (data.ends) keeper.postMessage({ ends: data.ends });
        this.#idle.push(tracker);
        this.#give();
      });
      tracker.postMessage({ wasm, state, start: new Uint8Array(start) });
    }
    keeper.postMessage({ wasm, state });
  }

  /** @param {(event: MessageEvent) => void} receive */
  #worker(receive) {
    const worker = new Worker(import.meta.resolve("assur/kinds/point-path/nine-worker.js"), { type: "module" });
    this.#workers.push(worker);
    worker.addEventListener("message", (event) => {
      if (!this.#stopped) receive(event);
    });
    worker.addEventListener("error", () => this.#fail([{ code: "not_arrived" }]));
    return worker;
  }

  /** @param {readonly import("assur/core/problem.js").Problem[]} problems */
  #fail(problems) {
    if (this.#stopped) return;
    this.stop();
    this.#say({ problems });
  }

  /** @param {Said & { work?: Work | null }} said message from the worker that collects the results */
  #kept({ progress, found, work, problems }) {
    if (problems) {
      this.#fail(problems);
      return;
    }
    if (work) {
      const { paths } = work;
      for (let k = 0; k < paths.length; k += CHUNK) this.#parts.push({ ...work, paths: paths.slice(k, k + CHUNK) });
    }
    // The search has ended if there is no further work and no path is being followed.
    const ended = !work && progress?.left === 0;
    this.#say({ progress, found, ended });
    if (!ended) this.#give();
  }

  /** Gives the remaining parts of the work to idle workers. */
  #give() {
    while (this.#idle.length > 0 && this.#parts.length > 0) this.#idle.pop()?.postMessage({ work: this.#parts.shift() });
  }
}
