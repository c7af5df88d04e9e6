#pragma once
#include "extensions/planar/arrangement.h"
#include "extensions/planar/thinning.h"
#include "strata/planar.h"

namespace strata::planar {

/// The edges of several operands' loops as segments of one numbering. Edges without length are left out.
struct Gathered {
  Segments segments;
  std::vector<std::uint32_t> first_segment{0};  ///< of every ring, and the count: a ring is a loop's edges
  std::vector<std::uint32_t> first_ring{0};     ///< of every operand, and the count
  std::vector<std::uint32_t> operand_of;        ///< of every segment
  std::vector<std::uint32_t> edge_of;  ///< of every segment: its edge's first vertex, as an index of `Loops::vertices`
  std::vector<std::vector<std::uint32_t>> name_of;  ///< if kept: of every operand's points, in the segments' numbering
};

/// Equal doubles, and equal rationals, get one number. `name_of` is computed if `keep_names`. O(n).
[[nodiscard]] Gathered gather(std::span<const Operand> operands, bool keep_names = false);
/// The same, with segments that represent isolated chains.
[[nodiscard]] Gathered gather(Thinned thinned);

}  // namespace strata::planar
