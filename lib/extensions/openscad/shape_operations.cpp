#include "extensions/openscad/shape_operations.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "extensions/openscad/rational_mesh.h"
#include "strata/convex.h"

namespace strata::openscad {
namespace {

using planar::RationalPlacement;
using Polygon = std::vector<RationalPlacement>;

RationalPlacement sum(const RationalPlacement& a, const RationalPlacement& b) { return {a[0] + b[0], a[1] + b[1]}; }
RationalPlacement difference(const RationalPlacement& a, const RationalPlacement& b) {
  return {a[0] - b[0], a[1] - b[1]};
}

/// Positive where b is counter-clockwise of a.
Rational cross(const RationalPlacement& a, const RationalPlacement& b) { return a[0] * b[1] - a[1] * b[0]; }

std::vector<Polygon> polygons_of(const planar::Region& region) {
  std::vector<Polygon> polygons;
  for (std::uint32_t l = 0; l < region.loops.size(); ++l) {
    Polygon& polygon = polygons.emplace_back();
    for (const std::uint32_t v : region.loops.loop(l)) polygon.push_back(position(region, v));
  }
  return polygons;
}

void add(const Polygon& polygon, planar::LoopsBuilder& loops) {
  for (const RationalPlacement& p : polygon) loops.add_vertex(p);
  loops.end_loop();
}

/// Polygons that are united where they wind around something, all counter-clockwise or holes.
class Union {
 public:
  void add(const Polygon& polygon) { openscad::add(polygon, loops_); }
  planar::Region finish() { return planar::fill({loops_.finish(), planar::FillRule::positive}); }

 private:
  planar::LoopsBuilder loops_;
};

planar::Region polygon_hull(std::vector<Polygon> polygons) {
  VertexCollector points;
  for (Polygon& polygon : polygons)
    for (RationalPlacement& p : polygon) points.add(RationalPoint{std::move(p[0]), std::move(p[1]), 0});
  const convex::Polytope hull = convex::convex_hull(ExactMeshView(points.mesh()));
  planar::LoopsBuilder loops;
  for (const auto& facet : hull.facets) {
    for (const std::uint32_t v : facet) {
      RationalPoint p = hull.position(v);
      loops.add_vertex(RationalPlacement{std::move(p[0]), std::move(p[1])});
    }
    loops.end_loop();
  }
  return planar::fill(loops.finish());
}

bool is_convex(const std::vector<Polygon>& polygons) {
  if (polygons.size() != 1) return false;
  const Polygon& p = polygons.front();
  for (std::size_t i = 0; i < p.size(); ++i) {
    const RationalPlacement &a = p[i], &b = p[(i + 1) % p.size()], &c = p[(i + 2) % p.size()];
    if (cross(difference(b, a), difference(c, b)).sign() <= 0) return false;
  }
  return true;
}

/// The sum of a segment and a convex polygon, counter-clockwise: edges in front, as seen along the segment, are moved
/// to its end, all others to its start.
Polygon swept(const Polygon& convex, const RationalPlacement& from, const RationalPlacement& to) {
  const RationalPlacement along = difference(to, from);
  Polygon result;
  for (std::size_t i = 0; i < convex.size(); ++i) {
    const std::size_t before = (i + convex.size() - 1) % convex.size(), after = (i + 1) % convex.size();
    const bool arrives = cross(along, difference(convex[i], convex[before])).sign() > 0;
    const bool leaves = cross(along, difference(convex[after], convex[i])).sign() > 0;
    result.push_back(sum(convex[i], arrives ? to : from));
    if (arrives != leaves) result.push_back(sum(convex[i], leaves ? to : from));
  }
  return result;
}

void add_moved(const std::vector<Polygon>& polygons, const RationalPlacement& by, Union& all) {
  for (const Polygon& polygon : polygons) {
    Polygon moved;
    for (const RationalPlacement& p : polygon) moved.push_back(sum(p, by));
    all.add(moved);
  }
}

template <class Visit>
void for_edges(const std::vector<Polygon>& polygons, const Visit& visit) {
  for (const Polygon& p : polygons)
    for (std::size_t i = 0; i < p.size(); ++i) visit(p[i], p[(i + 1) % p.size()]);
}

/// A corner of every polygon's outer loop.
std::vector<RationalPlacement> corners(const planar::Region& region) {
  std::vector<RationalPlacement> list;
  for (std::uint32_t p = 0; p < region.polygons(); ++p)
    list.push_back(position(region, region.loops.loop(region.first_loop[p]).front()));
  return list;
}

}  // namespace

planar::Region transformed(const planar::Region& region, const PlaneMap& map, Placement placement) {
  planar::LoopsBuilder loops;
  for (std::uint32_t l = 0; l < region.loops.size(); ++l) {
    for (const std::uint32_t v : region.loops.loop(l)) {
      const RationalPlacement p = position(region, v);
      RationalPlacement q;
      for (std::size_t i = 0; i < 2; ++i) q[i] = map[i][0] * p[0] + map[i][1] * p[1] + map[i][2];
      if (placement == Placement::rounded) {
        loops.add_vertex(planar::PlanePoint{to_nearest_double(q[0]), to_nearest_double(q[1])});
      } else {
        loops.add_vertex(std::move(q));
      }
    }
    loops.end_loop();
  }
  return planar::fill(loops.finish());
}

planar::Region hull(std::span<const planar::Region* const> regions) {
  std::vector<Polygon> all;
  for (const planar::Region* region : regions)
    for (Polygon& polygon : polygons_of(*region)) all.push_back(std::move(polygon));
  return polygon_hull(std::move(all));
}

planar::Region minkowski_sum(const planar::Region& a, const planar::Region& b) {
  if (a.empty() || b.empty()) return {};
  const std::vector<Polygon> p = polygons_of(a), q = polygons_of(b);
  const bool p_is_convex = is_convex(p), q_is_convex = is_convex(q);
  if (p_is_convex && q_is_convex) {
    std::vector<Polygon> sums(1);
    for (const RationalPlacement& x : p.front())
      for (const RationalPlacement& y : q.front()) sums.front().push_back(sum(x, y));
    return polygon_hull(std::move(sums));
  }
  if (p_is_convex) return minkowski_sum(b, a);
  Union all;
  for (const RationalPlacement& corner : corners(b)) add_moved(p, corner, all);
  if (q_is_convex) {
    for_edges(p, [&](const auto& from, const auto& to) { all.add(swept(q.front(), from, to)); });
    return all.finish();
  }
  for (const RationalPlacement& corner : corners(a)) add_moved(q, corner, all);
  for_edges(p, [&](const auto& from, const auto& to) {
    for_edges(q, [&](const auto& start, const auto& end) {
      Polygon sums{sum(from, start), sum(to, start), sum(to, end), sum(from, end)};
      const int turn = cross(difference(to, from), difference(end, start)).sign();
      if (turn < 0) std::swap(sums[1], sums[3]);
      if (turn != 0) all.add(sums);
    });
  });
  return all.finish();
}

planar::Region without_holes(const planar::Region& region) {
  planar::LoopsBuilder loops;
  for (std::uint32_t p = 0; p < region.polygons(); ++p) {
    for (const std::uint32_t v : region.loops.loop(region.first_loop[p])) loops.add_vertex(position(region, v));
    loops.end_loop();
  }
  return planar::fill(loops.finish());
}

std::array<RationalPlacement, 2> bounding_box(const planar::Region& region) {
  std::array<RationalPlacement, 2> box;
  bool is_first = true;
  for (const std::uint32_t v : region.loops.vertices) {
    const RationalPlacement p = position(region, v);
    for (std::size_t i = 0; i < 2; ++i) {
      if (is_first || p[i] < box[0][i]) box[0][i] = p[i];
      if (is_first || p[i] > box[1][i]) box[1][i] = p[i];
    }
    is_first = false;
  }
  return box;
}

}  // namespace strata::openscad
