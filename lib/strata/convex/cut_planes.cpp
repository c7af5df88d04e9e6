#include "strata/convex/cut_planes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>
#include <utility>

namespace strata::convex {
namespace {

constexpr std::size_t most_partners = 4;  ///< planes through an edge and another one
constexpr std::size_t nearest_parallel = 2;
constexpr double nearly = 0x1p-30;  ///< of an estimate; what is parallel is decided exactly

class CutPlanes {
 public:
  CutPlanes(HyperplaneTable<3>& table, std::span<const bsp::Facet<3>> facets, std::span<const Wedge> wedges,
            const Monitor& monitor)
      : monitor_(monitor), table_(table), facets_(facets), wedges_(wedges), through_(wedges.size()) {
    for (std::uint32_t w = 0; w < wedges.size(); ++w)
      if (wedges[w].is_reflex) {
        reflex_.push_back(w);
        ends_[w] = {table.position(wedges[w].ends[0]), table.position(wedges[w].ends[1])};
      }
  }

  std::vector<std::vector<std::uint32_t>> all() {
    for (const std::uint32_t w : reflex_)
      for (const std::uint32_t f : wedges_[w].faces) note(w, facets_[f].piece.hyperplane);
    pair_at_ends();
    pair_parallel();
    return std::move(through_);
  }

 private:
  void note(std::uint32_t wedge, std::uint32_t plane) {
    std::vector<std::uint32_t>& planes = through_[wedge];
    if (std::find(planes.begin(), planes.end(), plane) == planes.end()) planes.push_back(plane);
  }

  [[nodiscard]] const RationalPoint& end(std::uint32_t wedge, std::size_t i) const { return ends_.at(wedge)[i]; }
  /// Notes the plane through edge v and a point of edge w for both, unless one has enough or the point is on v's line.
  void pair(std::uint32_t v, std::uint32_t w, const RationalPoint& apex) {
    if (through_[v].size() >= 2 + most_partners || through_[w].size() >= 2 + most_partners) return;
    const RationalPoint &p = end(v, 0), &q = end(v, 1);
    if (are_collinear(p, q, apex)) return;
    const std::uint32_t plane = table_.add(plane_through(p, q, apex).hyperplane);
    note(v, plane);
    note(w, plane);
  }
  static bool are_collinear(const RationalPoint& p, const RationalPoint& q, const RationalPoint& r) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      if ((q[i] - p[i]) * (r[j] - p[j]) != (q[j] - p[j]) * (r[i] - p[i])) return false;
    }
    return true;
  }

  void pair_at_ends() {
    std::map<RationalPoint, std::vector<std::pair<std::uint32_t, std::size_t>>> at;  // edges and which end
    for (const std::uint32_t w : reflex_)
      for (std::size_t i = 0; i < 2; ++i) at[end(w, i)].emplace_back(w, i);
    for (const auto& [place, edges] : at)
      for (std::size_t i = 0; i < edges.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
          pair(edges[i].first, edges[j].first, end(edges[j].first, 1 - edges[j].second));
  }

  /// Edges by estimated direction; each with those of the nearest middles.
  void pair_parallel() {
    struct Line {
      std::uint32_t wedge;
      Vertex direction, middle;
    };
    std::vector<Line> lines;
    for (const std::uint32_t w : reflex_) {
      Line line{w, {}, {}};
      double length = 0;
      std::size_t longest = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const double a = wedges_[w].ends[0].at[i].value, b = wedges_[w].ends[1].at[i].value;
        line.direction[i] = b / 2 - a / 2;
        line.middle[i] = a / 2 + b / 2;
        length = std::max(length, std::abs(line.direction[i]));
      }
      while (std::abs(line.direction[longest]) != length) ++longest;
      const double unit = line.direction[longest];
      for (double& x : line.direction) x /= unit;
      lines.push_back(line);
    }
    for (const Line& line : lines) {
      monitor_.check();
      std::vector<std::pair<double, std::uint32_t>> parallel;
      for (const Line& other : lines) {
        double apart = 0, distance = 0;
        for (std::size_t i = 0; i < 3; ++i) {
          apart = std::max(apart, std::abs(line.direction[i] - other.direction[i]));
          const double d = line.middle[i] - other.middle[i];
          distance += d * d;
        }
        if (other.wedge != line.wedge && apart < nearly) parallel.emplace_back(distance, other.wedge);
      }
      const std::size_t count = std::min(parallel.size(), nearest_parallel);
      std::partial_sort(parallel.begin(), parallel.begin() + static_cast<std::ptrdiff_t>(count), parallel.end());
      for (std::size_t i = 0; i < count; ++i)
        if (are_parallel(line.wedge, parallel[i].second))
          pair(line.wedge, parallel[i].second, end(parallel[i].second, 0));
    }
  }
  [[nodiscard]] bool are_parallel(std::uint32_t v, std::uint32_t w) const {
    const RationalPoint &a = end(v, 0), &b = end(v, 1), &c = end(w, 0);
    RationalPoint d = end(w, 1);
    for (std::size_t i = 0; i < 3; ++i) d[i] += a[i] - c[i];
    return are_collinear(a, b, d);
  }

  const Monitor& monitor_;
  HyperplaneTable<3>& table_;
  std::span<const bsp::Facet<3>> facets_;
  std::span<const Wedge> wedges_;
  std::vector<std::vector<std::uint32_t>> through_;
  std::vector<std::uint32_t> reflex_;
  std::unordered_map<std::uint32_t, std::array<RationalPoint, 2>> ends_;  ///< of reflex edges
};

}  // namespace

std::vector<std::vector<std::uint32_t>> cut_planes(HyperplaneTable<3>& table, std::span<const bsp::Facet<3>> facets,
                                                   std::span<const Wedge> wedges, const Monitor& monitor) {
  return CutPlanes(table, facets, wedges, monitor).all();
}

}  // namespace strata::convex
