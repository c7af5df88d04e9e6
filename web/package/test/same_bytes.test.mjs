// The module writes the bytes that the program writes: hashes that tests/same_bytes keeps, of the operations that it has, too.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { extname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { after, test } from "node:test";
import * as strata from "../strata.js";
import "./shapes.mjs";

const here = fileURLToPath(new URL("../../../tests/same_bytes", import.meta.url)), data = fileURLToPath(new URL("../../../data", import.meta.url));
const hashes = JSON.parse(readFileSync(join(here, "hashes.json"), "utf8"));
const folder = mkdtempSync(join(tmpdir(), "strata-"));
after(() => rmSync(folder, { recursive: true }));
// The script that recorded the hashes makes the operands.
execFileSync("python3", ["-c", "import pathlib, sys; sys.path.insert(0, sys.argv[1]); import record; record.make_inputs(pathlib.Path(sys.argv[2]))", here, folder],
  { env: { ...process.env, PYTHONDONTWRITEBYTECODE: "1" } });

const read = (name, options) => {
  const path = ["spot.obj", "gear.off", "bracket.off"].includes(name) ? join(data, name) : join(folder, name);
  return strata.read(readFileSync(path), extname(name).slice(1), options);
};
const both = (operation, ...names) => strata[operation](names.map((name) => read(name)));

const cases = {};
for (const operation of ["union", "intersection", "difference", "symmetricDifference"]) {
  const verb = operation === "symmetricDifference" ? "symmetric-difference" : operation;
  cases[`${verb} balls`] = ["off", () => both(operation, "a.off", "b.off")];
  cases[`${verb} cubes that touch`] = ["xoff", () => both(operation, "cube.off", "beside.off")];
}
cases["spot and gear, stl"] = ["stl", () => both("difference", "spot.obj", "gear.off")];
cases["spot and gear, ply"] = ["ply", () => both("difference", "spot.obj", "gear.off")];
cases["spot and gear, obj"] = ["obj", () => both("intersection", "spot.obj", "gear.off")];
cases["three, exact"] = ["xoff", () => both("union", "a.off", "b.off", "cube.off")];
cases["eval"] = ["off", () => strata.evaluate("(a - b) & c", { a: read("a.off"), b: read("b.off"), c: read("cube.off") })];
cases["eval model"] = ["xoff", () => strata.parseCsg(readFileSync(join(folder, "model.csg"), "utf8"))];
cases["hull"] = ["off", () => strata.convexHull(read("spot.obj").toMesh().vertices)];
cases["minkowski"] = ["xoff", () => read("bracket.off").minkowskiSum(read("cube.off"))];
cases["minkowski of gear"] = ["off", () => read("gear.off").minkowskiSum(read("cube.off"))];

for (const [name, [format, compute]] of Object.entries(cases))
  test(`same bytes as natively: ${name}`, () => {
    const found = createHash("sha256").update(strata.write(compute(), format)).digest("hex");
    assert.equal(found, hashes[name][`OUT.${format}`]);
  });
