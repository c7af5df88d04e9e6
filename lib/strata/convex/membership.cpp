#include "strata/convex/membership.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "strata/convex/outline.h"
#include "strata/convex/sum.h"
#include "strata/kernel/disjoint_sets.h"

namespace strata::convex {
namespace {

RationalPoint minus(const RationalPoint& a, const RationalPoint& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Rational dot(const RationalPoint& a, const RationalPoint& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
RationalPoint cross(const RationalPoint& a, const RationalPoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Bounds of the exact places behind rounded coordinates.
void include(Box& box, const Vertex& v) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    box.lower[i] = std::min(box.lower[i], std::nextafter(v[i], -infinity));
    box.upper[i] = std::max(box.upper[i], std::nextafter(v[i], infinity));
  }
}

/// May x be between two doubles? Certain where the answer is no.
bool may_hold(double lower, double upper, double nearest) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return lower <= std::nextafter(nearest, infinity) && std::nextafter(nearest, -infinity) <= upper;
}

Vertex nearest(const RationalPoint& p) {
  return {to_nearest_double(p[0]), to_nearest_double(p[1]), to_nearest_double(p[2])};
}

/// The vertices of every connected part of a surface.
std::vector<std::vector<RationalPoint>> parts_of(const Surface& surface) {
  DisjointSets<std::uint32_t> parts(surface.fans.size());
  for (const SurfaceEdge& e : surface.edges) parts.unite(e.fans[0], e.fans[1]);
  std::vector<std::vector<RationalPoint>> all(surface.fans.size());
  for (std::uint32_t i = 0; i < surface.fans.size(); ++i)
    all[parts.find(i)].push_back(surface.points.position(surface.fans[i].vertex));
  std::erase_if(all, [](const auto& part) { return part.empty(); });
  return all;
}

/// Turn of p, q, r in the plane of x and y, where r is moved by (e, e^2).
int turn(const RationalPoint& p, const RationalPoint& q, const RationalPoint& r) {
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

/// Counts what is straight above. A point inside faces is in front of them or behind them; on edges it is not decided.
Side side_of_solid(const ExactMesh& solid, const NearPoint& point) {
  const RationalPoint& p = point.p;
  const Vertex near = nearest(p);
  int above = 0;
  bool is_in_front = false;
  for (const Triangle& t : solid.mesh.triangles) {
    Box box;
    for (const std::uint32_t v : t) include(box, solid.mesh.vertices[v]);
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (!may_hold(box.lower[0], box.upper[0], near[0]) || !may_hold(box.lower[1], box.upper[1], near[1]) ||
        !may_hold(-infinity, box.upper[2], near[2]))
      continue;
    const std::array<RationalPoint, 3> c{solid.position(t[0]), solid.position(t[1]), solid.position(t[2])};
    const RationalPoint normal = cross(minus(c[1], c[0]), minus(c[2], c[0]));
    const int height = dot(normal, minus(p, c[0])).sign();
    if (const int place = height == 0 ? place_in_triangle(c, normal, p) : -1; place >= 0) {
      const int slope = dot(normal, point.n).sign();
      if (place == 0 || slope == 0) return Side::unknown;
      if (slope < 0) return Side::in;
      is_in_front = true;
    }
    const int turns = turn(c[0], c[1], p) + turn(c[1], c[2], p) + turn(c[2], c[0], p);
    if (turns == 3 && height < 0) ++above;
    if (turns == -3 && height > 0) --above;
  }
  return above > 0 && !is_in_front ? Side::in : Side::out;
}

/// Both sides of a triangle.
Outline outline_of(const Mesh& mesh, const Triangle& t) {
  const Vertex &p = mesh.vertices[t[0]], &q = mesh.vertices[t[1]], &r = mesh.vertices[t[2]];
  Outline outline({p, q, r});
  outline.add_facet(p, q, r);
  outline.add_facet(p, r, q);
  return outline;
}

Outline outline_of(const Polytope& polytope) {
  Outline outline(polytope.vertices);
  for (const auto& loop : polytope.facets) {
    const Vertex &p = polytope.vertices[loop[0]], &q = polytope.vertices[loop[1]], &r = polytope.vertices[loop[2]];
    outline.add_facet(p, q, r);
    if (polytope.dimension < 3) outline.add_facet(p, r, q);
  }
  return outline;
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
    if (place != RationalPoint{to_rational(result.vertices[i][0]), to_rational(result.vertices[i][1]),
                               to_rational(result.vertices[i][2])})
      result.exact.push_back({i, std::move(place)});
  }
  return result;
}

Pieces triangles_of(const ExactMesh& solid) {
  Pieces result;
  for (const Triangle& t : solid.mesh.triangles) {
    Box box;
    for (const std::uint32_t v : t) include(box, solid.mesh.vertices[v]);
    result.boxes.push_back(box);
  }
  return result;
}

Pieces pieces_of(const Polytope& polytope) {
  Pieces result{{polytope}, {Box()}};
  for (const Vertex& v : polytope.vertices) include(result.boxes[0], v);
  return result;
}

SumMembership::SumMembership(const ExactMesh& a, const Surface& of_a, const ExactMesh* b, const Surface& of_b,
                             const Polytope* whole_b)
    : a_(a),
      b_(b),
      pieces_of_a_(triangles_of(a)),
      pieces_of_b_(b != nullptr ? triangles_of(*b) : pieces_of(*whole_b)),
      parts_of_a_(parts_of(of_a)),
      parts_of_b_(parts_of(of_b)) {
  if (whole_b != nullptr) outline_of_b_ = outline_of(*whole_b);
}

Side SumMembership::side(const NearPoint& point) const {
  // One operand holds a part of the other, or their boundaries meet. What is deep inside is told by the first alone.
  bool unknown = false;
  const auto holds = [&](const ExactMesh& solid, const std::vector<std::vector<RationalPoint>>& parts) {
    for (const auto& part : parts) {
      Side side = Side::unknown;
      for (std::size_t i = 0; i < part.size() && side == Side::unknown; ++i)
        side = side_of_solid(solid, {minus(point.p, part[i]), point.n});
      if (side == Side::in) return true;
      unknown |= side == Side::unknown;
    }
    return false;
  };
  if (holds(a_, parts_of_b_) || (b_ != nullptr && holds(*b_, parts_of_a_))) return Side::in;
  const Side boundaries = side_of_boundaries(point);
  return boundaries == Side::out && unknown ? Side::unknown : boundaries;
}

/// Does a piece of one boundary meet one of the other?
Side SumMembership::side_of_boundaries(const NearPoint& point) const {
  const Vertex near = nearest(point.p);
  bool unknown = false;
  const auto may_cover = [&](const Box& s, const Box& t) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i)
      if (!may_hold(std::nextafter(s.lower[i] + t.lower[i], -infinity),
                    std::nextafter(s.upper[i] + t.upper[i], infinity), near[i]))
        return false;
    return true;
  };
  for (std::size_t j = 0; j < pieces_of_b_.boxes.size(); ++j) {
    Polytope of_b;
    std::optional<Outline> of_triangle;  // of b, when one is near
    for (std::size_t i = 0; i < pieces_of_a_.boxes.size(); ++i) {
      if (!may_cover(pieces_of_a_.boxes[i], pieces_of_b_.boxes[j])) continue;
      if (b_ != nullptr && !of_triangle) of_triangle = outline_of(b_->mesh, b_->mesh.triangles[j]);
      const Outline& outline_of_b = b_ == nullptr ? *outline_of_b_ : *of_triangle;
      if (sum_misses(outline_of(a_.mesh, a_.mesh.triangles[i]), outline_of_b, near)) continue;
      if (of_b.dimension < 0)
        of_b = b_ == nullptr ? pieces_of_b_.polytopes[j] : triangle_polytope(*b_, b_->mesh.triangles[j]);
      switch (side_of(sum(triangle_polytope(a_, a_.mesh.triangles[i]), of_b), point)) {
        case Side::in:
          return Side::in;
        case Side::unknown:
          unknown = true;
          break;
        case Side::out:
          break;
      }
    }
  }
  return unknown ? Side::unknown : Side::out;
}

}  // namespace strata::convex
