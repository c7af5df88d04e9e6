#include "core/mesh/planar_levels.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace strata::facets {
namespace {

/// Orders the edges that meet the sweep line from below to above. Left of low -> high is above. Vertical edges need no
/// case of their own: the sweep line is tilted according to the lexicographic order.
struct Above {
  const PointTable& points;
  Projection axes;
  const Chain& chain;

  bool operator()(std::size_t i, std::size_t j) const {
    const NetEdge& e = chain[i];
    const NetEdge& f = chain[j];
    if (i == j) return false;
    if (e.low == f.low) return orientation(points, axes, e.low, e.high, f.high) > 0;
    if (points.compare(e.low, f.low) < 0) return orientation(points, axes, e.low, e.high, f.low) > 0;
    return orientation(points, axes, f.low, f.high, e.low) < 0;
  }
};

/// The number of times that the plane is covered just below each edge: front facets minus back facets.
std::vector<std::int64_t> coverage_below(const PointTable& points, Projection axes, const Chain& chain) {
  std::vector<std::size_t> by_end(chain.size());
  for (std::size_t i = 0; i < by_end.size(); ++i) by_end[i] = i;
  std::sort(by_end.begin(), by_end.end(),
            [&](std::size_t i, std::size_t j) { return points.compare(chain[i].high, chain[j].high) < 0; });
  using Status = std::set<std::size_t, Above>;
  Status status(Above{points, axes, chain});
  std::vector<Status::iterator> place(chain.size(), status.end());
  std::vector<std::int64_t> below(chain.size(), 0);
  auto ending = by_end.begin();
  for (std::size_t begin = 0, end = 0; begin < chain.size(); begin = end) {
    const std::uint32_t p = chain[begin].low;
    for (; ending != by_end.end() && points.compare(chain[*ending].high, p) <= 0; ++ending)
      status.erase(place[*ending]);
    for (; end < chain.size() && chain[end].low == p; ++end) place[end] = status.insert(end).first;
    auto lowest = place[begin];
    while (lowest != status.begin() && chain[*std::prev(lowest)].low == p) --lowest;
    for (auto i = lowest; i != status.end() && chain[*i].low == p; ++i) {
      below[*i] = i == status.begin() ? 0 : below[*std::prev(i)] + chain[*std::prev(i)].count;
    }
  }
  return below;
}

}  // namespace

std::vector<Region> covered_regions(const PointTable& points, Projection axes, const Chain& chain) {
  const std::vector<std::int64_t> below = coverage_below(points, axes, chain);
  std::map<std::pair<Facing, std::int64_t>, std::vector<Side>> sides;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const NetEdge& e = chain[i];
    const std::int64_t above = below[i] + e.count;
    const Side side = e.count > 0 ? Side{e.low, e.high} : Side{e.high, e.low};  // the coverage is higher on its left
    for (std::int64_t k = std::min(above, below[i]) + 1; k <= std::max(above, below[i]); ++k) {
      const auto key = k >= 1 ? std::pair{Facing::front, k} : std::pair{Facing::back, 1 - k};
      sides[key].push_back(side);
    }
  }
  std::vector<Region> regions;
  for (auto& [key, list] : sides) regions.push_back({key.first, key.second, std::move(list)});
  return regions;
}

}  // namespace strata::facets
