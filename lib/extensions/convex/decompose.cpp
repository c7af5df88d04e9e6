#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>
#include <unordered_map>
#include <utility>

#include "core/kernel/filters.h"
#include "core/kernel/rational_point.h"
#include "extensions/convex/piece_pool.h"
#include "extensions/convex/point_list.h"
#include "extensions/convex/region.h"
#include "strata/convex.h"

namespace strata::convex {
namespace {

constexpr double share_of_division = 0.8;  ///< of the time, an estimate; the rest is for walls and points

/// Divides until everything is convex, then joins pieces whose union is convex.
class Divider {
 public:
  Divider(const PreparedBoundary& boundary, CellMaker& maker, PiecePool& pool, const Monitor& monitor)
      : boundary_(boundary), maker_(maker), pool_(pool), monitor_(monitor), workspace_(boundary) {}

  /// Returns the number of cuts.
  std::size_t run() {
    tasks_.push_back({whole_region(boundary_, maker_), 0, 0, 1});
    while (!tasks_.empty()) {
      monitor_.check();
      Task task = std::move(tasks_.back());
      tasks_.pop_back();
      if (task.region)
        divide(*task.region, task.share);
      else
        pool_.join(task.first, task.plane);
    }
    return cuts_;
  }

 private:
  /// A region to be divided; without one, the pieces of both sides of a plane to be joined.
  struct Task {
    std::optional<Region> region;
    std::uint32_t first = 0;  ///< piece of these sides
    std::uint32_t plane = 0;
    double share = 0;  ///< of the whole work, an estimate
  };

  void divide(const Region& region, double share) {
    const std::optional<std::uint32_t> cut = choose_cut(boundary_, workspace_, region);
    if (!cut) {
      pool_.add(inside_of(boundary_, maker_, region, monitor_));
      done_ += share;
      return monitor_.report(share_of_division * done_);
    }
    ++cuts_;
    RegionSides sides = split(boundary_, maker_, workspace_, region, *cut);
    const auto minus = static_cast<double>(sides.minus.faces.size()),
               plus = static_cast<double>(sides.plus.faces.size());
    const double of_minus = minus + plus > 0 ? minus / (minus + plus) : 0.5;
    tasks_.push_back({std::nullopt, pool_.size(), *cut, 0});
    later(std::move(sides.plus), sides.is_plus_inside, share * (1 - of_minus));
    later(std::move(sides.minus), sides.is_minus_inside, share * of_minus);
  }

  void later(Region region, bool is_inside, double share) {
    if (!region.faces.empty())
      tasks_.push_back({std::move(region), 0, 0, share});
    else if (is_inside)
      pool_.add(std::move(region.cell));
  }

  const PreparedBoundary& boundary_;
  CellMaker& maker_;
  PiecePool& pool_;
  const Monitor& monitor_;
  Workspace workspace_;
  std::vector<Task>
      tasks_;  ///< the last one is next: both sides of a plane are processed before their pieces are joined
  std::size_t cuts_ = 0;
  double done_ = 0;
};

/// Numbers the remaining pieces and finds the walls between them.
class Gatherer {
 public:
  Gatherer(const PreparedBoundary& boundary, CellMaker& maker, const PiecePool& pool, const Monitor& monitor)
      : boundary_(boundary),
        table_(boundary.table),
        maker_(maker),
        pool_(pool),
        monitor_(monitor),
        list_(boundary.table, maker),
        number_(pool.size()) {}

  Decomposition gather() {
    for (std::uint32_t p = 0; p < pool_.size(); ++p) {
      if (pool_.is_gone(p)) continue;
      number_[p] = static_cast<std::uint32_t>(result_.pieces.size());
      std::vector<Decomposition::Polygon>& facets = result_.pieces.emplace_back();
      for (const CellFacet& f : pool_[p].facets) {
        monitor_.check();
        facets.push_back(polygon_of(f));
      }
    }
    add_walls_and_boundary();
    sort_points();
    return std::move(result_);
  }

 private:
  Decomposition::Polygon polygon_of(const CellFacet& facet) {
    Decomposition::Polygon polygon;
    for (const std::uint32_t c : facet.corners) polygon.push_back(list_.number_of(c));
    return polygon;
  }

  /// Plane by plane, in any order: both lists are sorted afterwards by keys that no two entries share.
  void add_walls_and_boundary() {
    std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> triangles;  // by plane
    for (std::uint32_t t = 0; t < boundary_.facets.size(); ++t) triangles[boundary_.plane_of(t)].push_back(t);
    std::size_t done = 0;
    for (const auto& [plane, pieces] : pool_.by_plane()) {
      monitor_.check();
      const std::vector<BoundedFacet> facets = facets_in(plane, pieces);
      add_walls(facets);
      if (const auto found = triangles.find(plane); found != triangles.end())
        for (const std::uint32_t t : found->second) add_boundary(t, facets);
      const double fraction = static_cast<double>(++done) / static_cast<double>(pool_.by_plane().size());
      monitor_.report(share_of_division + (1 - share_of_division) * fraction);
    }
    std::sort(result_.walls.begin(), result_.walls.end(),
              [](const Wall& a, const Wall& b) { return a.pieces < b.pieces; });
    std::sort(result_.boundary.begin(), result_.boundary.end(), [](const BoundaryPart& a, const BoundaryPart& b) {
      return std::pair(a.triangle, a.piece) < std::pair(b.triangle, b.piece);
    });
  }

  /// A facet of a piece, and the half-spaces that bound it in its plane.
  struct BoundedFacet {
    std::uint32_t piece = 0;
    const CellFacet* facet = nullptr;
    std::vector<bsp::HalfSpace> by;
  };

  /// The facets in a plane, of the remaining pieces.
  [[nodiscard]] std::vector<BoundedFacet> facets_in(std::uint32_t plane,
                                                    const std::vector<std::uint32_t>& pieces) const {
    std::vector<BoundedFacet> facets;
    for (const std::uint32_t p : pieces) {
      if (pool_.is_gone(p)) continue;
      BoundedFacet& f = facets.emplace_back(BoundedFacet{number_[p], pool_[p].facet_in(plane), {}});
      for (const std::uint32_t wall : f.facet->walls)
        f.by.push_back({wall, pool_[p].facet_in(wall)->faces_plus ? Sign::negative : Sign::positive});
    }
    return facets;
  }

  /// Adds the walls between facets of opposite orientation that overlap. Two convex pieces have at most one wall.
  void add_walls(const std::vector<BoundedFacet>& facets) {
    for (const BoundedFacet& f : facets) {
      monitor_.check();
      if (!f.facet->faces_plus) continue;
      for (const BoundedFacet& g : facets) {
        if (g.facet->faces_plus) continue;
        const auto common = common_part(*f.facet, g);
        if (!common) continue;
        const auto [low, high] = std::minmax(f.piece, g.piece);
        result_.walls.push_back({{low, high}, polygon_of(maker_.facet_of(*common, low == f.piece))});
      }
    }
  }

  void add_boundary(std::uint32_t triangle, const std::vector<BoundedFacet>& facets) {
    const bsp::Facet<3>& t = boundary_.facets[triangle];
    const CellFacet face = maker_.facet_of(t.piece, t.faces_plus);
    for (const BoundedFacet& f : facets) {
      monitor_.check();
      if (f.facet->faces_plus != t.faces_plus) continue;
      if (const auto common = common_part(face, f))
        result_.boundary.push_back({f.piece, triangle, polygon_of(maker_.facet_of(*common, t.faces_plus))});
    }
  }

  /// The intersection of a polygon and a facet in its plane.
  [[nodiscard]] std::optional<bsp::Piece<3>> common_part(const CellFacet& polygon, const BoundedFacet& facet) const {
    if (maker_.are_boxes_apart(polygon, *facet.facet)) return std::nullopt;
    bsp::Piece<3> common = maker_.piece_of(polygon);
    for (const bsp::HalfSpace& h : facet.by)
      if (!bsp::clip(table_, common, h)) return std::nullopt;
    return common;
  }

  void sort_points() {
    const std::vector<std::uint32_t> point_of = list_.sorted(result_.points, result_.meets);
    const auto renumber = [&](std::vector<std::uint32_t>& polygon) {
      for (std::uint32_t& point : polygon) point = point_of[point];
    };
    for (auto& piece : result_.pieces) std::for_each(piece.begin(), piece.end(), renumber);
    for (Wall& wall : result_.walls) renumber(wall.polygon);
    for (BoundaryPart& part : result_.boundary) renumber(part.polygon);
  }

  const PreparedBoundary& boundary_;
  const HyperplaneTable<3>& table_;
  CellMaker& maker_;
  const PiecePool& pool_;
  const Monitor& monitor_;
  PointList list_;
  std::vector<std::uint32_t> number_;  ///< in the result, by number in the pool
  Decomposition result_;
};

/// Six times a volume within bounds, computed from the facets that bound it.
class NearVolume {
 public:
  template <class Corners>
  void add(const std::vector<Vertex>& points, const Corners& polygon) {
    const BoundedPoint a = bounded(points[polygon[0]]);
    for (std::size_t i = 2; i < polygon.size(); ++i)
      sum_ = sum_ + dot<Bounded>(a, cross<Bounded>(bounded(points[polygon[i - 1]]), bounded(points[polygon[i]])));
  }
  [[nodiscard]] Bounded value() const { return sum_; }

 private:
  /// Bounds of the exact position with these nearest doubles.
  static BoundedPoint bounded(const Vertex& v) {
    BoundedPoint p;
    for (std::size_t i = 0; i < 3; ++i) p[i] = Bounded(v[i], std::abs(v[i]) * Bounded::rounding + Bounded::underflow);
    return p;
  }
  Bounded sum_ = 0;
};

/// Refuses a solid that touches itself away from its vertices and edges: its pieces may lack a part of it.
void refuse_loss(const Mesh& solid, const Decomposition& d) {
  NearVolume of_solid, of_pieces;
  for (const Triangle& t : solid.triangles) of_solid.add(solid.vertices, t);
  for (const auto& piece : d.pieces)
    for (const Decomposition::Polygon& facet : piece) of_pieces.add(d.points, facet);
  const Bounded lost = of_solid.value() - of_pieces.value();
  if (std::abs(lost.value) > 2 * lost.error)  // twice, for the rounding of the bound, whatever its number of steps
    throw std::invalid_argument(
        "the solid touches or crosses itself away from common vertices and edges: read it as overlapping input");
}

}  // namespace

RationalPoint Decomposition::position(std::uint32_t point) const {
  const auto at = std::lower_bound(meets.begin(), meets.end(), point,
                                   [](const MeetOfThree& m, std::uint32_t p) { return m.point < p; });
  if (at != meets.end() && at->point == point) return planes->position(at->planes);
  const Vertex& v = points[point];
  return to_rational(v);
}

std::vector<ExactVertex> Decomposition::exact() const {
  std::vector<ExactVertex> all;
  for (const MeetOfThree& m : meets) all.push_back({m.point, planes->position(m.planes)});
  return all;
}

Polytope Decomposition::polytope(std::uint32_t piece) const {
  Polytope polytope;
  polytope.dimension = 3;
  std::map<std::uint32_t, std::uint32_t> number;  // points are sorted already
  for (const Polygon& facet : pieces[piece])
    for (const std::uint32_t point : facet) number.emplace(point, 0);
  auto meet = meets.begin();
  for (auto& [point, n] : number) {
    n = static_cast<std::uint32_t>(polytope.vertices.size());
    polytope.vertices.push_back(points[point]);
    meet =
        std::lower_bound(meet, meets.end(), point, [](const MeetOfThree& m, std::uint32_t p) { return m.point < p; });
    if (meet != meets.end() && meet->point == point) polytope.exact.push_back({n, planes->position(meet->planes)});
  }
  for (const Polygon& facet : pieces[piece]) {
    std::vector<std::uint32_t>& loop = polytope.facets.emplace_back();
    for (const std::uint32_t point : facet) loop.push_back(number.at(point));
    std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
  }
  std::sort(polytope.facets.begin(), polytope.facets.end());
  return polytope;
}

Decomposition decompose(const Solid& solid, const Monitor& monitor) {
  if (solid.is_empty()) return {};
  PreparedBoundary boundary(solid.exact_mesh(), monitor);
  CellMaker maker(boundary.table, boundary.box);
  PiecePool pool(maker);
  const std::size_t cuts = Divider(boundary, maker, pool, monitor).run();
  Decomposition result = Gatherer(boundary, maker, pool, monitor).gather();
  refuse_loss(solid.mesh(), result);
  result.planes = Shared<HyperplaneTable<3>>::make(std::move(boundary.table));
  result.cuts = cuts;
  result.reflex_edges = static_cast<std::size_t>(
      std::count_if(boundary.wedges.begin(), boundary.wedges.end(), [](const Wedge& w) { return w.is_reflex; }));
  return result;
}

}  // namespace strata::convex
