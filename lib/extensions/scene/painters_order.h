#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "extensions/scene/dominance.h"
#include "extensions/scene/pieces.h"

namespace strata {

/// Pieces, the dominance relation among them, and their layers.
struct LayerOrder {
  std::vector<std::uint32_t> layer;       ///< per piece, from 1; 0 for flat and for replaced ones
  std::vector<std::uint32_t> first;       ///< per piece: start of its dominators; one more at the end
  std::vector<std::uint32_t> dominators;  ///< by increasing number
  std::uint32_t layer_count = 0;
  std::uint32_t cuts_at_crossings = 0;
  std::uint32_t cuts_of_cycles = 0;
};

/// Peels the pieces into layers, the farthest first. Before, faces that cross are cut along each other's planes. Faces
/// that dominate one another in a cycle are cut along planes through the origin and an edge of a neighbour in the
/// cycle; `turns` gets the orientations of the parts. O(n + k) for k dominations without cycles; every cut breaks one
/// cycle. Termination: theory.md, "Cycles".
[[nodiscard]] LayerOrder order_in_layers(Pieces& pieces, const Origin& origin, Dominance dominance,
                                         std::vector<Sign>& orientations, const Monitor& monitor);

}  // namespace strata
