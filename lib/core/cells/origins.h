#pragma once
#include <span>
#include <vector>

#include "core/cells/near_faces.h"

namespace strata {

/// An origin at the centre of a brick, whose winding numbers are required.
struct Target {
  std::uint32_t line = 0;  ///< through the centre
  std::uint32_t brick = 0;

  friend auto operator<=>(const Target&, const Target&) = default;
};

/// Winding numbers at the centres of bricks, each by a walk along its line from beyond all operands. `line_faces` are
/// the faces whose boxes meet the lines, sorted. One value per target, in their order.
[[nodiscard]] std::vector<Windings> walk_to_origins(const InputComplex& input, const Space& space,
                                                    const BrickGrid& bricks, std::span<const LineFace> line_faces,
                                                    std::span<const Target> targets, const Monitor& monitor);

}  // namespace strata
