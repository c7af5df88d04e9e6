#include "strata/convex/decompose.h"

#include <algorithm>
#include <map>
#include <unordered_map>
#include <utility>

#include "strata/bsp/triangle_facets.h"
#include "strata/convex/cell.h"
#include "strata/convex/cut_planes.h"
#include "strata/convex/wedges.h"
#include "strata/mesh/defect.h"

namespace strata::convex {
namespace {

constexpr std::size_t most_candidates = 32;  ///< planes through reflex edges that are tried

/// A triangle of the boundary, as far as it is in a region.
struct Face {
  std::uint32_t triangle = 0;
  bsp::Piece<3> part;
};

/// A wedge, as far as its edge goes through a region or bounds it.
struct Edge {
  std::uint32_t wedge = 0;
  std::array<Corner<3>, 2> ends;
};

/// What is in a convex part of space: a cell, and all of the solid's boundary in it.
struct Region {
  Cell cell;
  std::vector<Face> faces;
  std::vector<Edge> edges;
};

bool contains(const std::vector<std::uint32_t>& planes, std::uint32_t plane) {
  return std::find(planes.begin(), planes.end(), plane) != planes.end();
}

class Decomposer {
 public:
  Decomposer(ExactMeshView mesh, const Monitor& monitor)
      : facets_(bsp::triangle_facets(table_, mesh)),
        wedges_(wedges_of(table_, facets_, mesh)),
        planes_(cut_planes(table_, facets_, wedges_)),
        maker_(table_),
        monitor_(monitor),
        set_of_(facets_.size()) {}

  Decomposition run() {
    Decomposition result;
    if (facets_.empty()) return result;
    Region all{maker_.space(), {}, {}};
    for (std::uint32_t t = 0; t < facets_.size(); ++t) all.faces.push_back({t, facets_[t].piece});
    for (std::uint32_t w = 0; w < wedges_.size(); ++w) {
      all.edges.push_back({w, wedges_[w].ends});
      result.reflex_edges += wedges_[w].is_reflex ? 1 : 0;
    }
    divide(std::move(all));
    result.pieces = polytopes();
    return result;
  }

 private:
  /// Divides a region until nothing in it is reflex, and joins what need not have been divided.
  void divide(Region region) {
    monitor_.check();
    const std::size_t first = pieces_.size();
    const std::optional<std::uint32_t> cut = choose_cut(region);
    if (!cut) {
      add_piece(inside_of(region));
      return;
    }
    Sides sides = split(std::move(region), *cut);
    divide_side(std::move(sides.minus), sides.is_inside[0]);
    divide_side(std::move(sides.plus), sides.is_inside[1]);
    join(first, *cut);
  }

  /// A side without faces is inside or outside as a whole.
  void divide_side(Region region, bool is_inside) {
    if (!region.faces.empty()) return divide(std::move(region));
    if (is_inside) add_piece(std::move(region.cell));
  }

  struct Sides {
    Region minus, plus;
    /// Of minus and plus, if there are no faces: next to faces in the plane that divides. If there are none, the plane goes
    /// through a reflex edge, and what is outside there takes less than a side.
    std::array<bool, 2> is_inside{true, true};
  };

  Sides split(Region region, std::uint32_t cut) {
    Sides sides;
    CellMaker::Halves halves = maker_.split(region.cell, cut);
    if (!halves.minus || !halves.plus) throw LogicError("a plane through a region does not divide it");
    sides.minus.cell = std::move(*halves.minus);
    sides.plus.cell = std::move(*halves.plus);
    for (Face& f : region.faces) {
      bsp::Split<3> parts = bsp::split(table_, f.part, cut);
      lie_[f.triangle] = parts.lie;
      switch (parts.lie) {
        case bsp::Lie::on:
          sides.is_inside = {facets_[f.triangle].faces_plus, !facets_[f.triangle].faces_plus};
          break;
        case bsp::Lie::minus:
          sides.minus.faces.push_back(std::move(f));
          break;
        case bsp::Lie::plus:
          sides.plus.faces.push_back(std::move(f));
          break;
        case bsp::Lie::both:
          sides.minus.faces.push_back({f.triangle, std::move(parts.minus)});
          sides.plus.faces.push_back({f.triangle, std::move(parts.plus)});
          break;
      }
    }
    for (const Edge& e : region.edges) split(e, cut, sides);
    return sides;
  }

  void split(const Edge& e, std::uint32_t cut, Sides& sides) {
    const Sign from = table_.side(cut, e.ends[0]), to = table_.side(cut, e.ends[1]);
    if (from == Sign::zero && to == Sign::zero) {
      // Resolved, or an edge of the region if the whole wedge is on one side.
      const Wedge& w = wedges_[e.wedge];
      const bsp::Lie lie = lie_[w.faces[0]];
      if (w.is_reflex || lie != lie_[w.faces[1]]) return;
      if (lie == bsp::Lie::minus) sides.minus.edges.push_back(e);
      if (lie == bsp::Lie::plus) sides.plus.edges.push_back(e);
      return;
    }
    if (from * to == Sign::negative) {
      const Wedge& w = wedges_[e.wedge];
      const Corner<3> middle = table_.meet({w.planes[0], w.planes[1], cut});
      (from == Sign::negative ? sides.minus : sides.plus).edges.push_back({e.wedge, {e.ends[0], middle}});
      (to == Sign::negative ? sides.minus : sides.plus).edges.push_back({e.wedge, {middle, e.ends[1]}});
      return;
    }
    (from == Sign::negative || to == Sign::negative ? sides.minus : sides.plus).edges.push_back(e);
  }

  /// A plane through a reflex edge; if there is none, a plane between connected parts of the boundary; nothing if there
  /// is one part only: then what is inside is convex.
  std::optional<std::uint32_t> choose_cut(const Region& region) {
    if (const auto cut = cut_through_reflex_edge(region)) return cut;
    return cut_between_parts(region);
  }

  std::optional<std::uint32_t> cut_through_reflex_edge(const Region& region) const {
    std::vector<const Edge*> reflex;
    std::map<std::uint32_t, std::size_t> edges_in;  // by plane
    for (const Edge& e : region.edges) {
      const Wedge& w = wedges_[e.wedge];
      if (!w.is_reflex) continue;
      reflex.push_back(&e);
      for (const std::uint32_t plane : planes_[e.wedge]) ++edges_in[plane];
    }
    if (reflex.empty()) return std::nullopt;
    std::vector<std::pair<std::size_t, std::uint32_t>> candidates;
    for (const auto& [plane, count] : edges_in) candidates.emplace_back(count, plane);
    const std::size_t tried = std::min(candidates.size(), most_candidates);
    std::partial_sort(
        candidates.begin(), candidates.begin() + static_cast<std::ptrdiff_t>(tried), candidates.end(),
        [](const auto& a, const auto& b) { return a.first != b.first ? a.first > b.first : a.second < b.second; });
    std::optional<std::uint32_t> best;
    double highest = 0;
    for (std::size_t k = 0; k < tried; ++k) {
      const double score = worth(reflex, candidates[k].second);
      if (best && score <= highest) continue;
      best = candidates[k].second;
      highest = score;
    }
    return best;
  }

  /// Reflex edges that a plane resolves, minus those that it divides.
  [[nodiscard]] double worth(const std::vector<const Edge*>& reflex, std::uint32_t plane) const {
    double worth = 0;
    for (const Edge* e : reflex) {
      if (contains(planes_[e->wedge], plane)) {
        worth += 1;
        continue;
      }
      const Sign from = table_.side(plane, e->ends[0]), to = table_.side(plane, e->ends[1]);
      if (from == Sign::zero && to == Sign::zero) worth += 1;
      if (from * to == Sign::negative) worth -= 1;
    }
    return worth;
  }

  /// Connected parts of the boundary in a region, as lists of its faces.
  std::vector<std::vector<const Face*>> parts_of(const Region& region) {
    for (const Face& f : region.faces) set_of_[f.triangle] = f.triangle;
    for (const Edge& e : region.edges) {
      const auto [a, b] = wedges_[e.wedge].faces;
      set_of_[set_root(a)] = set_root(b);
    }
    std::map<std::uint32_t, std::size_t> number;
    std::vector<std::vector<const Face*>> parts;
    for (const Face& f : region.faces) {
      const auto [at, is_new] = number.try_emplace(set_root(f.triangle), parts.size());
      if (is_new) parts.emplace_back();
      parts[at->second].push_back(&f);
    }
    return parts;
  }
  std::uint32_t set_root(std::uint32_t t) {
    while (set_of_[t] != t) t = set_of_[t] = set_of_[set_of_[t]];
    return t;
  }

  std::optional<std::uint32_t> cut_between_parts(const Region& region) {
    const auto parts = parts_of(region);
    if (parts.size() == 1) return std::nullopt;
    std::optional<std::uint32_t> best;
    double lowest = 0;
    for (std::size_t k = 0; k < std::min<std::size_t>(parts.size(), 6); ++k)
      for (std::size_t i = 0; i < std::min<std::size_t>(parts[k].size(), 6); ++i) {
        const std::uint32_t plane =
            facets_[parts[k][i * parts[k].size() / std::min<std::size_t>(parts[k].size(), 6)]->triangle]
                .piece.hyperplane;
        const double cost = cost_between(parts, plane);
        if (best && cost >= lowest) continue;
        best = plane;
        lowest = cost;
      }
    return best;
  }

  /// Parts that a plane divides, and how uneven it leaves the others.
  [[nodiscard]] double cost_between(const std::vector<std::vector<const Face*>>& parts, std::uint32_t plane) const {
    double divided = 0, minus = 0, plus = 0;
    for (const auto& part : parts) {
      bool is_minus = false, is_plus = false;
      for (const Face* f : part) {
        const bsp::Lie lie = bsp::lie_of(table_, f->part, plane);
        is_minus |= lie == bsp::Lie::minus || lie == bsp::Lie::both;
        is_plus |= lie == bsp::Lie::plus || lie == bsp::Lie::both;
        if (is_minus && is_plus) break;
      }
      divided += is_minus && is_plus ? 1 : 0;
      minus += is_minus ? 1 : 0;
      plus += is_plus ? 1 : 0;
    }
    return 4 * divided + std::max(minus, plus);
  }

  /// The part of a region inside the solid, if it is convex and its boundary there is one part: facets from the sides
  /// that their neighbours and the region give them, and what is left of the facets of the region.
  Cell inside_of(const Region& region) {
    std::map<std::uint32_t, Bounds> bounds;  // by plane
    for (const Face& f : region.faces) bounds[plane_of(f.triangle)].faces_plus = facets_[f.triangle].faces_plus;
    for (const Edge& e : region.edges) {
      const auto [f, g] = wedges_[e.wedge].faces;
      if (plane_of(f) == plane_of(g)) continue;
      bounds[plane_of(f)].by.push_back(behind(g));
      bounds[plane_of(g)].by.push_back(behind(f));
    }
    Cell inside;
    for (const CellFacet& f : region.cell.facets) {
      if (HyperplaneTable<3>::is_frame(f.plane)) continue;
      bsp::Piece<3> polygon = maker_.piece_of(f);
      const bool is_left = std::all_of(bounds.begin(), bounds.end(), [&](const auto& of_plane) {
        return clip(polygon, behind(of_plane.first, of_plane.second.faces_plus));
      });
      if (is_left) inside.facets.push_back(maker_.facet_of(polygon, f.faces_plus));
    }
    const std::size_t of_region = inside.facets.size();
    for (auto& [plane, of_plane] : bounds) {
      bsp::Piece<3> polygon = bsp::whole(table_, plane);
      for (const bsp::HalfSpace& h : of_plane.by) require(bsp::clip(table_, polygon, h));
      for (std::size_t i = 0; i < of_region; ++i)
        require(bsp::clip(table_, polygon, behind(inside.facets[i])));
      inside.facets.push_back(maker_.facet_of(polygon, of_plane.faces_plus));
    }
    return inside;
  }

  /// Clips a facet by the plane of another one. A side in that plane has it as its wall then: what was beyond it is cut
  /// off.
  bool clip(bsp::Piece<3>& polygon, const bsp::HalfSpace& h) const {
    if (!bsp::clip(table_, polygon, h)) return false;
    const std::size_t n = polygon.corners.size();
    const auto is_on = [&](std::size_t i) { return table_.side(h.hyperplane, polygon.corners[i]) == Sign::zero; };
    for (std::size_t i = 0; i < n; ++i)
      if (is_on(i) && is_on((i + 1) % n)) polygon.walls[i] = h.hyperplane;
    return true;
  }

  /// What bounds a facet: the half-spaces of the facets beside it.
  struct Bounds {
    bool faces_plus = false;
    std::vector<bsp::HalfSpace> by;
  };

  static void require(bool is_left) {
    if (!is_left) throw LogicError("a facet of a convex piece has no area");
  }
  static bsp::HalfSpace behind(std::uint32_t plane, bool faces_plus) {
    return {plane, faces_plus ? Sign::negative : Sign::positive};
  }
  static bsp::HalfSpace behind(const CellFacet& f) { return behind(f.plane, f.faces_plus); }
  [[nodiscard]] bsp::HalfSpace behind(std::uint32_t triangle) const {
    return behind(plane_of(triangle), facets_[triangle].faces_plus);
  }
  [[nodiscard]] std::uint32_t plane_of(std::uint32_t triangle) const { return facets_[triangle].piece.hyperplane; }

  void add_piece(Cell cell) {
    const auto number = static_cast<std::uint32_t>(pieces_.size());
    for (const CellFacet& f : cell.facets) pieces_in_[f.plane].push_back(number);
    pieces_.push_back(std::move(cell));
    is_gone_.push_back(false);
  }

  /// Joins pieces from `first` on where the union is convex: those on both sides of a plane, and then whatever has
  /// become possible.
  void join(std::size_t first, std::uint32_t plane) {
    std::vector<std::uint32_t> waiting;
    for (const std::uint32_t p : pieces_in_[plane])
      if (p >= first && !is_gone_[p]) waiting.push_back(p);
    for (std::size_t k = 0; k < waiting.size(); ++k) {
      const std::uint32_t p = waiting[k];
      if (!is_gone_[p] && join_with_any(p, first)) waiting.push_back(static_cast<std::uint32_t>(pieces_.size() - 1));
    }
  }

  bool join_with_any(std::uint32_t p, std::size_t first) {
    for (const CellFacet& f : pieces_[p].facets) {
      const std::vector<std::uint32_t>& others = pieces_in_[f.plane];
      for (std::size_t i = others.size(); i-- > 0 && others[i] >= first;) {
        const std::uint32_t q = others[i];
        if (q == p || is_gone_[q]) continue;
        std::optional<Cell> both = maker_.merged(pieces_[p], pieces_[q], f.plane);
        if (!both) continue;
        is_gone_[p] = is_gone_[q] = true;
        add_piece(std::move(*both));
        return true;
      }
    }
    return false;
  }

  std::vector<Polytope> polytopes();

  HyperplaneTable<3> table_;
  std::vector<bsp::Facet<3>> facets_;
  std::vector<Wedge> wedges_;
  std::vector<std::vector<std::uint32_t>> planes_;  ///< by wedge, those that resolve it
  CellMaker maker_;
  const Monitor& monitor_;
  std::vector<std::uint32_t> set_of_;                ///< triangles of one part of a region, as a forest
  std::unordered_map<std::uint32_t, bsp::Lie> lie_;  ///< of triangles, at the plane that divides
  std::vector<Cell> pieces_;
  std::vector<bool> is_gone_;                                                ///< joined with another one
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> pieces_in_;  ///< with a facet in a plane, rising
};

std::vector<Polytope> Decomposer::polytopes() {
  std::vector<Polytope> result;
  for (std::size_t p = 0; p < pieces_.size(); ++p) {
    if (is_gone_[p]) continue;
    Polytope polytope;
    polytope.dimension = 3;
    std::map<RationalPoint, std::uint32_t> number;
    std::unordered_map<std::uint32_t, RationalPoint> at;
    for (const CellFacet& f : pieces_[p].facets)
      for (const std::uint32_t c : f.corners)
        if (!at.contains(c)) number.emplace(at.emplace(c, table_.position(maker_.corner(c))).first->second, 0);
    for (auto& [place, n] : number) {
      n = static_cast<std::uint32_t>(polytope.vertices.size());
      Vertex v{};
      bool is_exact = true;
      for (std::size_t i = 0; i < 3; ++i) {
        v[i] = to_nearest_double(place[i]);
        is_exact &= to_rational(v[i]) == place[i];
      }
      if (!is_exact) polytope.exact.push_back({n, place});
      polytope.vertices.push_back(v);
    }
    for (const CellFacet& f : pieces_[p].facets) {
      polytope.facets.emplace_back();
      for (const std::uint32_t c : f.corners) polytope.facets.back().push_back(number.at(at.at(c)));
    }
    result.push_back(std::move(polytope));
  }
  return result;
}

}  // namespace

Decomposition decompose(const Solid& solid, const Monitor& monitor) {
  return Decomposer(solid.exact_mesh(), monitor).run();
}

}  // namespace strata::convex
