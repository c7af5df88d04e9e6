#include "core/round/pile_filling.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/exact/finite.h"
#include "core/kernel/box.h"
#include "core/mesh/planar_chain.h"
#include "core/mesh/planar_levels.h"
#include "core/mesh/planar_points.h"
#include "core/mesh/polygon_sweep.h"
#include "core/round/distances.h"

namespace strata {
namespace {

using Index = std::uint32_t;

bool is_same(const facets::Chain& a, const facets::Chain& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const facets::NetEdge& e, const facets::NetEdge& f) {
    return e.low == f.low && e.high == f.high && e.count == f.count;
  });
}

constexpr Projection axes{0, 1};

/// How often faces have the side from one vertex to another, which has a higher number, minus how often the other way.
struct NetSide {
  Index low = 0, high = 0;
  std::int64_t count = 0;
};

/// The sides of some faces that do not cancel.
std::vector<NetSide> boundary_of(MeshView mesh, std::span<const Index> faces) {
  std::vector<NetSide> sides;
  sides.reserve(3 * faces.size());
  for (const Index f : faces)
    for (std::size_t k = 0; k < 3; ++k) {
      const Index from = mesh.triangles[f][k], to = mesh.triangles[f][(k + 1) % 3];
      sides.push_back(from < to ? NetSide{from, to, 1} : NetSide{to, from, -1});
    }
  const auto ends = [](const NetSide& s) { return std::pair(s.low, s.high); };
  std::sort(sides.begin(), sides.end(), [&](const NetSide& a, const NetSide& b) { return ends(a) < ends(b); });
  std::vector<NetSide> net;
  for (const NetSide& s : sides) {
    if (net.empty() || ends(net.back()) != ends(s)) {
      if (!net.empty() && net.back().count == 0) net.pop_back();
      net.push_back(s);
    } else {
      net.back().count += s.count;
    }
  }
  if (!net.empty() && net.back().count == 0) net.pop_back();
  return net;
}

/// The boundary of a pile as it is seen along the axis of its plane. Vertices are named by their places there.
class SeenBoundary {
 public:
  SeenBoundary(MeshView mesh, const std::vector<NetSide>& net, const ViewedPlane& plane) : mesh_(mesh), plane_(plane) {
    std::vector<Index> vertices;
    for (const NetSide& s : net) vertices.insert(vertices.end(), {s.low, s.high});
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    const std::vector<Index> names = name(vertices);
    std::vector<facets::Side> sides;
    const auto name_of = [&](Index v) {
      return names[static_cast<std::size_t>(std::lower_bound(vertices.begin(), vertices.end(), v) - vertices.begin())];
    };
    for (const NetSide& s : net) {
      facets::Side side{name_of(s.low), name_of(s.high)};
      if (side.from == side.to) continue;
      if (s.count < 0) std::swap(side.from, side.to);
      sides.insert(sides.end(), static_cast<std::size_t>(std::abs(s.count)), side);
    }
    boundary_ = facets::net_chain(*points_, sides);
  }

  /// What fills it; none if that would need other vertices and it may not be divided, or is long.
  [[nodiscard]] std::optional<PileFilling> filling(const GridRounding& grid, bool may_divide) {
    PileFilling filling;
    filling.joined = joined_;
    if (boundary_.empty()) return filling;
    facets::Chain divided = facets::cut_at_contacts(*points_, axes, boundary_);
    divided = facets::cut_at_crossings(*points_, axes, divided);
    is_divided_ = !is_same(divided, boundary_);
    if (is_divided_) {
      constexpr std::size_t most_tests = 1 << 20;
      if (!may_divide || boundary_.size() * points_->size() > most_tests) return {};
      const std::size_t corner_count = vertex_of_name_.size();
      add_vertices(grid, filling.added);
      if (!std::all_of(filling.added.begin(), filling.added.end(), is_finite)) return {};
      add_flat_triangles(division_points(corner_count), filling.triangles);
    }
    fill(divided, filling.triangles);
    return filling;
  }

  /// The filling has other vertices.
  [[nodiscard]] bool is_divided() const { return is_divided_; }

 private:
  /// Names of some vertices, by increasing number. Those with one name are joined with the lowest one.
  [[nodiscard]] std::vector<Index> name(const std::vector<Index>& vertices) {
    std::vector<Vertex> seen;
    seen.reserve(vertices.size());
    for (const Index v : vertices)
      seen.push_back({mesh_.vertices[v][plane_.first()], mesh_.vertices[v][plane_.second()], 0});
    std::vector<Index> names;
    points_.emplace(homogeneous(seen), names);
    constexpr Index none = std::numeric_limits<Index>::max();
    vertex_of_name_.resize(points_->size(), none);
    for (std::size_t n = 0; n < vertices.size(); ++n) {
      Index& lowest = vertex_of_name_[names[n]];
      if (lowest == none) {
        lowest = vertices[n];
      } else {
        const Vertex &from = mesh_.vertices[vertices[n]], &to = mesh_.vertices[lowest];
        joined_.push_back({vertices[n], lowest, to, std::nextafter(distance(from, to), Box::infinity)});
      }
    }
    return names;
  }

  /// The crossings, on the plane, rounded.
  void add_vertices(const GridRounding& grid, std::vector<Vertex>& added) {
    for (auto n = static_cast<Index>(vertex_of_name_.size()); n < points_->size(); ++n) {
      const HPoint<Integer>& p = (*points_)[n];
      const Vertex at = plane_.point(to_nearest_double(Rational(p.x) / Rational(p.w)),
                                     to_nearest_double(Rational(p.y) / Rational(p.w)));
      vertex_of_name_.push_back(static_cast<Index>(mesh_.vertices.size() + added.size()));
      added.push_back(grid(at, 0));
    }
  }

  /// The points at which the boundary is divided, by place, each once: ends of its sides, and where these cross. A
  /// vertex whose sides cancel, as they are seen, may be where others cross, and is none.
  [[nodiscard]] std::vector<Index> division_points(std::size_t corner_count) const {
    std::vector<bool> divides(points_->size(), false);
    for (const facets::NetEdge& e : boundary_) divides[e.low] = divides[e.high] = true;
    for (std::size_t n = corner_count; n < divides.size(); ++n) divides[n] = true;
    std::vector<Index> by_place(points_->size());
    for (Index n = 0; n < by_place.size(); ++n) by_place[n] = n;
    std::sort(by_place.begin(), by_place.end(), [&](Index a, Index b) {
      const int order = points_->compare(a, b);
      return order != 0 ? order < 0 : a < b;
    });
    std::vector<Index> found;
    for (std::size_t begin = 0, end = 0; begin < by_place.size(); begin = end) {
      while (end < by_place.size() && points_->compare(by_place[begin], by_place[end]) == 0) ++end;
      const auto lowest =
          std::find_if(by_place.begin() + begin, by_place.begin() + end, [&](Index n) { return divides[n]; });
      if (lowest != by_place.begin() + end) found.push_back(*lowest);
    }
    return found;
  }

  /// Between each side of the boundary and the parts into which others divide it. Seen along the axis, they have no
  /// area.
  void add_flat_triangles(const std::vector<Index>& division, std::vector<Triangle>& triangles) const {
    for (const facets::NetEdge& e : boundary_) {
      std::vector<Index> on;
      for (const Index n : division)
        if (points_->compare(e.low, n) < 0 && points_->compare(n, e.high) < 0 &&
            facets::orientation(*points_, axes, e.low, e.high, n) == 0)
          on.push_back(n);
      on.push_back(e.high);
      for (std::size_t i = 1; i < on.size(); ++i)
        for (std::int64_t k = 0; k < std::abs(e.count); ++k) {
          Triangle t{vertex_of_name_[e.low], vertex_of_name_[on[i]], vertex_of_name_[on[i - 1]]};
          if (e.count < 0) std::swap(t[1], t[2]);
          triangles.push_back(t);
        }
    }
  }

  void fill(const facets::Chain& chain, std::vector<Triangle>& triangles) const {
    std::vector<Index> by_place(points_->size()), rank(points_->size());
    for (Index n = 0; n < by_place.size(); ++n) by_place[n] = n;
    std::sort(by_place.begin(), by_place.end(), [&](Index a, Index b) { return points_->compare(a, b) < 0; });
    for (Index n = 0; n < by_place.size(); ++n) rank[by_place[n]] = n;
    for (const facets::Region& region : facets::covered_regions(*points_, axes, chain)) {
      const bool is_front = region.facing == facets::Facing::front;
      std::vector<PolygonSide> sides;
      for (const facets::Side& s : region.sides)
        sides.push_back(is_front ? PolygonSide{rank[s.from], rank[s.to]} : PolygonSide{rank[s.to], rank[s.from]});
      PolygonSweep sweep(sides, [&](Index a, Index b, Index c) {
        return static_cast<Sign>(facets::orientation(*points_, axes, by_place[a], by_place[b], by_place[c]));
      });
      for (Triangle t : sweep.divide()) {
        for (Index& v : t) v = vertex_of_name_[by_place[v]];
        if (!is_front) std::swap(t[1], t[2]);
        triangles.push_back(t);
      }
    }
  }

  MeshView mesh_;
  const ViewedPlane& plane_;
  std::optional<facets::PointTable> points_;
  std::vector<Index> vertex_of_name_;
  std::vector<VertexMove> joined_;  ///< by increasing vertex
  facets::Chain boundary_;
  bool is_divided_ = false;
};

}  // namespace

std::optional<PileFilling> filling_of(MeshView mesh, std::span<const Index> faces, const ViewedPlane& plane,
                                      const GridRounding& grid, std::size_t most_if_divided) {
  if (faces.size() < 2) return {};
  const std::vector<NetSide> net = boundary_of(mesh, faces);
  if (net.empty()) return PileFilling{};
  try {
    SeenBoundary boundary(mesh, net, plane);
    std::optional<PileFilling> filling = boundary.filling(grid, most_if_divided > 0);
    const std::size_t most = boundary.is_divided() ? most_if_divided : faces.size() - 1;
    if (filling && filling->triangles.size() > most) return {};
    return filling;
  } catch (const NoRegion&) {
    return {};  // it overlaps itself
  }
}

}  // namespace strata
