#pragma once
#include "core/csg/arena.h"
#include "settings.h"

/// Runs on as many threads as were asked for.
template <class Work>
auto on_threads(const Settings& settings, const Work& work) {
  strata::Options options;
  options.threads = settings.threads;
  return strata::arena_for(options).execute(work);
}
