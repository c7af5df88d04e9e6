#pragma once
#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <algorithm>

#include "settings.h"

/// Runs on as many threads as were asked for, but no more than there are cores.
template <class Work>
auto on_threads(const Settings& settings, const Work& work) {
  const int cores = tbb::info::default_concurrency();
  const auto asked = static_cast<int>(std::min(settings.threads, 1u << 16));
  return tbb::task_arena(asked == 0 ? cores : std::min(asked, cores)).execute(work);
}
