#pragma once
#include <optional>

#include "strata/complex.h"

namespace strata::complex {

/// The same point set with the fewest cells: cells that look alike are merged, and numbered by their positions. A face
/// with its volumes' mark on both sides is merged into the volume, and so are edges and vertices without a face or edge
/// of another mark about them. Edges and vertices that look like all points of a face are merged into it, inner
/// vertices of a straight edge into the edge.
///
/// The result depends on the point set alone: theory.md, section 3. Requires vertices in lexicographic order, wings
/// sorted, and the unbounded cell first among those of the highest dimension; it remains first. O(n log n) for n cells
/// and wings, exact arithmetic for vertices between two edges only.
[[nodiscard]] Cells simplified(const Cells& cells);

/// The same, or nullopt where these cells, numbered as `simplified` does, are minimal. O(n) then.
[[nodiscard]] std::optional<Cells> simplified_if_needed(const Cells& cells);

}  // namespace strata::complex
