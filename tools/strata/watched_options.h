#pragma once
#include "common/progress.h"
#include "common/watch.h"
#include "settings.h"
#include "strata/options.h"

/// How an operation is computed: as the settings say, with this progress bar, until the watch stops it. Both must
/// outlive the operation.
[[nodiscard]] inline strata::Options watched_options(const Settings& settings, ProgressBar& bar, const Watch& watch) {
  strata::Options options;
  options.input = settings.input;
  options.most_hole_edges = settings.most_hole_edges;
  options.engine = settings.engine;
  options.threads = settings.threads;
  options.progress = [&bar](double fraction) { bar.show(fraction); };
  options.cancel = &watch.token();
  return options;
}
