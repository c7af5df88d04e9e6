#pragma once
#include "extensions/complex/soup.h"
#include "strata/complex.h"

namespace strata::complex {

/// A complex in space as triangles: faces are triangulated, edges and vertices in volumes get auxiliary triangles.
/// Cells are numbered as in `Incidences`. O(n log n) for faces of bounded size. Throws std::invalid_argument where
/// edges of a face cross or do not enclose it, which may happen for cells from a file that are not validated yet.
[[nodiscard]] Soup soup_of(const Cells& cells);

/// A complex in the plane as segments.
[[nodiscard]] Drawing drawing_of(const Cells& cells);

}  // namespace strata::complex
