// The other side of engine_client.js: a worker that keeps the solids of the workbench by name, and answers with what is shown of them.
import * as strata from "../package/strata.js";
import { recordOf } from "../package/errors.js";

const operands = new Map();
const state = { result: null };

function forget(solids) {
  for (const solid of solids) solid?.delete();
}

/** Larger solids are drawn without edges, which take longer to find than many a result. */
const mostTrianglesWithEdges = 300_000;

const noEdges = () => ({ vertices: new Float64Array(), edges: new Uint32Array() });

/** Arrays to draw a solid, and what is said of it. */
function shown(solid) {
  const { vertices, triangles } = solid.toMesh();
  const edges = triangles.length <= 3 * mostTrianglesWithEdges ? solid.edges() : noEdges();
  const [numerator, denominator] = solid.exactVolume();
  return {
    vertices, triangles, edges,
    exactVolume: denominator === 1n ? `${numerator}` : `${numerator}/${denominator}`,
    volume: solid.volume(), area: solid.area(), notes: solid.notes,
  };
}

function solidOf({ format, data, input }, onProgress) {
  if (format === "csg") return strata.parseCsg(new TextDecoder().decode(data), { onProgress });
  return strata.read(data, format, { input, onProgress });
}

/** An operand, or the result where there is no name. */
const named = (name) => (name === "" ? state.result : operands.get(name));

/** A mesh that is no solid: it is drawn all the same, with its defects. */
function refused(request, error) {
  if (!(error instanceof strata.InputError) || request.format === "csg") throw error;
  const { vertices, triangles } = strata.readMesh(request.data, request.format);
  return { vertices, triangles, edges: noEdges(), defects: error.defects };
}

const works = {
  start: ({ module }) => strata.init(module),

  add(request, onProgress) {
    forget([operands.get(request.name)]);
    operands.delete(request.name);
    try {
      const solid = solidOf(request, onProgress);
      operands.set(request.name, solid);
      return shown(solid);
    } catch (error) {
      return refused(request, error);
    }
  },

  remove({ name }) {
    forget([operands.get(name)]);
    operands.delete(name);
  },

  evaluate({ expression }, onProgress) {
    const began = performance.now();
    const result = strata.evaluate(expression, Object.fromEntries(operands), { onProgress });
    const seconds = (performance.now() - began) / 1000;
    forget([state.result]);
    state.result = result;
    return { ...shown(result), seconds };
  },

  pieces() {
    const pieces = state.result.convexPieces();
    try {
      return pieces.map(shown);
    } finally {
      forget(pieces);
    }
  },

  layers: ({ names, origin }, onProgress) => strata.layers(names.map(named), { origin, onProgress }),

  contacts: ({ names }, onProgress) => strata.contacts(names.map(named), { onProgress }),

  save: ({ format }) => strata.write(state.result, format),
};

addEventListener("message", async ({ data: request }) => {
  const { id } = request;
  try {
    postMessage({ id, result: await works[request.work](request, (fraction) => postMessage({ id, fraction })) });
  } catch (error) {
    postMessage({ id, error: recordOf(error) });
  }
});
