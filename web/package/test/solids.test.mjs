import assert from "node:assert/strict";
import { test } from "node:test";
import { memorySize } from "../module.js";
import * as strata from "../strata.js";
import { ballArrays, box, boxArrays, tetrahedron } from "./shapes.mjs";

const { Solid } = strata;

test("volumes are pairs of integers, in lowest terms", () => {
  const corner = tetrahedron(), rest = corner.difference(corner.translated([1, 0, 0]));
  assert.deepEqual(corner.exactVolume(), [32n, 3n]);
  assert.deepEqual(rest.exactVolume(), [37n, 6n]);
  assert.equal(rest.volume(), 37 / 6);
});

test("the four operations obey inclusion and exclusion, exactly", () => {
  const a = box([0, 0, 0], [2, 2, 2]), b = tetrahedron().translated([0.1, 0.7, 1 / 3]);
  const sum = ([p, q], [r, s]) => [p * s + r * q, q * s], equal = ([p, q], [r, s]) => p * s === r * q;
  const v = (solid) => solid.exactVolume();
  assert.ok(equal(sum(v(a.union(b)), v(a.intersection(b))), sum(v(a), v(b))));
  assert.ok(equal(sum(v(a.difference(b)), v(b.difference(a))), v(a.symmetricDifference(b))));
  assert.ok(a.union(b).equals(strata.evaluate("a - b | b", { a, b })));
});

test("solids that touch are ordinary", () => {
  const a = box([0, 0, 0], [1, 1, 1]), b = box([1, 0, 0], [2, 1, 1]);
  assert.ok(a.intersection(b).isEmpty());
  assert.ok(a.union(b).equals(box([0, 0, 0], [2, 1, 1])));
  assert.equal(a.union(b).canonicalHash(), box([0, 0, 0], [2, 1, 1]).canonicalHash());
  assert.ok(a.difference(a).isEmpty());
  assert.equal(a.symmetricDifference(b).components().length, 1);
  assert.equal(a.union(b.translated([0, 1, 0])).components().length, 2);  // they touch in an edge
});

test("one ulp is a solid", () => {
  const a = box([0, 0, 0], [1, 1, 1]), b = box([0, 0, 0], [1, 1, 1 + Number.EPSILON]);
  assert.deepEqual(b.difference(a).exactVolume(), [1n, 2n ** 52n]);
});

test("n-ary functions take any number of solids", () => {
  const steps = [0, 1, 2, 3].map((i) => box([i, 0, 0], [i + 2, 1, 1]));
  assert.deepEqual(strata.union(steps).exactVolume(), [5n, 1n]);
  assert.ok(strata.union([]).isEmpty());
  assert.ok(strata.intersection(steps).isEmpty());
  assert.deepEqual(strata.difference(steps).exactVolume(), [1n, 1n]);
  assert.deepEqual(strata.symmetricDifference(steps.slice(0, 3)).exactVolume(), [2n, 1n]);
});

test("a mesh comes back with the source of each triangle", () => {
  const a = box([0, 0, 0], [1, 1, 1]), b = box([5, 0, 0], [6, 1, 1]), mesh = a.union(b).toMesh();
  assert.equal(mesh.vertices.length, 48);
  assert.equal(mesh.triangles.length, 72);
  assert.deepEqual([...mesh.sourceOperands], [...Array(12).fill(0), ...Array(12).fill(1)]);
  assert.deepEqual([...mesh.sourceFaces.slice(12)], [...Array(12).keys()]);
});

test("edges are those of maximal facets", () => {
  const count = (solid) => [solid.edges().vertices.length / 3, solid.edges().edges.length / 2];
  const a = box([0, 0, 0], [1, 1, 1]);
  assert.deepEqual(count(a), [8, 12]);
  assert.deepEqual(count(a.union(box([1, 0, 0], [2, 1, 1]))), [8, 12]);
  assert.deepEqual(count(a.union(box([1, 0, 0], [2, 0.5, 0.5]))), [14, 21]);
  assert.deepEqual(count(a.difference(a)), [0, 0]);
});

test("layers are the faces from back to front", () => {
  const far = box([0, 0, 0], [1, 1, 1]), near = box([0, 0, 2], [1, 1, 3]);
  const found = strata.layers([far, near], { direction: [0, 0, -1] });
  assert.deepEqual(found.map((layer) => layer.triangles.length / 3), [2, 2, 2, 2]);  // the sides are flat
  assert.deepEqual(found.map((layer) => [...layer.solids]), [[0, 0], [0, 0], [1, 1], [1, 1]]);
  assert.deepEqual(found.map((layer) => layer.vertices[2]), [0, 1, 2, 3]);
  assert.ok(strata.layers([far]).length >= 1);
  assert.throws(() => strata.layers([far], { origin: [0, 0, 0], direction: [0, 0, 1] }), TypeError);
  assert.throws(() => strata.layers([far], { direction: [0, 0, 0] }), strata.ArgumentError);
});

test("contacts are facets, or an overlap", () => {
  const parts = [box([0, 0, 0], [1, 1, 1]), box([1, 0, 0], [2, 0.5, 1]), box([0.5, 0.5, 0.5], [3, 3, 3]), box([9, 9, 9], [10, 10, 10])];
  const found = strata.contacts(parts);
  assert.deepEqual(found.map(({ a, b, relation }) => [a, b, relation]), [[0, 1, "contact"], [0, 2, "interfering"], [1, 2, "contact"]]);
  assert.equal(found[0].area, 0.5);
  assert.equal(found[0].triangles.length, 6);
  assert.ok(found[0].vertices.every((x, i) => i % 3 !== 0 || x === 1));
  assert.equal(found[1].area, undefined);
});

test("maps are exact", () => {
  const a = box([0, 0, 0], [1, 1, 1]);
  assert.deepEqual(a.scaled(0.1).exactVolume()[1], (2n ** 55n) ** 3n);  // 0.1 is a double, and its cube no decimal
  assert.deepEqual(a.scaled([2, 3, -4]).exactVolume(), [24n, 1n]);
  assert.deepEqual(a.transformed([1, 2, 0, 5, 0, 1, 0, 0, 0, 0, 3, 0, 0, 0, 0, 1]).exactVolume(), [3n, 1n]);
  assert.deepEqual(a.translated([1, 2, 3]).boundingBox(), { lower: [1, 2, 3], upper: [2, 3, 4] });
  assert.equal(a.area(), 6);
});

test("hulls, convex pieces and Minkowski sums", () => {
  const ell = box([0, 0, 0], [2, 1, 1]).union(box([0, 0, 0], [1, 2, 1]));
  const pieces = ell.convexPieces();
  assert.equal(pieces.length, 2);
  assert.ok(strata.union(pieces).equals(ell));
  assert.deepEqual(strata.convexHull(ell.toMesh().vertices).exactVolume(), [7n, 2n]);
  assert.ok(strata.convexHull([0, 0, 0, 1, 0, 0, 0, 1, 0]).isEmpty());
  assert.deepEqual(box([0, 0, 0], [1, 1, 1]).minkowskiSum(ell).exactVolume(), [16n, 1n]);
});

test("polygons are combined", () => {
  const square = "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))", other = "POLYGON ((1 0, 2 0, 2 1, 1 1, 1 0))";
  assert.match(strata.combinePolygons("union", square, other), /^POLYGON/);
  assert.match(strata.combinePolygons("intersection", square, other), /EMPTY/);
  assert.throws(() => strata.combinePolygons("union", square, "POLYGON ((0 0"), strata.FileError);
  assert.throws(() => strata.combinePolygons("sum", square, other), TypeError);
});

test("a mesh that is no solid is refused, with every defect", () => {
  const { vertices, triangles } = boxArrays([0, 0, 0], [1, 1, 1]);
  const open = triangles.slice(3);
  assert.throws(() => Solid.fromMesh(vertices, open), (error) => {
    assert.ok(error instanceof strata.InputError && error instanceof strata.StrataError);
    assert.equal(error.name, "InputError");
    assert.equal(error.operand, 0);
    assert.ok(error.defects.some((d) => d.kind === "open edge" && d.severity === "error" && d.where.length === 3));
    return true;
  });
  assert.deepEqual(Solid.fromMesh(vertices, open, { input: "soup" }).exactVolume(), [1n, 1n]);
  assert.ok(strata.check(vertices, open).length > 0);
  assert.deepEqual(strata.check(vertices, triangles), []);
});

test("nonsense is an error, and leaves the engine as it was", () => {
  const a = box([0, 0, 0], [1, 1, 1]);
  assert.throws(() => Solid.fromMesh([0, 0], []), TypeError);
  assert.throws(() => Solid.fromMesh([0, 0, NaN], [0, 0, 0]), strata.InputError);
  assert.throws(() => Solid.fromMesh([0, 0, 0], [0, 1, 2]), strata.InputError);
  assert.throws(() => Solid.fromMesh([], [], { input: "wish" }), TypeError);
  assert.throws(() => new Solid(), TypeError);
  assert.throws(() => a.scaled(0), strata.ArgumentError);
  assert.throws(() => strata.evaluate("a - ", { a }), strata.ExpressionError);
  assert.throws(() => strata.evaluate("a - b", { a }), (error) => error instanceof strata.ExpressionError && error.position === 4);
  assert.throws(() => strata.evaluate("~a", { a }), strata.ArgumentError);
  assert.ok(Solid.fromMesh([], []).isEmpty());
  assert.deepEqual(a.exactVolume(), [1n, 1n]);
});

test("deleted solids cannot be used, and deleting twice is nothing", () => {
  const a = box([0, 0, 0], [1, 1, 1]), b = a.union(a);
  a.delete();
  a.delete();
  assert.throws(() => a.volume(), /deleted/);
  assert.throws(() => b.union(a), /deleted/);
  assert.deepEqual(b.exactVolume(), [1n, 1n]);
});

test("memory is given back", () => {
  const { vertices, triangles } = ballArrays(60);
  const round = () => {
    const a = Solid.fromMesh(vertices, triangles), b = a.translated([0.3, 0.2, 0.1]), c = a.difference(b);
    for (const solid of [a, b, c]) solid.delete();
  };
  for (let i = 0; i < 5; ++i) round();
  const before = memorySize();
  for (let i = 0; i < 20; ++i) round();
  assert.equal(memorySize(), before);
});

test("progress rises to the end, and what it throws ends the operation", () => {
  const { vertices, triangles } = ballArrays(40), a = Solid.fromMesh(vertices, triangles), b = a.translated([0.3, 0.2, 0.1]);
  const seen = [];
  strata.union([a, b], { onProgress: (fraction) => seen.push(fraction) });
  assert.ok(seen.length > 2);
  assert.deepEqual(seen, [...seen].sort((x, y) => x - y));
  class Enough extends Error {}
  assert.throws(() => strata.union([a, b], { onProgress: () => { throw new Enough(); } }), Enough);
  assert.ok(a.union(b).volume() > a.volume());
});
