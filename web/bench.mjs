#!/usr/bin/env node
// Times of the package against the command line on one thread, and against manifold-3d, if npm has installed it beside this file.
// Usage: tools/web bench [PROGRAM]; PROGRAM is the native command line, strata, of a release build.
//
// Operands are spheres of so many triangles each, the second one moved; arrays go in and arrays come out. Least of some runs.
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { gzipSync } from "node:zlib";
import * as strata from "./package/strata.js";
import { ballArrays } from "./package/test/shapes.mjs";

const program = process.argv[2], runs = 12;
const manifold = await import("manifold-3d").then(async ({ default: load }) => {
  const module = await load();
  module.setup();
  return module;
}, () => null);

function least(work) {
  let best = Infinity;
  for (let run = 0; run < runs; ++run) {
    const begin = performance.now();
    work();
    best = Math.min(best, performance.now() - begin);
  }
  return best;
}

/** Milliseconds of a union from arrays to arrays. */
function byStrata(a, b) {
  return least(() => {
    const first = strata.Solid.fromMesh(a.vertices, a.triangles), second = strata.Solid.fromMesh(b.vertices, b.triangles);
    const result = first.union(second);
    result.toMesh();
    for (const one of [first, second, result]) one.delete();
  });
}

function byManifold(a, b) {
  // Its coordinates are floats.
  const mesh = ({ vertices, triangles }) => new manifold.Mesh({ numProp: 3, vertProperties: Float32Array.from(vertices), triVerts: triangles });
  return least(() => {
    const first = manifold.Manifold.ofMesh(mesh(a)), second = manifold.Manifold.ofMesh(mesh(b)), result = first.add(second);
    result.getMesh();
    for (const one of [first, second, result]) one.delete();
  });
}

/** Milliseconds of the evaluation, checks of the operands included, as the report of the command line has it. */
function byProgram(a, b) {
  const folder = mkdtempSync(join(tmpdir(), "strata-"));
  try {
    for (const [name, { vertices, triangles }] of [["a.off", a], ["b.off", b]]) {
      const solid = strata.Solid.fromMesh(vertices, triangles);
      writeFileSync(join(folder, name), strata.write(solid, "off"));
      solid.delete();
    }
    let best = Infinity;
    for (let run = 0; run < runs; ++run) {
      execFileSync(program, ["union", "a.off", "b.off", "-o", "out.off", "-j", "1", "--report", "report.json", "-q"], { cwd: folder });
      best = Math.min(best, JSON.parse(readFileSync(join(folder, "report.json"), "utf8")).seconds.evaluate);
    }
    return 1000 * best;
  } finally {
    rmSync(folder, { recursive: true });
  }
}

const wasm = readFileSync(new URL("package/strata.wasm", import.meta.url));
console.log(`strata.wasm: ${wasm.length} bytes, ${gzipSync(wasm, { level: 9 }).length} compressed`);
for (const rings of [71, 159]) {
  const a = ballArrays(rings), b = ballArrays(rings, [0.3, 0.2, 0.1]);
  const row = { triangles: a.triangles.length / 3, "strata-csg": byStrata(a, b) };
  if (program) row["strata -j 1"] = byProgram(a, b);
  if (manifold) row["manifold-3d"] = byManifold(a, b);
  console.log(Object.entries(row).map(([name, value]) => `${name} ${name === "triangles" ? value : value.toFixed(0) + " ms"}`).join(", "));
}
