#pragma once
#include <tbb/blocked_range.h>

#include <utility>

namespace tbb {

template <class Range, class Value, class Work, class Join>
[[nodiscard]] Value parallel_reduce(const Range& range, const Value& identity, const Work& work, const Join&) {
  return range.empty() ? identity : work(range, identity);
}

template <class Range, class Body>
void parallel_reduce(const Range& range, Body& body) {
  if (!range.empty()) body(range);
}

/// Divides in halves down to the grain, as oneTBB does, since what is rounded depends on it.
template <class Range, class Body>
void parallel_deterministic_reduce(Range range, Body& body) {
  if (!range.is_divisible()) {
    if (!range.empty()) body(range);
    return;
  }
  const Range upper(range, split{});
  Body above(body, split{});
  parallel_deterministic_reduce(range, body);
  parallel_deterministic_reduce(upper, above);
  body.join(above);
}

/// The same for values.
template <class Range, class Value, class Work, class Join>
[[nodiscard]] Value parallel_deterministic_reduce(Range range, const Value& identity, const Work& work,
                                                  const Join& join) {
  if (!range.is_divisible()) return range.empty() ? identity : work(range, identity);
  const Range upper(range, split{});
  Value below = parallel_deterministic_reduce(range, identity, work, join);
  return join(std::move(below), parallel_deterministic_reduce(upper, identity, work, join));
}

}  // namespace tbb
