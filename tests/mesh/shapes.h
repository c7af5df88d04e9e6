#pragma once
#include <cmath>
#include <cstdint>
#include <utility>

#include "strata/mesh.h"
#include "support/append.h"

namespace strata::shapes {

/// The box between two corners: 8 vertices, 12 triangles, outward.
inline Mesh box(const Vertex& lower, const Vertex& upper) {
  Mesh mesh;
  for (unsigned i = 0; i < 8; ++i) {
    mesh.vertices.push_back({(i & 1 ? upper : lower)[0], (i & 2 ? upper : lower)[1], (i & 4 ? upper : lower)[2]});
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

/// Two meshes as one list, nothing welded.
inline Mesh joined(Mesh a, const Mesh& b) {
  test::append(a, b);
  return a;
}

/// Every corner of every triangle as a vertex of its own.
inline Mesh shattered(const Mesh& mesh) {
  Mesh result;
  for (const Triangle& t : mesh.triangles) {
    const auto n = static_cast<std::uint32_t>(result.vertices.size());
    for (const std::uint32_t v : t) result.vertices.push_back(mesh.vertices[v]);
    result.triangles.push_back({n, n + 1, n + 2});
  }
  return result;
}

inline Mesh flipped(Mesh mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

inline Mesh scaled(Mesh mesh, double factor) {
  for (Vertex& v : mesh.vertices) v = {v[0] * factor, v[1] * factor, v[2] * factor};
  return mesh;
}

inline Mesh moved(Mesh mesh, const Vertex& by) {
  for (Vertex& v : mesh.vertices) v = {v[0] + by[0], v[1] + by[1], v[2] + by[2]};
  return mesh;
}

/// A closed sphere-like surface of 2 n (n - 1) triangles with arbitrary doubles as coordinates.
inline Mesh globe(std::uint32_t n, double radius = 1) {
  Mesh mesh;
  const double pi = 3.14159265358979;
  mesh.vertices.push_back({0, 0, -radius});
  for (std::uint32_t i = 1; i < n; ++i) {
    for (std::uint32_t j = 0; j < n; ++j) {
      const double theta = pi * i / n, phi = 2 * pi * j / n;
      mesh.vertices.push_back({radius * std::sin(theta) * std::cos(phi), radius * std::sin(theta) * std::sin(phi),
                               -radius * std::cos(theta)});
    }
  }
  mesh.vertices.push_back({0, 0, radius});
  const auto at = [n](std::uint32_t i, std::uint32_t j) { return 1 + (i - 1) * n + j % n; };
  const auto top = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
  for (std::uint32_t j = 0; j < n; ++j) {
    mesh.triangles.push_back({0, at(1, j + 1), at(1, j)});
    for (std::uint32_t i = 1; i + 1 < n; ++i) {
      mesh.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
    }
    mesh.triangles.push_back({at(n - 1, j), at(n - 1, j + 1), top});
  }
  return mesh;
}

/// The tetrahedron over the origin and the unit points.
inline Mesh corner_tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

}  // namespace strata::shapes
