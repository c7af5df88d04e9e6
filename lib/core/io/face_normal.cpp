#include "core/io/face_normal.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/exact/vector.h"

namespace strata::io {
namespace {

double squared_length(const Vertex& n) { return n[0] * n[0] + n[1] * n[1] + n[2] * n[2]; }

/// Half of b - a, which never overflows.
Vertex half_difference(const Vertex& a, const Vertex& b) {
  return {0.5 * b[0] - 0.5 * a[0], 0.5 * b[1] - 0.5 * a[1], 0.5 * b[2] - 0.5 * a[2]};
}

/// Scaled to a largest component of 1; 0 is unchanged.
Vertex scaled(const Vertex& v) {
  const double largest = std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
  if (largest == 0) return v;
  return {v[0] / largest, v[1] / largest, v[2] / largest};
}

}  // namespace

std::array<float, 3> face_normal(MeshView mesh, const Triangle& triangle) {
  const auto [a, b, c] = std::tie(mesh.vertices[triangle[0]], mesh.vertices[triangle[1]], mesh.vertices[triangle[2]]);
  Vertex n = cross(minus(b, a), minus(c, a));
  double square = squared_length(n);
  // If the square is a normal number, no step before it overflowed or lost significant digits.
  if (!std::isnormal(square)) {
    n = scaled(cross(scaled(half_difference(a, b)), scaled(half_difference(a, c))));
    square = squared_length(n);
  }
  if (!(square > 0)) return {};
  const double scale = 1 / std::sqrt(square);
  // Adding 0 writes -0 as 0.
  const auto unit = [&](double x) { return static_cast<float>(x * scale) + 0.0F; };
  return {unit(n[0]), unit(n[1]), unit(n[2])};
}

}  // namespace strata::io
