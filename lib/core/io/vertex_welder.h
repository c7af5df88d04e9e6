#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/containers/hash_index.h"
#include "core/containers/point_hash.h"

namespace strata::io {

/// Numbers the different points of a stream in order of first use. -0 equals 0, and a point keeps the zeros it came
/// with first. Quick as long as it fits into a core's cache. O(1) expected per point.
template <class Scalar>
class VertexWelder {
 public:
  using Point = std::array<Scalar, 3>;

  /// The number of the point. Requires finite coordinates and fewer than 2^32 - 1 different points.
  std::uint32_t add(const Point& p) {
    const auto next = static_cast<std::uint32_t>(points_.size());
    const std::uint32_t number =
        table_.find_or_add(hash_of(p), next, [&](std::uint32_t there) { return are_equal(points_[there], p); });
    if (number == next) keep(p);
    return number;
  }

  /// The different points so far, by number.
  [[nodiscard]] std::vector<Point> copy_points() const { return points_; }

  /// Removes all points and keeps the memory.
  void clear() {
    points_.clear();
    table_.clear();
  }

 private:
  static constexpr std::size_t least_room = (std::size_t{1} << 13) - 1;

  void keep(const Point& p);

  std::vector<Point> points_;
  HashIndex table_{least_room};  ///< numbers of points_
};

}  // namespace strata::io
