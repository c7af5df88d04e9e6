#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace strata::plane {

/// Which points loops fill, by how often the loops wind around them.
enum class FillRule {
  even_odd,  ///< an odd number of times: the interior of a polyloop (source document, 4.1)
  nonzero,   ///< not zero
  positive,  ///< counter-clockwise more often than clockwise
  negative,
};

[[nodiscard]] constexpr bool is_filled(FillRule rule, std::int32_t winding) {
  switch (rule) {
    case FillRule::even_odd:
      return (winding & 1) != 0;
    case FillRule::nonzero:
      return winding != 0;
    case FillRule::positive:
      return winding > 0;
    case FillRule::negative:
      return winding < 0;
  }
  return false;
}

/// Which operands a point is in.
struct Inside {
  std::vector<std::uint8_t> is_in;  ///< by operand
  std::uint32_t count = 0;          ///< how many
};

/// A Boolean combination of operands, as a function of the operands that a point is in.
using Combination = std::function<bool(const Inside&)>;

enum class Operation {
  unite,                ///< in any
  intersect,            ///< in all
  subtract,             ///< in the first and in no other
  symmetric_difference  ///< in an odd number
};

[[nodiscard]] inline bool holds(Operation operation, const Inside& inside) {
  switch (operation) {
    case Operation::unite:
      return inside.count > 0;
    case Operation::intersect:
      return inside.count == inside.is_in.size() && inside.count > 0;
    case Operation::subtract:
      return inside.count == 1 && inside.is_in.front() != 0;
    case Operation::symmetric_difference:
      return (inside.count & 1) != 0;
  }
  return false;
}

}  // namespace strata::plane
