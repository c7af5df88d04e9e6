#pragma once
#include <cstdint>
#include <stdexcept>
#include <string>

#include "strata/complex.h"

namespace strata::complex {

/// The error that cells are no complex.
class ComplexError : public std::runtime_error {
 public:
  ComplexError(Cell where, const std::string& what);
  [[nodiscard]] Cell where() const { return where_; }  ///< the lowest invalid cell, as far as this is known

 private:
  Cell where_;
};

/// Renumbers the planes of faces: equal numbers for faces in one plane. Exact. O(n log n).
void number_planes(Cells& cells);

/// The set that given cells represent, with planes renumbered. Throws ComplexError when they are no complex: numbers
/// out of range, vertices or edges out of order, faces not planar, not closed or not seen from above, or cells with
/// other incidences than given. One arrangement of all cells detects the last.
[[nodiscard]] SelectiveComplex validated(Cells cells);

}  // namespace strata::complex
