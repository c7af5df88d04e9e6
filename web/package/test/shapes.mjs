// Meshes for tests.
import { init, Solid } from "../strata.js";

await init();

/** An axis-parallel box as arrays. */
export function boxArrays([x0, y0, z0], [x1, y1, z1]) {
  const vertices = new Float64Array(24);
  for (let k = 0; k < 8; ++k) vertices.set([k & 1 ? x1 : x0, k & 2 ? y1 : y0, k & 4 ? z1 : z0], 3 * k);
  const sides = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
  return { vertices, triangles: Uint32Array.from(sides.flatMap(([a, b, c, d]) => [a, b, c, a, c, d])) };
}

export function box(lower, upper) {
  const { vertices, triangles } = boxArrays(lower, upper);
  return Solid.fromMesh(vertices, triangles);
}

/** A tetrahedron with integer corners. */
export const tetrahedron = () =>
  Solid.fromMesh(new Float64Array([0, 0, 0, 4, 0, 0, 0, 4, 0, 0, 0, 4]), new Uint32Array([0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3]));

/** A ball of some 2 * rings^2 triangles. */
export function ballArrays(rings, [x, y, z] = [0, 0, 0]) {
  const columns = 2 * rings, points = [[0, 0, 1]], triangles = [];
  for (let i = 1; i < rings; ++i)
    for (let j = 0; j < columns; ++j) {
      const a = (Math.PI * i) / rings, b = (2 * Math.PI * j) / columns;
      points.push([Math.sin(a) * Math.cos(b), Math.sin(a) * Math.sin(b), Math.cos(a)]);
    }
  points.push([0, 0, -1]);
  const at = (i, j) => 1 + (i - 1) * columns + (j % columns), last = points.length - 1;
  for (let j = 0; j < columns; ++j) triangles.push(0, at(1, j), at(1, j + 1));
  for (let i = 1; i < rings - 1; ++i)
    for (let j = 0; j < columns; ++j)
      triangles.push(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1), at(i, j + 1));
  for (let j = 0; j < columns; ++j) triangles.push(last, at(rings - 1, j + 1), at(rings - 1, j));
  return {
    vertices: Float64Array.from(points.flatMap((p) => [p[0] + x, p[1] + y, p[2] + z])),
    triangles: Uint32Array.from(triangles),
  };
}
