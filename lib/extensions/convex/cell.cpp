#include "extensions/convex/cell.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/containers/point_hash.h"
#include "strata/errors.h"

namespace strata::convex {
namespace {

constexpr auto minus_side = Sign::negative, plus_side = Sign::positive;

std::size_t next(std::size_t i, std::size_t count) { return i + 1 == count ? 0 : i + 1; }

bool are_apart(const Bounded& x, const Bounded& y) { return x.upper() < y.lower() || y.upper() < x.lower(); }

void turn_round(CellFacet& facet) {
  std::reverse(facet.corners.begin(), facet.corners.end());
  std::reverse(facet.walls.begin(), facet.walls.end() - 1);
}

}  // namespace

const CellFacet* Cell::facet_in(std::uint32_t plane) const {
  for (const CellFacet& f : facets)
    if (f.plane == plane) return &f;
  return nullptr;
}

std::size_t CellMaker::NamesHash::operator()(const std::array<std::uint32_t, 3>& names) const {
  return folded_product(std::uint64_t{names[0]} << 32 | names[1], names[2] ^ 0x9e3779b97f4a7c15u);
}

std::uint32_t CellMaker::add(HyperplaneMeet<3> corner) {
  std::array<std::uint32_t, 3> names = corner.names;
  std::sort(names.begin(), names.end());
  const auto [known, is_new] = numbers_.try_emplace(names, static_cast<std::uint32_t>(corners_.size()));
  if (is_new) {
    corners_.push_back(std::move(corner));
    same_as_.push_back(known->second);
  }
  return known->second;
}

std::uint32_t CellMaker::representative(std::uint32_t corner) {
  while (same_as_[corner] != corner) corner = same_as_[corner] = same_as_[same_as_[corner]];
  return corner;
}

bool CellMaker::is_same(std::uint32_t a, std::uint32_t b) {
  a = representative(a);
  b = representative(b);
  if (a == b) return true;
  const HyperplaneMeet<3>&p = corners_[a], &q = corners_[b];
  for (std::size_t i = 0; i < 3; ++i)
    if (are_apart(p.at[i], q.at[i])) return false;
  for (const std::uint32_t plane : q.names)
    if (table_.side(plane, p) != Sign::zero) return false;
  same_as_[std::max(a, b)] = std::min(a, b);
  return true;
}

bool CellMaker::are_boxes_apart(const CellFacet& f, const CellFacet& g) const {
  for (std::size_t i = 0; i < 3; ++i) {
    const auto range = [&](const CellFacet& facet) {
      double lower = HUGE_VAL, upper = -HUGE_VAL;
      for (const std::uint32_t c : facet.corners) {
        lower = std::min(lower, corners_[c].at[i].lower());
        upper = std::max(upper, corners_[c].at[i].upper());
      }
      return std::pair(lower, upper);
    };
    const auto [f_lower, f_upper] = range(f);
    const auto [g_lower, g_upper] = range(g);
    if (f_upper < g_lower || g_upper < f_lower) return true;
  }
  return false;
}

Cell CellMaker::box() {
  Cell cell;
  for (const auto& [lower, upper] : box_) {
    cell.facets.push_back(facet_of(whole(lower), false));
    cell.facets.push_back(facet_of(whole(upper), true));
  }
  return cell;
}

bool CellMaker::is_of_box(std::uint32_t plane) const {
  return std::any_of(box_.begin(), box_.end(), [&](const auto& two) { return two[0] == plane || two[1] == plane; });
}

CellFacet CellMaker::facet_of(const bsp::Piece<3>& polygon, bool faces_plus) {
  CellFacet facet{polygon.hyperplane, faces_plus, {}, {}};
  for (const HyperplaneMeet<3>& c : polygon.corners) facet.corners.push_back(add(c));
  facet.walls.assign(polygon.walls.begin(), polygon.walls.end());
  if (!faces_plus) turn_round(facet);
  return facet;
}

bsp::Piece<3> CellMaker::piece_of(const CellFacet& facet) const {
  CellFacet seen_from_plus = facet;
  if (!facet.faces_plus) turn_round(seen_from_plus);
  bsp::Piece<3> polygon;
  polygon.hyperplane = facet.plane;
  for (const std::uint32_t c : seen_from_plus.corners) polygon.corners.push_back(corners_[c]);
  polygon.walls.assign(seen_from_plus.walls.begin(), seen_from_plus.walls.end());
  return polygon;
}

/// Divides a cell by a plane.
class CellMaker::Splitter {
 public:
  Splitter(CellMaker& maker, const Cell& cell, std::uint32_t plane) : maker_(maker), cell_(cell), plane_(plane) {
    maker.signs_.resize(maker.corners_.size());
    ++maker.split_;
    for (const CellFacet& f : cell.facets)
      for (const std::uint32_t c : f.corners) {
        auto& [split, sign] = maker.signs_[c];
        if (split == maker.split_) continue;
        split = maker.split_;
        sign = maker.table_.side(plane, maker.corners_[c]);
        is_minus_ |= sign == Sign::negative;
        is_plus_ |= sign == Sign::positive;
      }
  }

  [[nodiscard]] bool reaches(Sign side) const { return side == minus_side ? is_minus_ : is_plus_; }

  /// The part on one side. Requires that the cell is on both.
  Cell part(Sign side) {
    Cell half;
    std::vector<CapSide> cap;
    for (const CellFacet& f : cell_.facets)
      if (auto facet = part(f, side, cap)) half.facets.push_back(std::move(*facet));
    half.facets.push_back(joined(std::move(cap), side));
    return half;
  }

 private:
  /// A side of the new facet, from corner to corner, and the facet beyond it.
  struct CapSide {
    std::uint32_t from, to, wall;
  };

  [[nodiscard]] Sign sign(std::uint32_t corner) const { return maker_.signs_[corner].second; }

  std::uint32_t crossing(std::uint32_t a, std::uint32_t b, std::uint32_t plane, std::uint32_t wall) {
    const auto [low, high] = std::minmax(a, b);
    for (const auto& [edge, corner] : crossings_)
      if (edge == std::pair(low, high)) return corner;
    const std::uint32_t corner = maker_.add(maker_.table_.meet({plane, wall, plane_}));
    crossings_.push_back({{low, high}, corner});
    return corner;
  }

  std::optional<CellFacet> part(const CellFacet& f, Sign side, std::vector<CapSide>& cap) {
    CellFacet kept{f.plane, f.faces_plus, {}, {}};
    boost::container::small_vector<bool, 8> is_on;
    bool is_inside = false;
    const std::size_t n = f.corners.size();
    for (std::size_t i = 0; i < n; ++i) {
      const std::uint32_t a = f.corners[i], b = f.corners[next(i, n)];
      const Sign here = sign(a), there = sign(b);
      is_inside |= here == side;
      if (here != -side) {
        kept.corners.push_back(a);
        kept.walls.push_back(f.walls[i]);
        is_on.push_back(here == Sign::zero);
      }
      if (here * there != Sign::negative) continue;
      kept.corners.push_back(crossing(a, b, f.plane, f.walls[i]));
      kept.walls.push_back(f.walls[i]);
      is_on.push_back(true);
    }
    if (!is_inside) return std::nullopt;
    for (std::size_t i = 0; i < kept.corners.size(); ++i) {
      const std::size_t j = next(i, kept.corners.size());
      if (!is_on[i] || !is_on[j]) continue;
      kept.walls[i] = plane_;
      cap.push_back({kept.corners[j], kept.corners[i], f.plane});
    }
    return kept;
  }

  [[nodiscard]] CellFacet joined(std::vector<CapSide> sides, Sign side) const {
    CellFacet facet{plane_, side == minus_side, {}, {}};
    for (std::uint32_t at = sides.front().from; facet.corners.size() < sides.size();) {
      const auto s = std::find_if(sides.begin(), sides.end(), [&](const CapSide& c) { return c.from == at; });
      if (s == sides.end()) throw LogicError("the section of a convex cell is not closed");
      facet.corners.push_back(at);
      facet.walls.push_back(s->wall);
      at = s->to;
    }
    return facet;
  }

  CellMaker& maker_;
  const Cell& cell_;
  std::uint32_t plane_;
  bool is_minus_ = false, is_plus_ = false;
  boost::container::small_vector<std::pair<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t>, 8> crossings_;
};

CellMaker::Halves CellMaker::split(const Cell& cell, std::uint32_t plane) {
  Splitter splitter(*this, cell, plane);
  if (!splitter.reaches(plus_side)) return {cell, std::nullopt};
  if (!splitter.reaches(minus_side)) return {std::nullopt, cell};
  Halves halves;
  halves.minus = splitter.part(minus_side);
  halves.plus = splitter.part(plus_side);
  return halves;
}

/// Joins two cells at a plane.
class CellMaker::Merger {
 public:
  Merger(CellMaker& maker, const Cell& a, const Cell& b, std::uint32_t plane)
      : maker_(maker), a_(a), b_(b), plane_(plane) {}

  std::optional<Cell> merge() {
    if (!match_facets() || !is_convex()) return std::nullopt;
    Cell result;
    for (const CellFacet& f : a_.facets) {
      if (f.plane == plane_) continue;
      const CellFacet* g = b_.facet_in(f.plane);
      result.facets.push_back(g == nullptr ? renamed(f, wall_of_a_) : joined(f, *g));
    }
    for (const CellFacet& g : b_.facets)
      if (g.plane != plane_ && a_.facet_in(g.plane) == nullptr) result.facets.push_back(renamed(g, wall_of_b_));
    return result;
  }

 private:
  /// True when both have the same facet; collects, side by side, the neighbouring planes of both.
  bool match_facets() {
    const CellFacet &f = *a_.facet_in(plane_), &g = *b_.facet_in(plane_);
    const std::size_t n = f.corners.size();
    if (g.corners.size() != n || f.faces_plus == g.faces_plus) return false;
    std::size_t at = 0;  // of f's first corner in g, which runs the other way
    while (at < n && !maker_.is_same(f.corners[0], g.corners[at])) ++at;
    if (at == n) return false;
    for (std::size_t i = 0; i < n; ++i)
      if (!maker_.is_same(f.corners[i], g.corners[(at + n - i) % n])) return false;
    for (std::size_t i = 0; i < n; ++i) {
      const std::uint32_t wall = g.walls[(at + 2 * n - i - 1) % n];
      wall_of_a_.emplace_back(f.walls[i], wall);
      wall_of_b_.emplace_back(wall, f.walls[i]);
    }
    return true;
  }

  [[nodiscard]] bool is_convex() const {
    return std::all_of(wall_of_a_.begin(), wall_of_a_.end(), [&](const auto& walls) {
      const CellFacet &f = *a_.facet_in(walls.first), &g = *b_.facet_in(walls.second);
      if (f.plane == g.plane) return f.faces_plus == g.faces_plus;
      const Sign side = maker_.table_.side(f.plane, maker_.corners_[corner_off_plane(g)]);
      return side == (f.faces_plus ? minus_side : plus_side);
    });
  }

  /// A corner of a facet with a side in the plane, which is not in the plane: the one after that side.
  [[nodiscard]] std::uint32_t corner_off_plane(const CellFacet& g) const {
    const std::size_t n = g.corners.size(), side = side_at_plane(g);
    return g.corners[(side + 2) % n];
  }
  [[nodiscard]] std::size_t side_at_plane(const CellFacet& f) const {
    const auto at = std::find(f.walls.begin(), f.walls.end(), plane_);
    if (at == f.walls.end()) throw LogicError("facets of merged cells do not meet in their common facet");
    return static_cast<std::size_t>(at - f.walls.begin());
  }

  /// A facet of one cell alone has the other cell's facet as its neighbour beyond the plane now.
  [[nodiscard]] CellFacet renamed(const CellFacet& f,
                                  const std::vector<std::pair<std::uint32_t, std::uint32_t>>& beyond) const {
    CellFacet result = f;
    for (std::uint32_t& wall : result.walls)
      if (wall == plane_)
        wall = std::find_if(beyond.begin(), beyond.end(), [&](const auto& w) { return w.first == f.plane; })->second;
    return result;
  }

  /// The union of facets in one plane: the sides of f after the common one, then those of g. Where the same
  /// neighbouring plane continues, the corner is no vertex any more.
  [[nodiscard]] CellFacet joined(const CellFacet& f, const CellFacet& g) const {
    CellFacet result{f.plane, f.faces_plus, {}, {}};
    append(f, side_at_plane(f), result);
    append(g, side_at_plane(g), result);
    if (result.walls.front() == result.walls.back()) {
      result.corners.erase(result.corners.begin());
      result.walls.erase(result.walls.begin());
    }
    return result;
  }
  static void append(const CellFacet& f, std::size_t common, CellFacet& result) {
    const std::size_t n = f.corners.size();
    for (std::size_t k = 1; k < n; ++k) {
      const std::size_t i = (common + k) % n;
      if (!result.walls.empty() && result.walls.back() == f.walls[i]) continue;
      result.corners.push_back(f.corners[i]);
      result.walls.push_back(f.walls[i]);
    }
  }

  CellMaker& maker_;
  const Cell &a_, &b_;
  std::uint32_t plane_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> wall_of_a_,
      wall_of_b_;  ///< own neighbouring plane, and the other cell's there
};

std::optional<Cell> CellMaker::merged(const Cell& a, const Cell& b, std::uint32_t plane) {
  return Merger(*this, a, b, plane).merge();
}

}  // namespace strata::convex
