#pragma once
#include "strata/complex/selective_complex.h"

namespace strata::complex {

/// The cell that a point lies in. In the plane z must be 0. Exact, O(n): a face is asked by the edges that a ray within
/// it crosses, a volume by the first face on a ray, both perturbed to miss edges and vertices.
[[nodiscard]] Cell locate(const SelectiveComplex& s, const RationalPoint& p);
[[nodiscard]] Cell locate(const SelectiveComplex& s, const Vertex& p);  ///< throws std::invalid_argument if not finite

[[nodiscard]] bool contains(const SelectiveComplex& s, const RationalPoint& p);
[[nodiscard]] bool contains(const SelectiveComplex& s, const Vertex& p);

}  // namespace strata::complex
