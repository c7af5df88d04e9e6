#pragma once
#include <vector>

#include "strata/complex/selective_complex.h"

namespace strata::complex {

/// The cells of the boundary whose points are not manifold: around these the boundary is no curve in the plane, no
/// surface in space. In the plane vertices without exactly two edges; in space edges without exactly two wings, and
/// vertices around which faces and edges do not make one ring. By dimension and number. In a minimal complex every cell
/// but those of full dimension lies in the boundary: theory.md, section 3.
/// O(n), and exact arithmetic where a face has several corners at one vertex.
[[nodiscard]] std::vector<Cell> non_manifold_cells(const SelectiveComplex& s);

/// True when there are none.
[[nodiscard]] bool is_manifold(const SelectiveComplex& s);

}  // namespace strata::complex
