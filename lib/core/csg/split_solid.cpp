#include <algorithm>
#include <cmath>

#include "core/csg/plane_rectangle.h"
#include "core/csg/solid_data.h"

namespace strata {
namespace {

/// On which sides of a plane the vertices of a solid are.
struct Sides {
  bool behind = false, in_front = false;
};

Sides sides_of(const Solid& solid, const Plane& plane) {
  const ExactMesh& mesh = solid.exact_mesh();
  std::vector<bool> is_used(mesh.mesh.vertices.size(), false);
  for (const Triangle& t : mesh.mesh.triangles)
    for (const std::uint32_t v : t) is_used[v] = true;
  Sides sides;
  for (std::uint32_t v = 0; v < is_used.size() && !(sides.behind && sides.in_front); ++v) {
    if (!is_used[v]) continue;
    const int side = plane.side(mesh.position(v));
    sides.behind |= side < 0;
    sides.in_front |= side > 0;
  }
  return sides;
}

/// A prism with one end in the plane, on that side of it to which the main axis leads, whose other faces are beyond the
/// box: what it has in common with a solid in the box is what the solid has on that side of the plane.
ExactMesh prism_beyond(const Plane& plane, std::size_t axis, const BoundingBox& box) {
  ExactMesh prism = rectangle_in(plane, axis, box);
  double top = box.upper[axis];
  for (const Vertex& p : prism.mesh.vertices) top = std::max(top, p[axis]);
  top = finite_sum(top, std::max(reach_of(box), std::abs(top)));
  for (std::uint32_t corner = 0; corner < 4; ++corner) {
    Vertex above = prism.mesh.vertices[corner];
    above[axis] = top;
    prism.mesh.vertices.push_back(above);
  }
  prism.mesh.triangles = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}};
  for (std::uint32_t a = 0; a < 4; ++a) {
    const std::uint32_t b = (a + 1) % 4;
    prism.mesh.triangles.push_back({a, b, b + 4});
    prism.mesh.triangles.push_back({a, b + 4, a + 4});
  }
  return prism;
}

}  // namespace

Solid::Halves Solid::split(const Plane& plane, const Options& options) const {
  const std::size_t axis = main_axis(plane);
  const Sides sides = sides_of(*this, plane);
  if (!sides.in_front) return {*this, {}};
  if (!sides.behind) return {{}, *this};
  const Solid prism = trusted(prism_beyond(plane, axis, bounding_box()));
  Solid within = combine_solids(Operation::intersection, {*this, prism}, options);
  Solid rest = combine_solids(Operation::difference, {*this, prism}, options);
  if (plane.normal[axis] > 0) return {std::move(rest), std::move(within)};
  return {std::move(within), std::move(rest)};
}

}  // namespace strata
