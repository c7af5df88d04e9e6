#pragma once
#include <array>
#include <span>

#include "strata/planar.h"
#include "strata/transform.h"

namespace strata::openscad {

/// A map of the plane: (x, y) -> (a x + b y + c, d x + e y + f), row after row.
using PlaneMap = std::array<std::array<Rational, 3>, 2>;

/// The image of a region. Requires a map with an inverse. Placement::rounded rounds coordinates to the nearest doubles,
/// and fills what is then wound around.
[[nodiscard]] planar::Region transformed(const planar::Region& region, const PlaneMap& map, Placement placement);

/// The convex hull of regions. Exact.
[[nodiscard]] planar::Region hull(std::span<const planar::Region* const> regions);

/// The Minkowski sum {a + b}, exactly; empty if one of them is. A point x is in it where A and x - B have a point in
/// common: where their boundaries have, which parallelograms of two edges cover, or where a polygon of one lies in one
/// of the other, which polygons moved to a corner of the other cover. For a convex polygon B, the sums of an edge of A
/// and B replace parallelograms. O(n m) polygons for n and m edges, united in one arrangement.
[[nodiscard]] planar::Region minkowski_sum(const planar::Region& a, const planar::Region& b);

/// The region with its holes filled.
[[nodiscard]] planar::Region without_holes(const planar::Region& region);

/// Least and largest coordinates of all vertices, exact: {least x, least y}, {largest x, largest y}. Requires a region
/// that is not empty.
[[nodiscard]] std::array<planar::RationalPlacement, 2> bounding_box(const planar::Region& region);

}  // namespace strata::openscad
