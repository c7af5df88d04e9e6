#pragma once
#include <cstdint>
#include <vector>

#include "extensions/planar/subdivision.h"

namespace strata::planar {

/// The boundary of the faces with a label, as simple loops of half-edges with such a face to their left.
struct BoundaryLoops {
  std::vector<std::uint32_t> half_edges;  ///< of all loops
  std::vector<std::uint32_t> first{0};    ///< of every loop, and the count
  std::vector<std::uint32_t> component;   ///< of every loop: loops of one component of the faces' union have one number
};

/// At a node, the boundary continues along the sector in which it arrived, so a traversal stays in one component. A
/// traversal that returns to a node is split there.
[[nodiscard]] BoundaryLoops boundary_loops(const Arrangement& a, const Subdivision& s,
                                           const std::vector<std::uint8_t>& label);

}  // namespace strata::planar
