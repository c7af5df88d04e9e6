// Solids as the arrays that the viewer draws (python/strata_csg/_viewer.js).

export const palette = [
  [122, 166, 216], [232, 161, 90], [127, 191, 123], [217, 128, 128], [169, 145, 204], [201, 180, 88], [111, 191, 191], [213, 143, 184],
];

/** Between two colours. */
export const mixed = (from, to, share) => from.map((x, i) => Math.round(x + share * (to[i] - x)));

/** The lower and the upper corner of many coordinates; nothing where there are none. */
function boxOf(arrays) {
  const lower = [Infinity, Infinity, Infinity], upper = [-Infinity, -Infinity, -Infinity];
  for (const vertices of arrays)
    for (let i = 0; i < vertices.length; ++i) {
      lower[i % 3] = Math.min(lower[i % 3], vertices[i]);
      upper[i % 3] = Math.max(upper[i % 3], vertices[i]);
    }
  return lower[0] <= upper[0] ? { lower, upper } : null;
}

const middleOf = ({ lower, upper }) => lower.map((x, i) => x / 2 + upper[i] / 2);

/** The middle of all parts, and half the diagonal of their box: places are relative to these, so that they fit floats. */
function frameOf(parts) {
  const box = boxOf(parts.map((part) => part.vertices));
  if (box === null) return { middle: [0, 0, 0], unit: 1 };
  const unit = Math.hypot(...box.upper.map((x, i) => x / 2 - box.lower[i] / 2));
  return { middle: middleOf(box), unit: unit > 0 && Number.isFinite(unit) ? unit : 1 };
}

/** Where a part goes when parts are pulled apart. */
function awayOf(vertices, { middle, unit }) {
  const box = boxOf([vertices]);
  return box === null ? [0, 0, 0] : middleOf(box).map((x, i) => (x - middle[i]) / unit);
}

/**
 * What `strataViewer` takes. A part has `vertices` and `triangles`, `edges` with `vertices` and `edges` of its own, and a `color`; one that `isMark` is
 * bright from all sides, and seen on faces that it lies in. `slider`:
 * "explode" pulls parts apart, "layers" shows the first ones, "one" does nothing.
 */
export function pictureOf(parts, slider) {
  const frame = frameOf(parts);
  const sizes = parts.map(({ vertices, triangles, edges }) => [(vertices.length + edges.vertices.length) / 3, triangles.length / 3, edges.edges.length / 2]);
  const total = [0, 1, 2].map((k) => sizes.reduce((sum, size) => sum + size[k], 0));
  const positions = new Float32Array(3 * total[0]), triangles = new Uint32Array(3 * total[1]), edges = new Uint32Array(2 * total[2]);
  const at = [0, 0, 0];
  const listed = parts.map((part, n) => {
    const placed = (vertices, first) => vertices.forEach((x, i) => (positions[3 * first + i] = (x - frame.middle[i % 3]) / frame.unit));
    const ends = at[0] + part.vertices.length / 3;
    placed(part.vertices, at[0]);
    placed(part.edges.vertices, ends);
    part.triangles.forEach((corner, i) => (triangles[3 * at[1] + i] = at[0] + corner));
    part.edges.edges.forEach((end, i) => (edges[2 * at[2] + i] = ends + end));
    sizes[n].forEach((size, k) => (at[k] += size));
    return { color: part.color, isMark: part.isMark === true, away: slider === "explode" ? awayOf(part.vertices, frame) : [0, 0, 0], ends: [...at] };
  });
  return { slider, frame, positions, triangles, edges, parts: listed };
}

/** Small octahedra at places, by which defects are pointed at. */
export function marks(places, size) {
  const corners = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]];
  const faces = [0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5];
  return {
    vertices: Float64Array.from(places.flatMap((place) => corners.flatMap((corner) => corner.map((x, i) => place[i] + size * x)))),
    triangles: Uint32Array.from(places.flatMap((_, n) => faces.map((corner) => 6 * n + corner))),
    edges: { vertices: new Float64Array(), edges: new Uint32Array() },
  };
}

/** A size for marks that is seen beside a mesh. */
export function markSize(vertices) {
  const box = boxOf([vertices]);
  return box === null ? 1 : 0.012 * Math.hypot(...box.upper.map((x, i) => x - box.lower[i])) || 1;
}
