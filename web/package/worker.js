// The other side of StrataWorker: computes what it is sent.
import * as strata from "./strata.js";
import { recordOf } from "./errors.js";

const port = globalThis.postMessage ? globalThis : (await import("node:worker_threads")).parentPort;
const listen = (listener) =>
  port.addEventListener ? port.addEventListener("message", (event) => listener(event.data)) : port.on("message", listener);

/** Solids live for one request: what was made is deleted at its end, whatever happens. */
function answer({ work, operands, expression, source, format, data, input }, onProgress) {
  const made = [];
  const keep = (solid) => (made.push(solid), solid);
  try {
    let result;
    if (work === "parseCsg") result = keep(strata.parseCsg(source, { onProgress }));
    if (work === "read") result = keep(strata.read(data, format, { input, onProgress }));
    if (work === "evaluate") {
      const solids = {};
      for (const [name, { vertices, triangles }] of Object.entries(operands))
        solids[name] = keep(strata.Solid.fromMesh(vertices, triangles, { input }));
      result = keep(strata.evaluate(expression, solids, { onProgress }));
    }
    return { ...result.toMesh(), exactVolume: result.exactVolume(), volume: result.volume(), area: result.area(), notes: result.notes };
  } finally {
    for (const solid of made) solid.delete();
  }
}

listen(async (request) => {
  try {
    await strata.init(request.module);
    const result = answer(request, (fraction) => port.postMessage({ id: request.id, fraction }));
    const arrays = [result.vertices, result.triangles, result.sourceOperands, result.sourceFaces];
    port.postMessage({ id: request.id, result }, arrays.map((array) => array.buffer));
  } catch (error) {
    port.postMessage({ id: request.id, error: recordOf(error) });
  }
});
