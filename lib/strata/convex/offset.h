#pragma once
#include <cstdint>

#include "strata/convex/polytope.h"
#include "strata/csg/options.h"
#include "strata/csg/solid.h"

namespace strata::convex {

/// A polytope that contains the ball of a radius about the origin and lies in the ball of radius (1 + excess) times it.
struct Ball {
  Polytope polytope;
  double excess = 0;  ///< proven in rationals, rounded up
};

/// A geodesic ball: an icosahedron's faces divided into f^2 triangles each, f chosen so that there are nearly as many
/// facets as asked for. Vertices are doubles on a grid of a few more bits than the shape needs: sums with them seldom
/// need more than doubles have. The excess is about 5 / facets. Throws std::invalid_argument unless the radius is
/// positive, finite and at least 2^-900, and facets are 20 to 500,000; std::overflow_error beyond 2^1000.
[[nodiscard]] Ball ball(double radius, std::uint32_t facets);

/// A solid grown or shrunk by about a distance.
struct Offset {
  Solid solid;
  double excess = 0;  ///< e: the distance is between |radius| and (1 + e) |radius| everywhere
};

/// The sum of a solid and `ball(radius, facets)`; for a negative radius its erosion by `ball(-radius, facets)`; itself
/// for 0. So what is within the radius is in the result (or all that is eroded by the exact ball is gone).
/// Throws as `minkowski_sum`, `erosion` and `ball` do.
[[nodiscard]] Offset offset(const Solid& solid, double radius, std::uint32_t facets = 320, const Options& options = {});

}  // namespace strata::convex
