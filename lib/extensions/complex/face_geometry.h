#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "strata/complex.h"

namespace strata::complex {

/// The wings of each face, one list after the other.
class WingsOfFaces {
 public:
  explicit WingsOfFaces(const Cells& cells);
  [[nodiscard]] std::span<const Wing> operator[](std::uint32_t face) const {
    return std::span(wings_).subspan(first_[face], first_[face + 1] - first_[face]);
  }

 private:
  std::vector<Wing> wings_;
  std::vector<std::size_t> first_;
};

/// Twice the area of a bounded face, along the normal to its upper side: the sum of u x v over its edges, counter-
/// clockwise. Exact.
[[nodiscard]] RationalPoint area_vector(const Cells& cells, std::span<const Wing> wings);

/// The first axis along which the area vector is not zero: the axis of projection, because the upper side is seen along
/// it from above. In doubles with bounds where these decide.
[[nodiscard]] std::size_t axis_of_face(const Cells& cells, std::span<const Wing> wings);

}  // namespace strata::complex
