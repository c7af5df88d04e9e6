#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/mesh/corner_hash.h"

namespace strata::io {

/// Numbers the different points of a stream in order of first use. -0 equals 0; a point keeps the zeros of its first
/// use. An open hash table, which is fast while it fits into a core's cache. O(1) expected per point.
template <class Scalar>
class VertexWelder {
 public:
  using Point = std::array<Scalar, 3>;

  VertexWelder() : slots_(least_slots) {}

  /// The number of the point. Requires finite coordinates and fewer than 2^32 - 1 different points.
  std::uint32_t add(const Point& p) {
    const std::size_t mask = slots_.size() - 1;
    std::size_t at = hash_of(p) & mask;
    while (slots_[at] != 0) {
      const std::uint32_t number = slots_[at] - 1;
      if (are_equal(points_[number], p)) return number;
      at = (at + 1) & mask;
    }
    return add_at(at, p);
  }

  /// The different points so far, by number.
  [[nodiscard]] std::vector<Point> copy_points() const { return points_; }

  /// Removes all points and keeps the memory.
  void clear() {
    points_.clear();
    std::fill(slots_.begin(), slots_.end(), 0);
  }

 private:
  static constexpr std::size_t least_slots = std::size_t{1} << 14;

  std::uint32_t add_at(std::size_t slot, const Point& p) {
    points_.push_back(p);
    slots_[slot] = static_cast<std::uint32_t>(points_.size());
    if (2 * points_.size() >= slots_.size()) grow();
    return static_cast<std::uint32_t>(points_.size() - 1);
  }
  void grow();

  std::vector<Point> points_;
  std::vector<std::uint32_t> slots_;  ///< number + 1, or 0 where free; a power of two, at most half full
};

}  // namespace strata::io
