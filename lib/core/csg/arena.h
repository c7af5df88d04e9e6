#pragma once
#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>

#include "strata/options.h"

namespace strata {

/// The threads that an evaluation may use: as many as requested, at most as many as there are cores, and one where
/// starting another takes longer than the work.
[[nodiscard]] inline tbb::task_arena arena_for(const Options& options, std::size_t faces = ~std::size_t{0}) {
  constexpr std::size_t few_faces = 1000;
  if (faces < few_faces) return tbb::task_arena(1);
  const int cores = tbb::info::default_concurrency();
  const auto asked = static_cast<int>(std::min(options.threads, 1u << 16));
  return tbb::task_arena(asked == 0 ? cores : std::min(asked, cores));
}

}  // namespace strata
