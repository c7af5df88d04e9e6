#include "strata/io/face_normal.h"

#include <algorithm>
#include <cmath>

namespace strata::io {
namespace {

/// b - a, scaled to a largest component of 1. Halves first, so that nothing overflows.
Vertex direction(const Vertex& a, const Vertex& b) {
  Vertex d{};
  for (std::size_t i = 0; i < 3; ++i) d[i] = 0.5 * b[i] - 0.5 * a[i];
  const double largest = std::max({std::abs(d[0]), std::abs(d[1]), std::abs(d[2])});
  for (double& x : d) x = largest > 0 ? x / largest : 0;
  return d;
}

}  // namespace

std::array<float, 3> face_normal(MeshView mesh, const Triangle& triangle) {
  const Vertex u = direction(mesh.vertices[triangle[0]], mesh.vertices[triangle[1]]);
  const Vertex v = direction(mesh.vertices[triangle[0]], mesh.vertices[triangle[2]]);
  const Vertex n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  std::array<float, 3> unit{};
  // Adding 0 writes -0 as 0.
  if (length > 0)
    for (std::size_t i = 0; i < 3; ++i) unit[i] = static_cast<float>(n[i] / length) + 0.0F;
  return unit;
}

}  // namespace strata::io
