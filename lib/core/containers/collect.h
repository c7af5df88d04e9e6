#pragma once
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace strata {

/// The numbers below `count` for which `is_wanted(number)` holds, in order. Asks from several threads at once.
template <class IsWanted>
[[nodiscard]] std::vector<std::uint32_t> collect(std::size_t count, const IsWanted& is_wanted) {
  constexpr std::size_t size = 1 << 14;
  std::vector<std::vector<std::uint32_t>> found((count + size - 1) / size);
  tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t block) {
    for (std::size_t n = block * size; n < std::min(count, (block + 1) * size); ++n)
      if (is_wanted(static_cast<std::uint32_t>(n))) found[block].push_back(static_cast<std::uint32_t>(n));
  });
  std::size_t total = 0;
  for (const auto& f : found) total += f.size();
  std::vector<std::uint32_t> all;
  all.reserve(total);
  for (const auto& f : found) all.insert(all.end(), f.begin(), f.end());
  return all;
}

}  // namespace strata
