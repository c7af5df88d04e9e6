#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "strata/options.h"

namespace verify {

/// One call of an engine that takes two operands. Values are numbered: first the names, then the results of the steps.
struct Step {
  strata::Operation operation = strata::Operation::union_;
  std::size_t first = 0, second = 0;
};

/// An expression as calls of binary operations, without complements.
struct Steps {
  std::vector<std::string> names;  ///< by first occurrence
  std::vector<Step> steps;
  std::size_t result = 0;  ///< the number of the last value
};

/// Reads an expression (strata::parse_expression). Complements go up the tree by De Morgan: a & ~b is a - b,
/// ~a | ~b is ~(a & b). Throws strata::ParseError, and std::invalid_argument where the result is a complement.
[[nodiscard]] Steps steps_of(std::string_view expression);

}  // namespace verify
