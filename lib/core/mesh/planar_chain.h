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

/// How often the straight edge from `low` to `high` (in lexicographic order) is run through in that direction,
/// less how often in the other one. Never zero in a chain.
struct NetEdge {
  std::uint32_t low;
  std::uint32_t high;
  std::int64_t count;
};

using Chain = std::vector<NetEdge>;

/// Sum of the sides: opposite ones cancel. Sorted. O(n log n).
[[nodiscard]] Chain net_chain(const PointTable& points, const std::vector<Side>& sides);

/// The same chain cut wherever an end point of one edge lies inside another, so that overlaps are equal edges, and
/// summed again. Expected O(n sqrt n) integer comparisons, exact turns only where bounding boxes meet.
[[nodiscard]] Chain cut_at_contacts(const PointTable& points, Projection axes, const Chain& chain);

/// A chain cut at contacts, cut where edges cross; the crossings are added to the points.
[[nodiscard]] Chain cut_at_crossings(PointTable& points, Projection axes, const Chain& chain);

}  // namespace strata::facets
