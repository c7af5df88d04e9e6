#pragma once
#include "strata/planar/loops.h"

namespace strata::plane {

/// A bounded open regular set: polygons, the components of its interior (source document, 3.1 and 3.3), exclusive.
///
/// What holds: every loop is simple (a clean polyloop); loops meet in vertices only. A polygon's outer loop is
/// counter-clockwise, its holes are clockwise: the polygon lies to the left of every edge. Where a polygon's boundary
/// touches itself, loops share the vertex, so a polygon without holes is simple. Vertices are corners, or are on the
/// boundary more than once: no edge goes straight on elsewhere. Every loop starts at its lexicographically least
/// vertex; polygons, and the holes of each, are in the order of their first vertices, then of their second ones: what is
/// listed, and in which order, depends on the set alone. `places.place` of every point is its nearest double.
struct Region {
  Loops loops;
  std::vector<std::uint32_t> first_loop{
      0};  ///< of every polygon, its outer loop; then its holes; and the count of loops

  [[nodiscard]] std::uint32_t polygons() const { return static_cast<std::uint32_t>(first_loop.size() - 1); }
  [[nodiscard]] std::uint32_t holes(std::uint32_t polygon) const {
    return first_loop[polygon + 1] - first_loop[polygon] - 1;
  }
  [[nodiscard]] bool empty() const { return polygons() == 0; }
};

/// Exact areas.
[[nodiscard]] Rational area(const Region& region);
[[nodiscard]] Rational area(const Region& region, std::uint32_t polygon);

/// A polygon's boundary, by what is touched (source document, 1.4 and 3.2).
struct PolygonKind {
  bool is_manifold = true;  ///< no vertex is on its loops twice
  bool is_simply_connected =
      true;  ///< the complement of the open set is connected: every hole touches the outside, in the end
  /// Manifold and simply connected.
  [[nodiscard]] bool is_simple() const { return is_manifold && is_simply_connected; }
};
[[nodiscard]] PolygonKind kind_of(const Region& region, std::uint32_t polygon);

/// A region as a point set, for comparison: loops of exact corners, each from its least one, sorted. Two regions are
/// equal as sets exactly when their canonical forms are.
[[nodiscard]] std::vector<std::vector<RationalPlacement>> canonical_form(const Region& region);

}  // namespace strata::plane
