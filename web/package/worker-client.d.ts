import type { Input, MeshArrays } from "./strata.js";

export interface WorkerOptions {
  /** Called with fractions from 0 to 1, never decreasing. */
  onProgress?: (fraction: number) => void;
  /** Ends the work: the promise is rejected with the signal's reason. The worker is terminated, at once and whatever it does; the next
   * request starts another one, which loads the module anew. */
  signal?: AbortSignal;
  input?: Input;
}

export interface WorkerResult extends MeshArrays {
  exactVolume: [bigint, bigint];
  volume: number;
  area: number;
  notes: unknown[];
}

/** The engine in a thread of its own: a web worker, or a worker thread of Node. From arrays to arrays; arrays that are given are copied.
 * Requests are answered one after the other. Errors are those of the engine. */
export class StrataWorker {
  /** `source`: where strata.wasm is, if not beside the package's files. */
  constructor(options?: { source?: string | ArrayBuffer });
  /** The value of `(a - b) & c`, evaluated at once. */
  evaluate(expression: string, operands: Record<string, { vertices: Float64Array; triangles: Uint32Array }>, options?: WorkerOptions): Promise<WorkerResult>;
  parseCsg(source: string, options?: WorkerOptions): Promise<WorkerResult>;
  read(data: ArrayBuffer | ArrayBufferView, format: string, options?: WorkerOptions): Promise<WorkerResult>;
  /** Ends the thread. A request that runs is never answered. */
  terminate(): Promise<unknown> | undefined;
}
