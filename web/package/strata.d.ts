/** Exact Booleans of solids given as triangle meshes.
 *
 * Coordinates are taken exactly as given: a double is the number that it stands for. There is no tolerance. Results keep exact vertices,
 * so they are exact operands in turn; `toMesh` rounds to nearest doubles. Results are, to the byte, those of Strata elsewhere. */

/** Loads the module; must be awaited before anything else. Without a source strata.wasm is loaded from beside the package's files. Calling it
 * again does nothing. */
export function init(source?: string | URL | Response | ArrayBuffer | ArrayBufferView | WebAssembly.Module): Promise<void>;

/** What is declared about meshes. automatic: closed; what crosses itself is resolved. solid: bounds a solid, which is not searched. overlapping:
 * may cross itself. repair: any triangles, welded and oriented. soup: any triangles, holes are filled. */
export type Input = "automatic" | "solid" | "overlapping" | "repair" | "soup";

/** "stl", "stl-ascii", "obj", "off", "xoff", "ply", "ply-ascii", "ply-big-endian", "3mf", "glb", "gltf", "amf" (read only), "vtk", "vtk-ascii", "msh"
 * (write only). XOFF keeps rational coordinates. */
export type Format = string;

export interface Defect {
  /** "open edge", "self-intersection" and so on. */
  kind: string;
  severity: "note" | "error";
  /** A point at the defect. */
  where: [number, number, number] | null;
  /** Numbers of triangles, from 0. */
  faces: number[];
  count: number;
  message: string;
  remedy: string;
}

export interface MeshArrays {
  /** x, y, z of each vertex. */
  vertices: Float64Array;
  /** Three vertices each, counter-clockwise as seen from outside. */
  triangles: Uint32Array;
  /** Per triangle the operand, and its face, of which it is a part. */
  sourceOperands: Uint32Array;
  sourceFaces: Uint32Array;
}

export interface Watching {
  /** Called with fractions from 0 to 1, never decreasing, within the call. What it throws ends the operation and is thrown by it. */
  onProgress?: (fraction: number) => void;
}

/** A bounded solid: immutable. Its memory is released by `delete()`, else some time after the object can no longer be reached. */
export class Solid {
  private constructor();
  /** Throws InputError with every defect where the mesh bounds no solid. Other arrays of numbers are copied into typed ones. */
  static fromMesh(vertices: Float64Array | readonly number[], triangles: Uint32Array | readonly number[], options?: { input?: Input } & Watching): Solid;

  /** What was resolved or left out when it was made. */
  readonly notes: readonly (Defect | string)[];

  /** Regularized Booleans of this solid and any number of others, in one arrangement. */
  union(...others: Solid[]): Solid;
  intersection(...others: Solid[]): Solid;
  /** The points of this solid that are in no other. */
  difference(...others: Solid[]): Solid;
  /** The points that are in an odd number of solids. */
  symmetricDifference(...others: Solid[]): Solid;

  /** Exact images. */
  translated(by: readonly [number, number, number]): Solid;
  scaled(factors: number | readonly [number, number, number]): Solid;
  /** By a 4 x 4 matrix, row after row, whose last row is a multiple of 0, 0, 0, 1. */
  transformed(matrix: ArrayLike<number>): Solid;

  /** Numerator and denominator, in lowest terms. */
  exactVolume(): [bigint, bigint];
  /** The double nearest to it. */
  volume(): number;
  /** Correct to a few units in the last place. */
  area(): number;
  /** Of the rounded mesh; infinities for the empty solid. */
  boundingBox(): { lower: number[]; upper: number[] };
  isEmpty(): boolean;
  /** Equal as point sets, exactly. */
  equals(other: Solid): boolean;
  /** 16 hexadecimal digits that are equal for equal solids, however they are triangulated. */
  canonicalHash(): string;

  /** Coordinates rounded to nearest doubles. */
  toMesh(): MeshArrays;

  /** The sides of maximal planar facets, each once: coordinates of their ends, rounded to nearest doubles, and two numbers of these ends each. */
  edges(): { vertices: Float64Array; edges: Uint32Array };

  /** The connected components of the interior. */
  components(): Solid[];
  /** Convex pieces with disjoint interiors, whose union is this solid. */
  convexPieces(): Solid[];
  minkowskiSum(other: Solid): Solid;

  /** Releases the memory. Using the solid afterwards is an error; deleting it twice is none. */
  delete(): void;
}

export function union(solids: Iterable<Solid>, options?: Watching): Solid;
export function intersection(solids: Iterable<Solid>, options?: Watching): Solid;
/** The first minus all others. */
export function difference(solids: Iterable<Solid>, options?: Watching): Solid;
export function symmetricDifference(solids: Iterable<Solid>, options?: Watching): Solid;

/** The value of `(a - b) & (c | d) ^ e`, evaluated at once: signs are | & - ^ ~, names are keys of `solids`. Throws ExpressionError. */
export function evaluate(expression: string, solids: Record<string, Solid>, options?: Watching): Solid;

/** The solid of a model in the .csg format that OpenSCAD writes. Throws ModelError. */
export function parseCsg(source: string, options?: Watching): Solid;

/** A file's solid. Throws FileError, InputError. */
export function read(data: ArrayBuffer | ArrayBufferView, format: Format, options?: { input?: Input } & Watching): Solid;
/** A file's mesh, which need not bound a solid. */
export function readMesh(data: ArrayBuffer | ArrayBufferView, format: Format): { vertices: Float64Array; triangles: Uint32Array; notes: string[] };
/** The bytes of a file. Throws FileError where the format cannot be written. */
export function write(solid: Solid, format: Format): Uint8Array;

/** Every defect of a mesh that is to bound a solid; none with severity "error" if it does. */
export function check(vertices: Float64Array | readonly number[], triangles: Uint32Array | readonly number[]): Defect[];

/** The convex hull of points; the empty solid if they are in one plane. */
export function convexHull(points: Float64Array | readonly number[]): Solid;

export interface Layer {
  /** The corners of all pieces, three each. */
  vertices: Float64Array;
  triangles: Uint32Array;
  /** Per piece the number of its solid. */
  solids: Uint32Array;
}

/** The faces of solids in layers as seen from an origin, along a direction, or from a point that is chosen: from the first layer, which has the faces
 * that nothing is behind of, to the last. Faces whose planes contain the origin are in no layer. */
export function layers(solids: Iterable<Solid>, options?: { origin?: readonly [number, number, number]; direction?: readonly [number, number, number] } & Watching): Layer[];

export interface Contact {
  /** Numbers of two solids, from 0, the lower one first. */
  a: number;
  b: number;
  /** Their boundaries meet, or their interiors do. */
  relation: "contact" | "interfering";
  /** Where they touch: the area of the contact, and its facets, which face away from the first one. */
  area?: number;
  vertices?: Float64Array;
  triangles?: Uint32Array;
}

/** Every pair of solids that are not apart. */
export function contacts(solids: Iterable<Solid>, options?: Watching): Contact[];

/** A Boolean of polygons, exactly: texts of WKT, GeoJSON ("geojson") or SVG ("svg"). */
export function combinePolygons(operation: "union" | "intersection" | "difference" | "symmetricDifference", a: string, b: string,
  options?: { format?: string; fill?: "nonzero" | "even-odd" | "positive" | "negative" }): string;

/** Of every error that the engine reports. */
export class StrataError extends Error {}
export class InputError extends StrataError {
  readonly defects: Defect[];
  readonly operand: number;
}
export class FileError extends StrataError {
  readonly line?: number;
  readonly byte?: number;
}
export class ModelError extends StrataError {
  readonly line: number;
  readonly column: number;
}
export class ExpressionError extends StrataError {
  /** In bytes, from 0. */
  readonly position: number;
}
export class ArgumentError extends StrataError {}
export class EngineFault extends StrataError {}
export class OutOfMemory extends StrataError {}
