#include "extensions/convex/membership.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "core/exact/vector.h"
#include "core/kernel/disjoint_sets.h"
#include "core/kernel/rational_point.h"
#include "extensions/convex/approximate_convex_set.h"
#include "strata/convex.h"

namespace strata::convex {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Bounds of the exact position with these rounded coordinates.
Box bounds_of(const Vertex& v) {
  Box box;
  for (std::size_t i = 0; i < 3; ++i) {
    box.lower[i] = std::nextafter(v[i], -infinity);
    box.upper[i] = std::nextafter(v[i], infinity);
  }
  return box;
}

/// Bounds of all x - y. The ends of neither box are infinite in the wrong direction.
Box differences(const Box& x, const Box& y) {
  Box box;
  for (std::size_t i = 0; i < 3; ++i) {
    box.lower[i] = std::nextafter(x.lower[i] - y.upper[i], -infinity);
    box.upper[i] = std::nextafter(x.upper[i] - y.lower[i], infinity);
  }
  return box;
}

Vertex nearest(const RationalPoint& p) {
  return {to_nearest_double(p[0]), to_nearest_double(p[1]), to_nearest_double(p[2])};
}

/// The vertices of every connected component of a surface.
std::vector<std::vector<RationalPoint>> parts_of(const Surface& surface, const Monitor& monitor) {
  DisjointSets<std::uint32_t> parts(surface.fans.size());
  for (const SurfaceEdge& e : surface.edges) parts.unite(e.fans[0], e.fans[1]);
  std::vector<std::vector<RationalPoint>> all(surface.fans.size());
  for (std::uint32_t i = 0; i < surface.fans.size(); ++i) {
    monitor.check();
    all[parts.find(i)].push_back(surface.points.position(surface.fans[i].vertex));
  }
  std::erase_if(all, [](const auto& part) { return part.empty(); });
  return all;
}

/// Orientation of p, q, r in the plane of x and y, where r is translated by (e, e^2).
int orientation(const RationalPoint& p, const RationalPoint& q, const RationalPoint& r) {
  const Rational x = q[0] - p[0], y = q[1] - p[1];
  const Rational value = x * (r[1] - p[1]) - y * (r[0] - p[0]);
  if (value != 0) return value.sign();
  return y != 0 ? -y.sign() : x.sign();
}

/// 1 inside, 0 on a side, -1 outside of a triangle, for a point of its plane.
int place_in_triangle(const std::array<RationalPoint, 3>& t, const RationalPoint& normal, const RationalPoint& p) {
  int least = 1;
  for (std::size_t i = 0; i < 3; ++i)
    least = std::min(least, dot(cross(minus(t[(i + 1) % 3], t[i]), minus(p, t[i])), normal).sign());
  return least;
}

/// Counts the faces straight above. A point in the interior of faces is in front of them or behind them; on edges it is
/// not decided.
Side side_of_solid(const ExactMesh& solid, const TriangleBoxes& triangles, const NearPoint& point) {
  const RationalPoint& p = point.p;
  Box upwards = bounds_of(nearest(p));
  upwards.upper[2] = infinity;
  int above = 0;
  bool is_in_front = false;
  std::optional<Side> side;
  triangles.for_each_overlapping(upwards, [&](std::uint32_t number) {
    const Triangle& t = solid.mesh.triangles[number];
    const std::array<RationalPoint, 3> c{solid.position(t[0]), solid.position(t[1]), solid.position(t[2])};
    const RationalPoint normal = cross(minus(c[1], c[0]), minus(c[2], c[0]));
    const int height = dot(normal, minus(p, c[0])).sign();
    if (const int place = height == 0 ? place_in_triangle(c, normal, p) : -1; place >= 0) {
      const int slope = dot(normal, point.n).sign();
      if (place == 0 || slope == 0)
        side = Side::unknown;
      else if (slope < 0)
        side = Side::in;
      if (side) return false;
      is_in_front = true;
    }
    const int orientations = orientation(c[0], c[1], p) + orientation(c[1], c[2], p) + orientation(c[2], c[0], p);
    if (orientations == 3 && height < 0) ++above;
    if (orientations == -3 && height > 0) --above;
    return true;
  });
  if (side) return *side;
  return above > 0 && !is_in_front ? Side::in : Side::out;
}

/// Both sides of a triangle.
ApproximateConvexSet approximate(const Mesh& mesh, const Triangle& t) {
  const Vertex &p = mesh.vertices[t[0]], &q = mesh.vertices[t[1]], &r = mesh.vertices[t[2]];
  ApproximateConvexSet set({p, q, r});
  set.add_facet(p, q, r);
  set.add_facet(p, r, q);
  return set;
}

ApproximateConvexSet approximate(const Polytope& polytope) {
  ApproximateConvexSet set(polytope.vertices);
  for (const auto& loop : polytope.facets) {
    const Vertex &p = polytope.vertices[loop[0]], &q = polytope.vertices[loop[1]], &r = polytope.vertices[loop[2]];
    set.add_facet(p, q, r);
    if (polytope.dimension < 3) set.add_facet(p, r, q);
  }
  return set;
}

}  // namespace

Side side_of(const Polytope& polytope, const NearPoint& point) {
  const bool is_flat = polytope.dimension < 3;
  if (polytope.dimension < 2) return Side::out;
  bool unknown = false;
  const Vertex near = nearest(point.p);
  for (const auto& loop : polytope.facets) {
    const auto certain =
        rounded_side(polytope.vertices[loop[0]], polytope.vertices[loop[1]], polytope.vertices[loop[2]], near);
    if (!is_flat && certain == Sign::negative) continue;
    if (!is_flat && certain == Sign::positive) return Side::out;
    const RationalPoint p = polytope.position(loop[0]);
    const RationalPoint normal = cross(minus(polytope.position(loop[1]), p), minus(polytope.position(loop[2]), p));
    const Rational height = dot(normal, minus(point.p, p));
    const Rational slope = dot(normal, point.n);
    if (is_flat) return height == 0 && slope == 0 ? Side::unknown : Side::out;
    if (height > 0 || (height == 0 && slope > 0)) return Side::out;
    unknown |= height == 0 && slope == 0;
  }
  return unknown ? Side::unknown : Side::in;
}

Polytope triangle_polytope(ExactMeshView mesh, const Triangle& triangle) {
  std::array<std::uint32_t, 3> order = triangle;
  std::sort(order.begin(), order.end(), [&](std::uint32_t v, std::uint32_t w) {
    const Vertex &p = mesh.mesh.vertices[v], &q = mesh.mesh.vertices[w];
    return mesh.exact.empty() ? p < q : mesh.position(v) < mesh.position(w);
  });
  Polytope result{2, {}, {}, {{0, 1, 2}}};
  for (std::uint32_t i = 0; i < 3; ++i) {
    result.vertices.push_back(mesh.mesh.vertices[order[i]]);
    if (mesh.exact.empty()) continue;
    RationalPoint place = mesh.position(order[i]);
    if (place != to_rational(result.vertices[i])) result.exact.push_back({i, std::move(place)});
  }
  return result;
}

TriangleBoxes::TriangleBoxes(const Mesh& mesh, const Monitor& monitor) {
  boxes_.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    Box& box = boxes_.emplace_back();
    for (const std::uint32_t v : t) box.include(bounds_of(mesh.vertices[v]));
  }
  tree_ = BoxTree::by_surface_area(static_cast<std::uint32_t>(boxes_.size()), [&](std::span<const std::uint32_t> some) {
    monitor.check();
    Box box;
    for (const std::uint32_t t : some) box.include(boxes_[t]);
    return box;
  });
}

SumMembership::SumMembership(const ExactMesh& a, const Surface& of_a, const ExactMesh* b, const Surface& of_b,
                             const Polytope* whole_b, const Monitor& monitor)
    : a_(a),
      b_(b),
      whole_b_(whole_b),
      monitor_(monitor),
      triangles_of_a_(a.mesh, monitor),
      parts_of_a_(parts_of(of_a, monitor)),
      parts_of_b_(parts_of(of_b, monitor)) {
  if (b != nullptr) {
    triangles_of_b_ = TriangleBoxes(b->mesh, monitor);
  } else {
    set_b_ = approximate(*whole_b);
    for (const Vertex& v : whole_b->vertices) bounds_of_b_.include(bounds_of(v));
  }
}

Side SumMembership::side(const NearPoint& point) const {
  // One operand contains a component of the other, or their boundaries meet. The first condition alone decides most
  // interior points.
  bool unknown = false;
  const auto holds = [&](const ExactMesh& solid, const TriangleBoxes& triangles,
                         const std::vector<std::vector<RationalPoint>>& parts) {
    for (const auto& part : parts) {
      monitor_.check();
      Side side = Side::unknown;
      for (std::size_t i = 0; i < part.size() && side == Side::unknown; ++i)
        side = side_of_solid(solid, triangles, {minus(point.p, part[i]), point.n});
      if (side == Side::in) return true;
      unknown |= side == Side::unknown;
    }
    return false;
  };
  if (holds(a_, triangles_of_a_, parts_of_b_)) return Side::in;
  if (b_ != nullptr && holds(*b_, triangles_of_b_, parts_of_a_)) return Side::in;
  const Side boundaries = side_of_boundaries(point);
  return boundaries == Side::out && unknown ? Side::unknown : boundaries;
}

Side SumMembership::side_of_boundaries(const NearPoint& point) const {
  const Vertex near = nearest(point.p);
  if (b_ == nullptr) return side_of_sums(point, near, bounds_of_b_, *set_b_, [&] { return *whole_b_; });
  bool unknown = false;
  for (std::size_t j = 0; j < b_->mesh.triangles.size(); ++j) {
    monitor_.check();
    const Triangle& t = b_->mesh.triangles[j];
    const Side side = side_of_sums(point, near, triangles_of_b_[j], approximate(b_->mesh, t),
                                   [&] { return triangle_polytope(*b_, t); });
    if (side == Side::in) return Side::in;
    unknown |= side == Side::unknown;
  }
  return unknown ? Side::unknown : Side::out;
}

template <class PieceOfB>
Side SumMembership::side_of_sums(const NearPoint& point, const Vertex& near, const Box& bounds_of_b,
                                 const ApproximateConvexSet& set_b, const PieceOfB& piece_of_b) const {
  std::optional<Polytope> of_b;  // computed when it is needed
  bool unknown = false;
  const bool is_out =
      triangles_of_a_.for_each_overlapping(differences(bounds_of(near), bounds_of_b), [&](std::uint32_t number) {
        monitor_.check();
        const Triangle& t = a_.mesh.triangles[number];
        if (sum_misses(approximate(a_.mesh, t), set_b, near)) return true;
        if (!of_b) of_b = piece_of_b();
        const Side side = side_of(sum(triangle_polytope(a_, t), *of_b, monitor_), point);
        unknown |= side == Side::unknown;
        return side != Side::in;
      });
  if (!is_out) return Side::in;
  return unknown ? Side::unknown : Side::out;
}

}  // namespace strata::convex
