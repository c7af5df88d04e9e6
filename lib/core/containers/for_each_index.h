#pragma once
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cstddef>

#include "strata/monitor.h"

namespace strata {

/// Calls `body(i)` for all numbers below a count, by all threads, some `at_once` by one.
template <class Body>
void for_each_index(std::size_t count, std::size_t at_once, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, at_once), [&](const auto& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) body(i);
  });
}

/// The same, until the monitor says to stop.
template <class Body>
void for_each_index(std::size_t count, std::size_t at_once, const Monitor& monitor, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, at_once), [&](const auto& range) {
    monitor.check();
    for (std::size_t i = range.begin(); i != range.end(); ++i) body(i);
  });
}

}  // namespace strata
