#pragma once
#include <cstdint>
#include <vector>

#include "strata/complex/selective_complex.h"

namespace strata::complex {

/// The connected components of a set or of its complement, by cells.
struct Components {
  std::uint32_t count = 0;
  std::vector<std::uint32_t> of_cell;  ///< as `Incidences` numbers cells; `none` for those of the other set
};

/// Cells with that mark are connected where one lies in the boundary of the other. Numbered by their lowest cells.
/// O(incidences).
[[nodiscard]] Components components(const SelectiveComplex& s, bool of_the_set = true);

/// The components as sets of their own, in that order.
[[nodiscard]] std::vector<SelectiveComplex> separate(const SelectiveComplex& s);

/// The union of the bounded components of the complement. Of a set that is not bounded, too.
[[nodiscard]] SelectiveComplex holes(const SelectiveComplex& s);
[[nodiscard]] std::uint32_t count_holes(const SelectiveComplex& s);

[[nodiscard]] bool is_connected(const SelectiveComplex& s);  ///< at most one component
/// Without holes: of a bounded set, that the complement is connected. Throws std::invalid_argument for one that is not.
[[nodiscard]] bool is_simply_connected(const SelectiveComplex& s);

[[nodiscard]] bool is_open(const SelectiveComplex& s);                ///< S = S.i
[[nodiscard]] bool is_closed(const SelectiveComplex& s);              ///< S = S.c
[[nodiscard]] bool is_closed_regularized(const SelectiveComplex& s);  ///< S = S.r
[[nodiscard]] bool is_open_regularized(const SelectiveComplex& s);    ///< S = S.o

}  // namespace strata::complex
