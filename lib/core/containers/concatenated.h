#pragma once
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/containers/fresh_array.h"
#include "strata/monitor.h"

namespace strata {

/// The parts one after another. Copies them in parallel, and gives up the memory of each once it is copied.
template <class T>
[[nodiscard]] FreshArray<T> concatenated(std::vector<std::vector<T>> parts, const Monitor& monitor) {
  std::vector<std::size_t> first{0};
  for (const auto& part : parts) first.push_back(first.back() + part.size());
  FreshArray<T> all(first.back());
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t n) {
    monitor.check();
    const std::vector<T> part = std::move(parts[n]);
    std::copy(part.begin(), part.end(), all.begin() + first[n]);
  });
  return all;
}

}  // namespace strata
