#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "extensions/complex/arrangement.h"
#include "strata/complex.h"

namespace strata::complex {

/// The volumes into which pieces divide space, and the planes of the pieces where these meet.
struct Volumes {
  std::uint32_t count = 1;                          ///< volume 0 is the unbounded one
  std::vector<std::array<std::uint32_t, 2>> sides;  ///< per piece: volumes above and below
  std::vector<std::uint32_t> plane;                 ///< per piece
};

/// Computed from the order of pieces around each edge. `cells` contains the pieces as faces, with wings and vertices.
///
/// Neighbouring sides around edges form connected shells. A shell encloses a bounded volume exactly when its signed
/// volume is positive, and every connected set of pieces has exactly one shell that does not: theory.md, section 2.
/// That one bounds the innermost volume around the set. O(n log n), and for every connected set the triangles of those
/// sets whose boxes are around it.
[[nodiscard]] Volumes find_volumes(const Arrangement& arrangement, const Cells& cells);

}  // namespace strata::complex
