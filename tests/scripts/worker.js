// Workers of the page in Node: the thread with the functions that a worker's script needs, and the worker object on the page's side.
import { readFile } from "node:fs/promises";
import { Worker as Thread, isMainThread, parentPort, workerData } from "node:worker_threads";

if (!isMainThread) {
  globalThis.addEventListener = (_, listener) => parentPort.on("message", (data) => listener({ data }));
  globalThis.postMessage = (data, { transfer } = {}) => parentPort.postMessage(data, transfer);
  await import(workerData.script);
}

/** Stand-in for the worker of a browser. */
export class Worker extends EventTarget {
  /** @type {Set<Worker>} workers that have not been ended */
  static running = new Set();
  #thread;

  /** @param {string} script */
  constructor(script) {
    super();
    this.script = script;
    this.#thread = new Thread(new URL(import.meta.url), { workerData: { script } });
    this.#thread.on("message", (data) => this.#tell("message", { data }));
    this.#thread.on("error", ({ message }) => this.#tell("error", { message }));
    Worker.running.add(this);
  }

  postMessage(data, transfer) {
    this.#thread.postMessage(data, transfer);
  }

  terminate() {
    Worker.running.delete(this);
    return this.#thread.terminate();
  }

  #tell(type, more) {
    const event = Object.assign(new Event(type), more);
    this.dispatchEvent(event);
    this[`on${type}`]?.(event);
  }
}

/** Ends all running workers. */
export function endWorkers() {
  return Promise.all([...Worker.running].map((worker) => worker.terminate()));
}

/** Stand-in for `fetch` that reads files, all with the media type of wasm. */
export async function fetchFile(url) {
  return new Response(await readFile(new URL(url)), { headers: { "Content-Type": "application/wasm" } });
}
