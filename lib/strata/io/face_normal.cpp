#include "strata/io/face_normal.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace strata::io {
namespace {

double squared_length(const Vertex& n) { return n[0] * n[0] + n[1] * n[1] + n[2] * n[2]; }

Vertex cross(const Vertex& u, const Vertex& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

Vertex difference(const Vertex& a, const Vertex& b) { return {b[0] - a[0], b[1] - a[1], b[2] - a[2]}; }

/// b - a, scaled to a largest component of 1. Halves first, so that nothing overflows.
Vertex scaled_difference(const Vertex& a, const Vertex& b) {
  Vertex d{};
  for (std::size_t i = 0; i < 3; ++i) d[i] = 0.5 * b[i] - 0.5 * a[i];
  const double largest = std::max({std::abs(d[0]), std::abs(d[1]), std::abs(d[2])});
  for (double& x : d) x = largest > 0 ? x / largest : 0;
  return d;
}

}  // namespace

std::array<float, 3> face_normal(MeshView mesh, const Triangle& triangle) {
  const auto [a, b, c] = std::tie(mesh.vertices[triangle[0]], mesh.vertices[triangle[1]], mesh.vertices[triangle[2]]);
  Vertex n = cross(difference(a, b), difference(a, c));
  double square = squared_length(n);
  // Where squares come near the ends of the range, they lose digits or overflow.
  if (!(square > 1e-200 && square < 1e200)) {
    n = cross(scaled_difference(a, b), scaled_difference(a, c));
    square = squared_length(n);
  }
  if (!(square > 0)) return {};
  const double scale = 1 / std::sqrt(square);
  // Adding 0 writes -0 as 0.
  const auto unit = [&](double x) { return static_cast<float>(x * scale) + 0.0F; };
  return {unit(n[0]), unit(n[1]), unit(n[2])};
}

}  // namespace strata::io
