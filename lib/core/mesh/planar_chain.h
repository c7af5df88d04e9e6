#pragma once
#include <cstdint>
#include <vector>

#include "core/mesh/planar_points.h"

namespace strata::facets {

/// A directed side of a facet.
struct Side {
  std::uint32_t from;
  std::uint32_t to;
};

/// How often the straight edge from `low` to `high` (in lexicographic order) occurs in that direction, minus how often
/// it occurs in the other one. Never zero in a chain.
struct NetEdge {
  std::uint32_t low;
  std::uint32_t high;
  std::int64_t count;
};

using Chain = std::vector<NetEdge>;

/// Sum of the sides: opposite ones cancel. Sorted. O(n log n).
[[nodiscard]] Chain net_chain(const PointTable& points, const std::vector<Side>& sides);

/// The same chain, divided wherever an end point of one edge lies inside another, so that overlaps are equal edges, and
/// summed again. Expected O(n sqrt n) integer comparisons; exact orientation tests only where bounding boxes meet.
[[nodiscard]] Chain cut_at_contacts(const PointTable& points, Projection axes, const Chain& chain);

/// A chain divided at contacts, divided further where edges cross. The crossings are added to the points.
[[nodiscard]] Chain cut_at_crossings(PointTable& points, Projection axes, const Chain& chain);

}  // namespace strata::facets
