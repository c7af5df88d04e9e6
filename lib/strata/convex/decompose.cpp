#include "strata/convex/decompose.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "strata/convex/piece_pool.h"
#include "strata/convex/point_list.h"
#include "strata/convex/region.h"
#include "strata/mesh/defect.h"

namespace strata::convex {
namespace {

/// Divides until everything is convex, and joins again what need not have been divided.
class Divider {
 public:
  Divider(const PreparedBoundary& boundary, CellMaker& maker, PiecePool& pool, const Monitor& monitor)
      : boundary_(boundary), maker_(maker), pool_(pool), monitor_(monitor) {}

  /// Returns the number of cuts.
  std::size_t run() {
    tasks_.push_back({whole_region(boundary_, maker_), 0, 0, 1});
    while (!tasks_.empty()) {
      monitor_.check();
      Task task = std::move(tasks_.back());
      tasks_.pop_back();
      if (task.region)
        divide(std::move(*task.region), task.share);
      else
        pool_.join(task.first, task.plane);
    }
    return cuts_;
  }

 private:
  /// A region to be divided; without one, the pieces of both sides of a plane are to be joined.
  struct Task {
    std::optional<Region> region;
    std::uint32_t first = 0;  ///< piece of these sides
    std::uint32_t plane = 0;
    double share = 0;  ///< of the whole work, an estimate
  };

  void divide(Region region, double share) {
    const std::optional<std::uint32_t> cut = choose_cut(boundary_, region);
    if (!cut) {
      pool_.add(inside_of(boundary_, maker_, region));
      done_ += share;
      return monitor_.report(done_);
    }
    ++cuts_;
    RegionSides sides = split(boundary_, maker_, std::move(region), *cut);
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
  std::vector<Task> tasks_;  ///< the last one is next: both sides of a plane come before their pieces are joined
  std::size_t cuts_ = 0;
  double done_ = 0;
};

/// Numbers the pieces that are left and finds the walls between them.
class Gatherer {
 public:
  Gatherer(const PreparedBoundary& boundary, CellMaker& maker, const PiecePool& pool)
      : boundary_(boundary),
        table_(boundary.table),
        maker_(maker),
        pool_(pool),
        list_(boundary.table, maker),
        number_(pool.size()) {}

  Decomposition gather() {
    for (std::uint32_t p = 0; p < pool_.size(); ++p) {
      if (pool_.is_gone(p)) continue;
      number_[p] = static_cast<std::uint32_t>(result_.pieces.size());
      std::vector<Decomposition::Polygon>& facets = result_.pieces.emplace_back();
      for (const CellFacet& f : pool_[p].facets) facets.push_back(polygon_of(f));
    }
    for (const auto& [plane, pieces] : pool_.by_plane()) add_walls(plane, pieces);
    std::sort(result_.walls.begin(), result_.walls.end(),
              [](const Wall& a, const Wall& b) { return a.pieces < b.pieces; });
    add_boundary();
    sort_points();
    return std::move(result_);
  }

 private:
  Decomposition::Polygon polygon_of(const CellFacet& facet) {
    Decomposition::Polygon polygon;
    for (const std::uint32_t c : facet.corners) polygon.push_back(list_.number_of(c));
    return polygon;
  }

  void add_walls(std::uint32_t plane, const std::vector<std::uint32_t>& pieces) {
    for (const std::uint32_t p : pieces) {
      if (pool_.is_gone(p)) continue;
      const CellFacet& f = *pool_[p].facet_in(plane);
      if (!f.faces_plus) continue;
      for (const std::uint32_t q : pieces) {
        if (pool_.is_gone(q)) continue;
        if (const CellFacet& g = *pool_[q].facet_in(plane); !g.faces_plus) add_wall(p, f, q, g);
      }
    }
  }

  void add_boundary() {
    for (std::uint32_t t = 0; t < boundary_.facets.size(); ++t) {
      const bsp::Facet<3>& triangle = boundary_.facets[t];
      const CellFacet face = maker_.facet_of(triangle.piece, triangle.faces_plus);
      const auto pieces = pool_.by_plane().find(triangle.piece.hyperplane);
      if (pieces == pool_.by_plane().end()) throw LogicError("no piece has a face of the solid");
      for (const std::uint32_t p : pieces->second) {
        if (pool_.is_gone(p)) continue;
        const CellFacet& f = *pool_[p].facet_in(triangle.piece.hyperplane);
        if (f.faces_plus != triangle.faces_plus) continue;
        if (const auto common = common_part(face, p, f))
          result_.boundary.push_back({number_[p], t, polygon_of(maker_.facet_of(*common, triangle.faces_plus))});
      }
    }
  }

  /// What a facet of piece p has in common with a polygon in its plane.
  std::optional<bsp::Piece<3>> common_part(const CellFacet& polygon, std::uint32_t p, const CellFacet& facet) const {
    if (maker_.are_boxes_apart(polygon, facet)) return std::nullopt;
    bsp::Piece<3> common = maker_.piece_of(polygon);
    for (const std::uint32_t wall : facet.walls)
      if (!bsp::clip(table_, common, {wall, pool_[p].facet_in(wall)->faces_plus ? Sign::negative : Sign::positive}))
        return std::nullopt;
    return common;
  }

  /// Between facets that look at one another, if they overlap.
  void add_wall(std::uint32_t p, const CellFacet& f, std::uint32_t q, const CellFacet& g) {
    const auto common = common_part(f, q, g);
    if (!common) return;
    const bool is_in_order = number_[p] < number_[q];
    result_.walls.push_back({{std::min(number_[p], number_[q]), std::max(number_[p], number_[q])},
                             polygon_of(maker_.facet_of(*common, is_in_order))});
  }

  void sort_points() {
    const std::vector<std::uint32_t> point_of = list_.sorted(result_.points, result_.exact);
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
  PointList list_;
  std::vector<std::uint32_t> number_;  ///< in the result, by number in the pool
  Decomposition result_;
};

}  // namespace

RationalPoint Decomposition::position(std::uint32_t point) const {
  return ExactMeshView(MeshView(points, {}), exact).position(point);
}

Polytope Decomposition::polytope(std::uint32_t piece) const {
  Polytope polytope;
  polytope.dimension = 3;
  std::map<std::uint32_t, std::uint32_t> number;  // points are in order already
  for (const Polygon& facet : pieces[piece])
    for (const std::uint32_t point : facet) number.emplace(point, 0);
  auto rational = exact.begin();
  for (auto& [point, n] : number) {
    n = static_cast<std::uint32_t>(polytope.vertices.size());
    polytope.vertices.push_back(points[point]);
    rational = std::lower_bound(rational, exact.end(), point,
                                [](const ExactVertex& e, std::uint32_t p) { return e.vertex < p; });
    if (rational != exact.end() && rational->vertex == point) polytope.exact.push_back({n, rational->position});
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
  const PreparedBoundary boundary(solid.exact_mesh());
  CellMaker maker(boundary.table);
  PiecePool pool(maker);
  const std::size_t cuts = Divider(boundary, maker, pool, monitor).run();
  Decomposition result = Gatherer(boundary, maker, pool).gather();
  result.cuts = cuts;
  result.reflex_edges = static_cast<std::size_t>(
      std::count_if(boundary.wedges.begin(), boundary.wedges.end(), [](const Wedge& w) { return w.is_reflex; }));
  return result;
}

}  // namespace strata::convex
