#pragma once
#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <cstddef>
#include <functional>

namespace strata::io {

/// True if the predicate holds for all numbers below n. In parallel.
template <class Predicate>
bool holds_for_all(std::size_t n, const Predicate& predicate) {
  return tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, n, 1 << 14), true,
      [&](const auto& range, bool all) {
        for (std::size_t i = range.begin(); all && i < range.end(); ++i) all = predicate(i);
        return all;
      },
      std::logical_and<>());
}

}  // namespace strata::io
