#include "core/csg/plane_rectangle.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace strata {

std::size_t main_axis(const Plane& plane) {
  std::size_t axis = 0;
  for (const std::size_t i : {1U, 2U})
    if (abs(plane.normal[i]) > abs(plane.normal[axis])) axis = i;
  if (plane.normal[axis] == 0) throw std::invalid_argument("the normal of a plane is zero");
  return axis;
}

double finite_sum(double a, double b) {
  const double result = a + b;
  if (!std::isfinite(result)) throw std::overflow_error("a box is too large to be cut by a plane: beyond all doubles");
  return result;
}

double reach_of(const BoundingBox& box) {
  double reach = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double farthest = std::max(std::abs(box.lower[i]), std::abs(box.upper[i]));
    reach = std::max({reach, finite_sum(box.upper[i], -box.lower[i]), farthest * 0x1p-20});
  }
  return reach > 0 ? reach : 1;
}

ExactMesh rectangle_in(const Plane& plane, std::size_t axis, const BoundingBox& box) {
  const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
  const double reach = reach_of(box);
  ExactMesh rectangle;
  for (std::uint32_t corner = 0; corner < 4; ++corner) {
    RationalPoint p;
    p[u] = corner == 0 || corner == 3 ? finite_sum(box.lower[u], -reach) : finite_sum(box.upper[u], reach);
    p[v] = corner < 2 ? finite_sum(box.lower[v], -reach) : finite_sum(box.upper[v], reach);
    p[axis] = (plane.offset - plane.normal[u] * p[u] - plane.normal[v] * p[v]) / plane.normal[axis];
    Vertex rounded{};
    for (std::size_t i = 0; i < 3; ++i) rounded[i] = finite_sum(to_nearest_double(p[i]), 0);
    if (to_rational(rounded[axis]) != p[axis]) rectangle.exact.push_back({corner, std::move(p)});
    rectangle.mesh.vertices.push_back(rounded);
  }
  rectangle.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return rectangle;
}

}  // namespace strata
