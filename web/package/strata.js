// Exact Booleans of solids. See strata.d.ts for what each function takes, returns and throws.
import { bytes, call, init, ints, isLoaded, reals, text, watch } from "./module.js";

export { init };
export {
  ArgumentError, EngineFault, ExpressionError, FileError, InputError, ModelError, OutOfMemory, StrataError,
} from "./errors.js";

const operations = ["union", "intersection", "difference", "symmetricDifference"];
const inputs = ["automatic", "solid", "overlapping", "repair", "soup"];
const fills = ["even-odd", "nonzero", "positive", "negative"];

function indexIn(words, word, what) {
  const index = words.indexOf(word);
  if (index < 0) throw new TypeError(`${what} '${word}' is none of ${words.join(", ")}`);
  return index;
}

const forgotten = new FinalizationRegistry((handle) => {
  if (isLoaded()) call("delete", handle);
});

const handles = (solids) => Uint32Array.from(solids, (solid) => solid.handle());
const lines = (string) => string.split("\n").filter((line) => line !== "");
const adopted = (handle, notes) => new Solid(secret, handle, notes);
const allAdopted = () => Array.from(ints(), (handle) => adopted(handle));
const secret = Symbol("the constructor of Solid is private");

function arrays(vertices, triangles) {
  const coordinates = vertices instanceof Float64Array ? vertices : Float64Array.from(vertices);
  const corners = triangles instanceof Uint32Array ? triangles : Uint32Array.from(triangles);
  if (coordinates.length % 3 !== 0 || corners.length % 3 !== 0) throw new TypeError("arrays have three numbers each");
  return [coordinates, coordinates.length / 3, corners, corners.length / 3];
}

/** Runs with a callback of progress; what it throws ends the work and comes out. */
function watched(onProgress, work) {
  const before = watch(onProgress);
  try {
    return work();
  } finally {
    watch(before);
  }
}

function combined(operation, solids, { onProgress } = {}) {
  const list = handles(solids);
  return watched(onProgress, () => adopted(call("combine", operations.indexOf(operation), list, list.length)));
}

export class Solid {
  #handle;
  #notes;

  constructor(key, handle, notes = []) {
    if (key !== secret) throw new TypeError("use Solid.fromMesh");
    this.#handle = handle;
    this.#notes = notes;
    forgotten.register(this, handle, this);
  }

  static fromMesh(vertices, triangles, { input = "automatic", onProgress } = {}) {
    const kind = indexIn(inputs, input, "input");
    return watched(onProgress, () => {
      const handle = call("from_mesh", ...arrays(vertices, triangles), kind);
      return adopted(handle, JSON.parse(text()));
    });
  }

  /** Internal: the number by which the module knows the solid. */
  handle() {
    if (this.#handle === 0) throw new Error("the solid was deleted");
    return this.#handle;
  }

  get notes() {
    return this.#notes;
  }

  delete() {
    if (this.#handle === 0) return;
    forgotten.unregister(this);
    call("delete", this.#handle);
    this.#handle = 0;
  }

  union(...others) {
    return combined("union", [this, ...others]);
  }
  intersection(...others) {
    return combined("intersection", [this, ...others]);
  }
  difference(...others) {
    return combined("difference", [this, ...others]);
  }
  symmetricDifference(...others) {
    return combined("symmetricDifference", [this, ...others]);
  }

  translated([x, y, z]) {
    return adopted(call("translated", this.handle(), x, y, z));
  }
  scaled(factors) {
    const [x, y, z] = typeof factors === "number" ? [factors, factors, factors] : factors;
    return adopted(call("scaled", this.handle(), x, y, z));
  }
  transformed(matrix) {
    if (matrix.length !== 16) throw new TypeError("a matrix has 16 numbers, row after row");
    return adopted(call("transformed", this.handle(), Float64Array.from(matrix)));
  }

  exactVolume() {
    call("exact_volume", this.handle());
    return text().split("/").map(BigInt);
  }
  #measures() {
    call("measures", this.handle());
    return reals();
  }
  volume() {
    return this.#measures()[0];
  }
  area() {
    return this.#measures()[1];
  }
  boundingBox() {
    const numbers = Array.from(this.#measures());
    return { lower: numbers.slice(2, 5), upper: numbers.slice(5, 8) };
  }
  isEmpty() {
    return call("is_empty", this.handle()) === 1;
  }
  equals(other) {
    return call("equal", this.handle(), other.handle()) === 1;
  }
  canonicalHash() {
    call("canonical_hash", this.handle());
    return text();
  }

  toMesh() {
    const count = call("mesh", this.handle()), numbers = ints();
    return {
      vertices: reals(),
      triangles: numbers.slice(0, 3 * count),
      sourceOperands: numbers.slice(3 * count, 4 * count),
      sourceFaces: numbers.slice(4 * count),
    };
  }

  edges() {
    call("edges", this.handle());
    return { vertices: reals(), edges: ints() };
  }

  components() {
    call("components", this.handle());
    return allAdopted();
  }
  convexPieces() {
    call("decompose", this.handle());
    return allAdopted();
  }
  minkowskiSum(other) {
    return adopted(call("minkowski_sum", this.handle(), other.handle()));
  }
}
if (Symbol.dispose !== undefined) Solid.prototype[Symbol.dispose] = Solid.prototype.delete;

export const union = (solids, options) => combined("union", solids, options);
export const intersection = (solids, options) => combined("intersection", solids, options);
export const difference = (solids, options) => combined("difference", solids, options);
export const symmetricDifference = (solids, options) => combined("symmetricDifference", solids, options);

export function evaluate(expression, solids, { onProgress } = {}) {
  const names = Object.keys(solids), list = handles(Object.values(solids));
  return watched(onProgress, () => adopted(call("evaluate", expression, names.join("\n"), list, list.length)));
}

export function parseCsg(source, { onProgress } = {}) {
  return watched(onProgress, () => {
    const handle = call("parse_csg", source);
    return adopted(handle, lines(text()));
  });
}

const bytesOf = (data) => (data instanceof Uint8Array ? data : new Uint8Array(data.buffer ?? data, data.byteOffset ?? 0, data.byteLength));

export function read(data, format, { input = "automatic", onProgress } = {}) {
  const kind = indexIn(inputs, input, "input");
  return watched(onProgress, () => {
    const handle = call("read", bytesOf(data), format, kind);
    return adopted(handle, lines(text()));
  });
}

export function readMesh(data, format) {
  call("read_mesh", bytesOf(data), format);
  return { vertices: reals(), triangles: ints(), notes: lines(text()) };
}

export function write(solid, format) {
  call("write", solid.handle(), format);
  return bytes();
}

export function check(vertices, triangles) {
  call("check", ...arrays(vertices, triangles));
  return JSON.parse(text());
}

export function convexHull(points) {
  const [coordinates, count] = arrays(points, []);
  return adopted(call("hull", coordinates, count));
}

export function combinePolygons(operation, a, b, { format = "wkt", fill = "nonzero" } = {}) {
  call("planar", indexIn(operations, operation, "operation"), indexIn(fills, fill, "fill"), format, a, b);
  return text();
}

export function layers(solids, { origin, direction, onProgress } = {}) {
  if (origin && direction) throw new TypeError("give an origin or a direction");
  const list = handles(solids), [kind, at] = origin ? [0, origin] : direction ? [1, direction] : [2, [0, 0, 0]];
  return watched(onProgress, () => {
    const count = call("layers", list, list.length, kind, ...at), numbers = ints(), corners = reals();
    let first = 0;
    return Array.from(numbers.slice(0, count), (size) => {
      const solidsOfPieces = numbers.slice(count + first, count + first + size);
      const vertices = corners.slice(9 * first, 9 * (first + size));
      first += size;
      return { vertices, triangles: Uint32Array.from({ length: 3 * size }, (_, i) => i), solids: solidsOfPieces };
    });
  });
}

export function contacts(solids, { onProgress } = {}) {
  const list = handles(solids);
  return watched(onProgress, () => {
    const count = call("contacts", list, list.length), numbers = ints(), coordinates = reals();
    let next = 0, at = 0;
    const taken = (size) => numbers.slice(next, (next += size));
    return Array.from({ length: count }, () => {
      const [a, b, relation] = taken(3);
      if (relation === 2) return { a, b, relation: "interfering" };
      const [points, triangles] = taken(2), area = coordinates[at++];
      const vertices = coordinates.slice(at, (at += 3 * points));
      return { a, b, relation: "contact", area, vertices, triangles: taken(3 * triangles) };
    });
  });
}
