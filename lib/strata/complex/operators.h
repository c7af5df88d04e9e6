#pragma once
#include <vector>

#include "strata/complex/selective_complex.h"

namespace strata::complex {

/// The operators of point set topology, by marks and incidences alone: O(incidences) to mark, and the simplification.
/// S.i, S.c and so on are the notation of the source: Rossignac, chapter on shapes, sections 1.4 and 2.2; theory.md.

[[nodiscard]] SelectiveComplex interior(const SelectiveComplex& s);  ///< S.i, the points about which all is in S
[[nodiscard]] SelectiveComplex closure(const SelectiveComplex& s);   ///< S.c, the points that touch S
[[nodiscard]] SelectiveComplex boundary(
    const SelectiveComplex& s);  ///< S.b, the points that touch S and its complement
[[nodiscard]] SelectiveComplex exterior(const SelectiveComplex& s);          ///< S.e, the interior of the complement
[[nodiscard]] SelectiveComplex regularized(const SelectiveComplex& s);       ///< S.r = S.i.c
[[nodiscard]] SelectiveComplex open_regularized(const SelectiveComplex& s);  ///< S.o = S.c.i

/// The parts of the plane or of space that a set makes: exclusive and exhaustive.
enum class Part : std::uint8_t {
  interior,
  exterior,
  skin,   ///< of the membrane, in the set
  wound,  ///< of the membrane, not in the set
  hair,   ///< of the dangle, in the set
  cut,    ///< of the dangle, not in the set
};
// Hair mostly touches the exterior only, and a cut the interior only, but not always: theory.md, section 5.

/// Which part each cell belongs to, as `Incidences` numbers them. O(incidences).
[[nodiscard]] std::vector<Part> parts_of(const SelectiveComplex& s);

[[nodiscard]] SelectiveComplex part(const SelectiveComplex& s, Part which);
[[nodiscard]] SelectiveComplex membrane(const SelectiveComplex& s);  ///< S.m, S.i.b n S.e.b: skin and wound
[[nodiscard]] SelectiveComplex dangle(const SelectiveComplex& s);    ///< S.d, S.b \ S.m: hair and cut

/// Tests of one cell by its mark c.m and its star c.s; c.b is not needed. O(|c.s|).
[[nodiscard]] bool lies_in_interior(const SelectiveComplex& s, Cell c);  ///< c.m, and every f of c.s has f.m
[[nodiscard]] bool lies_in_exterior(const SelectiveComplex& s, Cell c);  ///< neither c.m nor any f.m
[[nodiscard]] bool lies_in_boundary(const SelectiveComplex& s, Cell c);  ///< neither of these
/// Of the cells f of c.s that have no star themselves, one has f.m and one has not.
[[nodiscard]] bool lies_in_membrane(const SelectiveComplex& s, Cell c);
[[nodiscard]] bool lies_in_dangle(const SelectiveComplex& s, Cell c);  ///< in the boundary, and not in the membrane

}  // namespace strata::complex
