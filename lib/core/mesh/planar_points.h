#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "core/kernel/predicates.h"
#include "core/kernel/rational_point.h"
#include "strata/monitor.h"

namespace strata::facets {

/// Distinct points, named by numbers. Points given at the start are numbered in lexicographic order, so numbers compare
/// as the points do, also along any line. Points added later have larger numbers and are compared exactly.
class PointTable {
 public:
  /// Sorts the points; `name_of[i]` becomes the number of points[i]. Throws Cancelled. O(n log n).
  PointTable(std::vector<HPoint<Integer>> points, std::vector<std::uint32_t>& name_of, const Monitor& monitor = {});

  std::uint32_t add(HPoint<Integer> p);  ///< a point that may equal one in the table

  [[nodiscard]] const HPoint<Integer>& operator[](std::uint32_t name) const { return points_[name]; }
  [[nodiscard]] std::size_t size() const { return points_.size(); }
  [[nodiscard]] bool has_added() const { return points_.size() > sorted_; }

  /// Lexicographic order: negative, zero or positive.
  [[nodiscard]] int compare(std::uint32_t a, std::uint32_t b) const;

  /// Rank of a point given at the start among the y (axis 1) or z (axis 2) coordinates; equal coordinates have equal
  /// ranks.
  [[nodiscard]] std::uint32_t rank(std::uint32_t name, int axis) const { return ranks_[axis - 1][name]; }

 private:
  std::vector<HPoint<Integer>> points_;
  std::size_t sorted_;
  std::array<std::vector<std::uint32_t>, 2> ranks_;
};

/// Orientation of a, b, c in the projection: 1 counter-clockwise, -1 clockwise, 0 collinear.
[[nodiscard]] int orientation(const PointTable& points, Projection axes, std::uint32_t a, std::uint32_t b,
                              std::uint32_t c);

}  // namespace strata::facets
