#pragma once
#include <cstdint>
#include <vector>

#include "core/overlap/constraint.h"

namespace strata {

/// The position of a constraint before all constraints are gathered.
struct ConstraintPosition {
  std::uint64_t faces = 0;  ///< the face and the other face
  std::uint32_t cell = 0;
  std::uint32_t index = 0;  ///< in the cell's list

  friend auto operator<=>(const ConstraintPosition& a, const ConstraintPosition& b) {
    return a.faces != b.faces ? a.faces <=> b.faces : a.index <=> b.index;
  }
  friend bool operator==(const ConstraintPosition&, const ConstraintPosition&) = default;
};

/// The constraints of all cells, sorted by face and other face, those of a pair in the order in which they were found.
/// Requires that those of a pair are in one cell. O(n log m) for n constraints, m of them on neighbouring faces; in
/// parallel.
[[nodiscard]] std::vector<ConstraintPosition> order_by_face(const std::vector<PairIntersections>& per_cell,
                                                            std::uint32_t face_count);

}  // namespace strata
