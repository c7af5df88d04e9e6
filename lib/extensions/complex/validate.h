#pragma once
#include <cstdint>
#include <stdexcept>
#include <string>

#include "strata/complex.h"

namespace strata::complex {

/// Cells that are no complex.
class ComplexError : public std::runtime_error {
 public:
  ComplexError(Cell where, const std::string& what);
  [[nodiscard]] Cell where() const { return where_; }  ///< the lowest cell that is wrong, as far as that can be told

 private:
  Cell where_;
};

/// Numbers the planes of faces anew: equal numbers for faces in one plane. Exact. O(n log n).
void number_planes(Cells& cells);

/// The set that cells from outside stand for, their planes numbered anew. Throws ComplexError when they are no complex:
/// numbers out of range, vertices or edges out of order, faces not flat, not closed or not seen from above, or cells
/// that meet otherwise than they say; the last by one arrangement of all.
[[nodiscard]] SelectiveComplex validated(Cells cells);

}  // namespace strata::complex
