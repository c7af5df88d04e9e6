// The WebAssembly module: loading, memory, calls. Internal.
import { errorOf } from "./errors.js";

let exports = null;
let loading = null;
let progress = null;

const ENOSYS = 52, EBADF = 8;

/** The little of WASI that the C library asks for: a clock, random numbers, a console. There are no files. */
function wasi() {
  const view = () => new DataView(exports.memory.buffer);
  const lines = ["", "", ""];
  const known = {
    clock_time_get(_clock, _precision, at) {
      view().setBigUint64(at, BigInt(Math.round(performance.now() * 1e6)), true);
      return 0;
    },
    random_get(at, size) {
      crypto.getRandomValues(new Uint8Array(exports.memory.buffer, at, size));
      return 0;
    },
    environ_sizes_get(count, size) {
      view().setUint32(count, 0, true);
      view().setUint32(size, 0, true);
      return 0;
    },
    environ_get: () => 0,
    fd_prestat_get: () => EBADF,
    fd_close: () => 0,
    fd_fdstat_get: () => EBADF,
    // Only what ends the module writes: the C++ library, before it aborts.
    fd_write(stream, parts, count, written) {
      let size = 0;
      for (let i = 0; i < count; ++i) {
        const at = view().getUint32(parts + 8 * i, true), length = view().getUint32(parts + 8 * i + 4, true);
        lines[stream] += new TextDecoder().decode(new Uint8Array(exports.memory.buffer, at, length));
        size += length;
      }
      if (lines[stream].endsWith("\n")) {
        console.error(lines[stream].trimEnd());
        lines[stream] = "";
      }
      view().setUint32(written, size, true);
      return 0;
    },
    proc_exit(code) {
      throw new Error(`the engine ended with code ${code}`);
    },
  };
  return new Proxy(known, { get: (object, name) => object[name] ?? (() => ENOSYS) });
}

async function bytesOf(source) {
  if (source instanceof ArrayBuffer || ArrayBuffer.isView(source)) return source;
  if (source instanceof URL && source.protocol === "file:") {
    const { readFile } = await import("node:fs/promises");
    return readFile(source);
  }
  const answer = source instanceof Response ? source : await fetch(source);
  if (!answer.ok) throw new Error(`cannot load ${answer.url}: ${answer.status}`);
  return answer.arrayBuffer();
}

async function load(source) {
  const module = source instanceof WebAssembly.Module ? source : await WebAssembly.compile(await bytesOf(source));
  const imports = { wasi_snapshot_preview1: wasi(), strata: { progress: (fraction) => progress?.(fraction) } };
  // Not every engine takes a Proxy for imports.
  const asked = {};
  for (const { module: from, name } of WebAssembly.Module.imports(module)) (asked[from] ??= {})[name] = imports[from][name];
  const instance = await WebAssembly.instantiate(module, asked);
  exports = instance.exports;
  exports._initialize?.();
}

export function init(source = new URL("strata.wasm", import.meta.url)) {
  loading ??= load(source).catch((error) => {
    loading = null;
    throw error;
  });
  return loading;
}

/** Sets what is called with fractions from 0 to 1; returns what was set before. */
export function watch(callback) {
  const before = progress;
  progress = callback ?? null;
  return before;
}

function module() {
  if (exports === null) throw new Error("call `await init()` first");
  return exports;
}

const encoder = new TextEncoder(), decoder = new TextDecoder();

const views = { Float64Array, Uint32Array, Uint8Array };
const copied = (kind, pointer, size) => views[kind].from(new views[kind](exports.memory.buffer, pointer >>> 0, size));

/** What the last call answered. */
export const bytes = () => copied("Uint8Array", exports.strata_bytes(), exports.strata_bytes_size());
export const text = () => decoder.decode(bytes());
export const reals = () => copied("Float64Array", exports.strata_reals(), exports.strata_reals_size());
export const ints = () => copied("Uint32Array", exports.strata_ints(), exports.strata_ints_size());

/**
 * Calls a function. Typed arrays and strings are copied into the module, as a pointer; behind bytes and strings comes
 * their size.
 */
export function call(name, ...values) {
  const { memory, ["strata_" + name]: call, strata_allocate, strata_release, strata_error, strata_error_size } = module();
  const pointers = [];
  const inserted = (array) => {
    const pointer = strata_allocate(array.byteLength || 1) >>> 0;
    if (pointer === 0) throw errorOf({ kind: "memory", message: "out of memory" });
    pointers.push(pointer);
    new Uint8Array(memory.buffer, pointer, array.byteLength).set(
      new Uint8Array(array.buffer, array.byteOffset, array.byteLength));
    return pointer;
  };
  try {
    const given = values.flatMap((value) => {
      if (typeof value === "number") return [value];
      const array = typeof value === "string" ? encoder.encode(value) : value;
      return array instanceof Uint8Array ? [inserted(array), array.length] : [inserted(array)];
    });
    const result = call(...given) >>> 0;
    const size = strata_error_size();
    if (size > 0) throw errorOf(JSON.parse(decoder.decode(copied("Uint8Array", strata_error(), size))));
    return result;
  } finally {
    for (const pointer of pointers) strata_release(pointer);
  }
}

/** Bytes that the module has taken so far. */
export const memorySize = () => exports.memory.buffer.byteLength;

/** Whether the module is loaded. */
export const isLoaded = () => exports !== null;
