#pragma once
#include <tbb/blocked_range.h>

namespace tbb {

template <class Index, class Work>
void parallel_for(Index first, Index last, const Work& work) {
  for (Index i = first; i < last; ++i) work(i);
}

/// The whole range at once.
template <class Range, class Work>
void parallel_for(const Range& range, const Work& work) {
  if (!range.empty()) work(range);
}

}  // namespace tbb
