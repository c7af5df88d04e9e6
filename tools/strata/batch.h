#pragma once
#include <string>

#include "batch_jobs.h"
#include "common/exit_code.h"
#include "settings.h"

/// What `strata batch` asks for.
struct BatchSettings {
  std::string document;       ///< path of the jobs; "-" is stdin
  std::string records = "-";  ///< path of the records; "-" is stdout
  unsigned workers = 0;       ///< 0: as many as there are cores
  JobLimits limits;           ///< of jobs that have none of their own
  bool resume = false;        ///< jobs that have a record are not run again
  bool retry = false;         ///< those that are not ok are
};

/// All options of the verb.
void add_batch_options(CLI::App& verb, BatchSettings& batch, Settings& settings);

/// Many command lines, by a pool of processes: batch.md.
[[nodiscard]] ExitCode run_batch(const BatchSettings& batch, const Settings& settings);
