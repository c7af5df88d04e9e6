#pragma once
#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <algorithm>

#include "strata/csg/options.h"

namespace strata {

/// The threads an evaluation may use: as many as asked for, but no more than there are cores.
[[nodiscard]] inline tbb::task_arena arena_for(const Options& options) {
  const int cores = tbb::info::default_concurrency();
  const auto asked = static_cast<int>(std::min(options.threads, 1u << 16));
  return tbb::task_arena(asked == 0 ? cores : std::min(asked, cores));
}

}  // namespace strata
