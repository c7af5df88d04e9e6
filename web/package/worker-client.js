// Work in a thread of its own, from arrays to arrays. See worker-client.d.ts.
import { errorOf } from "./errors.js";

async function spawn() {
  const url = new URL("worker.js", import.meta.url);
  const thread = { onMessage() {}, onError() {} };
  if (globalThis.Worker !== undefined) {
    const worker = new Worker(url, { type: "module" });
    worker.onmessage = (event) => thread.onMessage(event.data);
    worker.onerror = (event) => thread.onError(new Error(event.message ?? "the worker cannot be loaded"));
    thread.post = (message) => worker.postMessage(message);
    thread.end = () => worker.terminate();
    return thread;
  }
  const { Worker: Thread } = await import("node:worker_threads");
  const worker = new Thread(url);
  worker.unref();  // an idle worker does not keep the program running
  worker.on("message", (message) => {
    if (!("fraction" in message)) worker.unref();
    thread.onMessage(message);
  });
  worker.on("error", (error) => thread.onError(error));
  thread.post = (message) => {
    worker.ref();
    worker.postMessage(message);
  };
  thread.end = () => worker.terminate();
  return thread;
}

export class StrataWorker {
  #source;
  #thread = null;
  #last = 0;
  #queue = Promise.resolve();

  constructor({ source } = {}) {
    this.#source = source;
  }

  evaluate(expression, operands, options) {
    return this.#request({ work: "evaluate", expression, operands }, options);
  }
  parseCsg(source, options) {
    return this.#request({ work: "parseCsg", source }, options);
  }
  read(data, format, options) {
    return this.#request({ work: "read", data, format }, options);
  }

  terminate() {
    const ended = this.#thread;
    this.#thread = null;
    return ended?.then((thread) => thread.end());
  }

  /** One request at a time: others wait. */
  #request(request, options) {
    const result = this.#queue.then(() => this.#answer(request, options));
    this.#queue = result.catch(() => {});
    return result;
  }

  async #answer(request, { onProgress, signal, input = "automatic" } = {}) {
    signal?.throwIfAborted();
    const thread = await (this.#thread ??= spawn());
    const id = ++this.#last;
    return new Promise((resolve, reject) => {
      // The engine does not return to the worker's loop of events before it is done, so the worker goes.
      const abort = () => {
        this.terminate();
        reject(signal.reason);
      };
      signal?.addEventListener("abort", abort);
      const settle = (how, value) => {
        signal?.removeEventListener("abort", abort);
        how(value);
      };
      thread.onMessage = (message) => {
        if (message.id !== id) return;
        if ("fraction" in message) onProgress?.(message.fraction);
        else if ("error" in message) settle(reject, errorOf(message.error));
        else settle(resolve, message.result);
      };
      thread.onError = (error) => {
        this.terminate();
        settle(reject, error);
      };
      thread.post({ ...request, id, input, module: this.#source });
    });
  }
}
