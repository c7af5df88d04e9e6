#pragma once
#include <optional>

#include "strata/complex.h"

namespace strata::complex {

/// The same point set with the fewest cells: cells are merged where they need not be apart, and numbered by their
/// places. A volume takes in faces with its own mark on both sides, edges and vertices with no face or edge of another
/// mark about them; a face takes in edges and vertices that look like all of its points, an edge its inner vertices.
///
/// The result depends on the point set alone: theory.md, section 3. Requires vertices in lexicographic order, wings
/// sorted, and the unbounded cell first among those of the highest dimension, where it stays.
/// O(n log n) for n cells and wings, exact arithmetic for vertices between two edges only.
[[nodiscard]] Cells simplified(const Cells& cells);

/// The same, or nothing where these cells, numbered as `simplified` does, need not be merged. O(n) then.
[[nodiscard]] std::optional<Cells> simplified_if_needed(const Cells& cells);

}  // namespace strata::complex
