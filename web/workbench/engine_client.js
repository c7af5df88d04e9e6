// The engine, in a worker that is made of a text: a page that was opened from a disk may load no other files.
import { errorOf } from "../package/errors.js";

export class Stopped extends Error {}

export class Engine {
  #source;
  #module;
  #worker = null;
  #last = 0;
  #waiting = new Map();

  /** `source`: the worker's program; `module`: the bytes of the WebAssembly module. */
  constructor(source, module) {
    this.#source = URL.createObjectURL(new Blob([source], { type: "text/javascript" }));
    this.#module = module;
  }

  /** Starts a worker that knows no solid yet. */
  async start() {
    this.#worker = new Worker(this.#source);
    this.#worker.onmessage = ({ data }) => this.#hear(data);
    this.#worker.onerror = (event) => this.stop(new Error(event.message ?? "the engine cannot be started"));
    await this.ask("start", { module: this.#module });
  }

  /** Ends the worker, whatever it does, and all that waits for it. */
  stop(reason = new Stopped()) {
    this.#worker?.terminate();
    this.#worker = null;
    for (const { reject } of this.#waiting.values()) reject(reason);
    this.#waiting.clear();
  }

  ask(work, request = {}, onProgress) {
    const id = ++this.#last;
    return new Promise((resolve, reject) => {
      this.#waiting.set(id, { resolve, reject, onProgress });
      this.#worker.postMessage({ ...request, id, work });
    });
  }

  #hear({ id, fraction, error, result }) {
    const { resolve, reject, onProgress } = this.#waiting.get(id);
    if (fraction !== undefined) return onProgress?.(fraction);
    this.#waiting.delete(id);
    return error ? reject(errorOf(error)) : resolve(result);
  }
}
