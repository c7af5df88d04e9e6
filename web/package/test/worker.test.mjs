import assert from "node:assert/strict";
import { test } from "node:test";
import { ExpressionError, InputError } from "../strata.js";
import { StrataWorker } from "../worker-client.js";
import { ballArrays, boxArrays } from "./shapes.mjs";

test("a worker evaluates expressions, with progress", async () => {
  const worker = new StrataWorker(), seen = [];
  const a = boxArrays([0, 0, 0], [2, 2, 2]), b = boxArrays([1, 1, 1], [3, 3, 3]);
  const result = await worker.evaluate("a - b", { a, b }, { onProgress: (fraction) => seen.push(fraction) });
  assert.deepEqual(result.exactVolume, [7n, 1n]);
  assert.ok(result.triangles instanceof Uint32Array && result.vertices instanceof Float64Array);
  assert.ok(seen.length > 0);
  const both = await Promise.all([worker.evaluate("a | b", { a, b }), worker.evaluate("a & b", { a, b })]);
  assert.deepEqual(both.map((one) => one.exactVolume[0]), [15n, 1n]);
  await worker.terminate();
});

test("errors of a worker are those of the engine", async () => {
  const worker = new StrataWorker(), { vertices, triangles } = boxArrays([0, 0, 0], [1, 1, 1]);
  await assert.rejects(worker.evaluate("a", { a: { vertices, triangles: triangles.slice(3) } }), (error) => error instanceof InputError && error.defects.length > 0);
  await assert.rejects(worker.evaluate("a b", { a: { vertices, triangles } }), ExpressionError);
  assert.deepEqual((await worker.parseCsg("cube(size = [1, 1, 1], center = false);")).exactVolume, [1n, 1n]);
  await worker.terminate();
});

test("a signal ends the work at once, and the next request is answered", async () => {
  const worker = new StrataWorker(), a = ballArrays(300), b = ballArrays(300, [0.3, 0.2, 0.1]), controller = new AbortController();
  const begin = performance.now();
  const work = worker.evaluate("a - b", { a, b }, { signal: controller.signal });
  setTimeout(() => controller.abort(), 100);
  await assert.rejects(work, { name: "AbortError" });
  assert.ok(performance.now() - begin < 2000);
  const small = boxArrays([0, 0, 0], [1, 1, 1]);
  assert.deepEqual((await worker.evaluate("a", { a: small })).exactVolume, [1n, 1n]);
  await assert.rejects(worker.evaluate("a", { a: small }, { signal: AbortSignal.abort() }), { name: "AbortError" });
  await worker.terminate();
});
