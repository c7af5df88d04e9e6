#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "extensions/contact/parts.h"
#include "extensions/contact/places.h"

namespace strata::contact {

/// The intersections of pairs of faces of two parts, by numbers of positions: convex polygons, segments and points.
/// Each once.
struct SharedPieces {
  using Polygon = std::vector<std::uint32_t>;
  using Segment = std::array<std::uint32_t, 2>;  ///< the lower number first

  Places places;
  std::vector<Polygon> polygons;  ///< counter-clockwise as seen from outside of the first part; interiors are disjoint
  std::vector<Segment> segments;  ///< except sides of polygons; sorted
  std::vector<std::uint32_t> points;  ///< except ends of segments and corners of polygons; sorted
  std::vector<Segment> sides;         ///< of polygons; sorted
};

/// Throws Cancelled.
[[nodiscard]] SharedPieces shared_pieces(const Parts& parts, std::uint32_t a, std::uint32_t b, const Monitor& monitor);

}  // namespace strata::contact
