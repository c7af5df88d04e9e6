#pragma once
#include <optional>

#include "strata/complex/selective_complex.h"

namespace strata::complex {

/// The exact volume of a volume, or none where it is unbounded. O(size of its boundary + faces).
[[nodiscard]] std::optional<Rational> volume_of_cell(const SelectiveComplex& s, std::uint32_t volume);

/// The exact volume of the set, or none where it is unbounded; 0 in the plane. O(n).
[[nodiscard]] std::optional<Rational> volume(const SelectiveComplex& s);

/// The area of the faces of the set, correct to a few units in the last place, or none where one is unbounded. In space
/// of all faces in the set that bound a part of it: those inside, between volumes of the set, are no cells.
[[nodiscard]] std::optional<double> area(const SelectiveComplex& s);
/// In the plane, exact.
[[nodiscard]] std::optional<Rational> exact_area(const SelectiveComplex& s);

/// The length of the edges of the set, correct to a few units in the last place. O(n).
[[nodiscard]] double length(const SelectiveComplex& s);
/// Its exact square, of one edge.
[[nodiscard]] Rational squared_length_of_cell(const SelectiveComplex& s, std::uint32_t edge);

}  // namespace strata::complex
