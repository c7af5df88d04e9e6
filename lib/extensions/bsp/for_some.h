#pragma once
#include <algorithm>
#include <cstddef>

namespace strata::bsp {

/// Visits numbers from 0 to count - 1, a limited number of them, evenly spread: for estimates from a sample.
template <class Visit>
void for_some(std::size_t count, std::size_t most, const Visit& visit) {
  const std::size_t taken = std::min(count, most);
  for (std::size_t k = 0; k < taken; ++k) visit(k * count / taken);
}

}  // namespace strata::bsp
