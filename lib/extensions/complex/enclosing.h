#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "extensions/complex/arrangement.h"
#include "strata/complex.h"

namespace strata::complex {

/// A set of pieces that are connected over edges.
struct EnclosableSet {
  std::uint32_t outer = none;  ///< the shell of the set that encloses no bounded volume
  std::vector<std::uint32_t> pieces;
};

/// Per set the innermost shell of another set that encloses it, or none. Sides 2 p and 2 p + 1 of piece p, above and
/// below, belong to the shell `shell_of[side]`.
///
/// A ray in the direction of x from a point of the set, perturbed to miss all edges, leaves a shell's volume as often
/// as it enters it, and once more if it starts inside. O(sets^2) boxes, and the triangles of those that meet the ray.
[[nodiscard]] std::vector<std::uint32_t> enclosing_shells(const Arrangement& arrangement, const Cells& cells,
                                                          std::span<const EnclosableSet> sets,
                                                          const std::function<std::uint32_t(std::uint32_t)>& shell_of);

}  // namespace strata::complex
