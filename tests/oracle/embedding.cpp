#include "oracle/embedding.h"

#include <CGAL/Box_intersection_d/Box_with_handle_d.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <array>
#include <vector>

namespace strata::oracle {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Face = std::array<Point, 3>;
using FaceBox = CGAL::Box_intersection_d::Box_with_handle_d<double, 3, const Face*>;

Kernel::Triangle_3 triangle(const Face& f) { return {f[0], f[1], f[2]}; }

/// Do faces with one corner in common share more than that? Then the side opposite to it in one of them meets the
/// other.
bool meet_beyond_corner(const Face& f, const Face& g, std::size_t i, std::size_t k) {
  return CGAL::do_intersect(triangle(f), Kernel::Segment_3(g[(k + 1) % 3], g[(k + 2) % 3])) ||
         CGAL::do_intersect(triangle(g), Kernel::Segment_3(f[(i + 1) % 3], f[(i + 2) % 3]));
}

/// Do faces with a side in common share more than that? Then they are in one plane, on the same side of it.
bool meet_beyond_side(const Point& a, const Point& b, const Point& c, const Point& d) {
  return CGAL::coplanar(a, b, c, d) && CGAL::coplanar_orientation(a, b, c, d) == CGAL::POSITIVE;
}

bool cross(const Face& f, const Face& g) {
  std::vector<std::array<std::size_t, 2>> common;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      if (f[i] == g[k]) common.push_back({i, k});
  if (common.empty()) return CGAL::do_intersect(triangle(f), triangle(g));
  if (common.size() == 1) return meet_beyond_corner(f, g, common[0][0], common[0][1]);
  if (common.size() == 3) return true;
  const std::size_t i = 3 - common[0][0] - common[1][0], k = 3 - common[0][1] - common[1][1];
  return meet_beyond_side(f[common[0][0]], f[common[1][0]], f[i], g[k]);
}

}  // namespace

bool is_embedded(const Mesh& mesh) {
  std::vector<Face> faces;
  for (const Triangle& t : mesh.triangles) {
    Face face;
    std::transform(t.begin(), t.end(), face.begin(), [&](std::uint32_t v) {
      const auto& [x, y, z] = mesh.vertices[v];
      return Point(x, y, z);
    });
    if (CGAL::collinear(face[0], face[1], face[2])) return false;
    faces.push_back(face);
  }
  std::vector<FaceBox> boxes;
  for (const Face& f : faces) boxes.emplace_back(triangle(f).bbox(), &f);
  bool found = false;
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const FaceBox& a, const FaceBox& b) {
    found = found || cross(*a.handle(), *b.handle());
  });
  return !found;
}

}  // namespace strata::oracle
