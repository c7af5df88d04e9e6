#pragma once
#include <algorithm>
#include <cstddef>

namespace strata::bsp {

/// Visits numbers from 0 to count - 1, at most so many, evenly spread: for estimates from a few of many.
template <class Visit>
void for_some(std::size_t count, std::size_t most, const Visit& visit) {
  const std::size_t taken = std::min(count, most);
  for (std::size_t k = 0; k < taken; ++k) visit(k * count / taken);
}

}  // namespace strata::bsp
