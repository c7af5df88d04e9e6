import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import * as strata from "../strata.js";
import { box, tetrahedron } from "./shapes.mjs";

const bytes = (text) => new TextEncoder().encode(text);
const data = (name) => readFile(new URL(`../../../data/${name}`, import.meta.url));

test("formats keep solids, and XOFF keeps rational vertices", () => {
  const solid = box([0, 0, 0], [1, 1, 1]).difference(box([0.5, 0.5, 0.5], [2, 2, 2]));
  for (const format of ["stl", "stl-ascii", "obj", "off", "xoff", "ply", "ply-ascii", "ply-big-endian", "3mf", "glb", "gltf"])
    assert.ok(strata.read(strata.write(solid, format), format).equals(solid), format);
  const corner = tetrahedron(), thirds = corner.difference(corner.translated([0.1, 0.2, 0.3]));
  assert.ok(strata.read(strata.write(thirds, "xoff"), "xoff").equals(thirds));
});

test("files of the repository are read: ArrayBuffer, Uint8Array, and with notes", async () => {
  const spot = await data("spot.obj"), gear = await data("gear.off");
  const copy = spot.buffer.slice(spot.byteOffset, spot.byteOffset + spot.byteLength);
  const cut = strata.read(copy, "obj").difference(strata.read(gear, "off"));
  assert.ok(cut.volume() > 0 && cut.toMesh().triangles.length > 3000);
  const mesh = strata.readMesh(gear, "off");
  assert.equal(mesh.triangles.length % 3, 0);
  assert.deepEqual(strata.check(mesh.vertices, mesh.triangles), []);
});

test("malformed files are errors with a place", () => {
  assert.throws(() => strata.read(bytes("OFF\n1 0 0\n0 0 x\n"), "off"), (error) => error instanceof strata.FileError && error.line === 3);
  assert.throws(() => strata.read(bytes(""), "stl"), strata.FileError);
  assert.throws(() => strata.read(bytes("PK\x03\x04 no archive"), "3mf"), strata.FileError);
  assert.throws(() => strata.read(bytes("x"), "step"), strata.ArgumentError);
  assert.throws(() => strata.write(box([0, 0, 0], [1, 1, 1]), "amf"), strata.FileError);
});

test("convex pieces carry what the whole does", () => {
  const corners = ["0 0 0", "4 0 0", "0 4 0", "0 0 4"].map((place) => `${place} 250 20 30`).join("\n");
  const painted = strata.read(bytes(`ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z
property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 4\nproperty list uchar int vertex_indices\nend_header
${corners}\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n`), "ply");
  const pieces = painted.difference(tetrahedron().translated([1, 1, 1])).convexPieces();
  assert.ok(pieces.length > 1);
  for (const piece of pieces) assert.match(new TextDecoder().decode(strata.write(piece, "ply-ascii")), /color[^]* 250 20 30/);
});

test("models of OpenSCAD are parsed", () => {
  const model = strata.parseCsg(`difference() {
    cube(size = [4, 3, 2], center = false);
    multmatrix([[1, 0, 0, 1], [0, 1, 0, 1], [0, 0, 1, 1], [0, 0, 0, 1]]) cube(size = [1, 1, 1], center = false);
  }`);
  assert.deepEqual(model.exactVolume(), [23n, 1n]);
  assert.throws(() => strata.parseCsg("cube(size = [1, 1, 1], center = false);\nfrobnicate() { sphere(r = 1); }"),
    (error) => error instanceof strata.ModelError && error.line === 2);
});
