#pragma once
#include "extensions/complex/soup.h"
#include "strata/complex.h"

namespace strata::complex {

/// A complex in space as triangles: faces are triangulated, edges and vertices in volumes get triangles to carry them.
/// Cells are numbered as `Incidences` does. O(n log n) for faces of bounded size. Throws std::invalid_argument where
/// edges of a face cross or do not enclose it: cells from a file may, until they are validated.
[[nodiscard]] Soup soup_of(const Cells& cells);

/// A complex in the plane as segments.
[[nodiscard]] Drawing drawing_of(const Cells& cells);

}  // namespace strata::complex
