#pragma once
#include <vector>

#include "strata/mesh.h"
#include "strata/planar.h"

namespace strata::openscad {

/// A shape's loops over a list of their vertices, and its division into triangles.
struct Cap {
  std::vector<planar::RationalPlacement> exact;   ///< positions of vertices
  std::vector<planar::PlanePoint> nearest;        ///< the same, rounded
  std::vector<std::vector<std::uint32_t>> loops;  ///< outer ones counter-clockwise, holes clockwise
  std::vector<std::uint32_t> loops_of_polygon{};  ///< how many loops each polygon has: the outer one, then holes
};

[[nodiscard]] Cap cap_of(const planar::Region& region);

/// Counter-clockwise triangles, none degenerate, that have all sides of the loops as sides. Exact. O(n log n).
[[nodiscard]] std::vector<Triangle> triangles_of(const Cap& cap);

}  // namespace strata::openscad
