#pragma once
#include <cstdint>
#include <vector>

#include "extensions/planar/predicates.h"
#include "strata/planar.h"

namespace strata::planar {

/// An isolated chain: a stretch of a loop that meets nothing but the two edges next to it. Its edges run between points
/// given as doubles, all within one quadrant of directions, vertical and horizontal ones in the first or the third. So
/// its points are in the order of x, then y, or in the opposite order, and likewise of y, then x. It has corners at
/// both of its ends. The loops must outlive it.
struct MonotoneChain {
  const Loops* loops = nullptr;
  std::uint32_t first = 0, last = 0;  ///< its end vertices, as indices of `Loops::vertices`: first < last

  /// A vertex's position; -0 is 0.
  [[nodiscard]] PlanePoint point(std::uint32_t i) const {
    const PlanePoint& p = loops->places.place[loops->vertices[i]];
    return {p[0] + 0.0, p[1] + 0.0};
  }
};

/// The segments that represent isolated chains: from one end to the other, on a line that gives no other information
/// about them.
struct MonotoneChains {
  std::vector<MonotoneChain> chains;
  std::vector<std::uint32_t> chain_of;  ///< of every segment: its chain, or none. Empty where there are no chains

  [[nodiscard]] bool holds(std::uint32_t segment) const {
    return segment < chain_of.size() && chain_of[segment] != none;
  }
  [[nodiscard]] const MonotoneChain& of(std::uint32_t segment) const { return chains[chain_of[segment]]; }

  /// Side of a point relative to a segment that may represent an isolated chain: positive to the left. For a chain,
  /// requires that it has points at the point's height, or that the point is between its ends in lexicographic order.
  /// O(log n).
  [[nodiscard]] Sign side(const Places& places, std::uint32_t point, std::uint32_t segment) const {
    return holds(segment) ? side_of_chain(places, point, segment) : planar::side(places, point, segment);
  }

 private:
  [[nodiscard]] Sign side_of_chain(const Places& places, std::uint32_t point, std::uint32_t segment) const;
};

namespace closer {
[[nodiscard]] Sign orientation(const PlanePoint& p, const PlanePoint& q, const PlanePoint& r);
}

/// Orientation of three points: positive when counter-clockwise. Exact.
[[nodiscard]] inline Sign orientation(const PlanePoint& p, const PlanePoint& q, const PlanePoint& r) {
  const int sign = filtered_orientation(p, q, r);
  return sign != 0 ? static_cast<Sign>(sign) : closer::orientation(p, q, r);
}

}  // namespace strata::planar
