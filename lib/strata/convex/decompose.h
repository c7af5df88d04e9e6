#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "strata/convex/polytope.h"
#include "strata/csg/solid.h"
#include "strata/mesh/monitor.h"

namespace strata::convex {

/// Where two pieces of a decomposition touch with an area.
struct Wall {
  std::array<std::uint32_t, 2> pieces;  ///< the first has the lower number
  std::vector<std::uint32_t>
      polygon;  ///< convex; points of the decomposition, counter-clockwise as the second piece sees it
};

/// A facet of a piece, or a part of it, that is part of the boundary of the solid... of a decomposition.
struct Decomposition {
  std::vector<Polytope> pieces;  ///< of dimension 3, their interiors apart; together they are the solid
  std::size_t reflex_edges = 0;  ///< edges of the solid with an angle of more than 180 degrees inside
};

/// Divides a solid into convex pieces by planes through its reflex edges; every plane is one of the solid's own faces.
[[nodiscard]] Decomposition decompose(const Solid& solid, const Monitor& monitor = {});

}  // namespace strata::convex
