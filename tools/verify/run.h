#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "verify/case.h"
#include "verify/engine.h"
#include "verify/outcome.h"

namespace verify {

/// What one engine did with one case.
struct Finding {
  std::size_t of_case = 0, of_engine = 0;  ///< numbers in the run
  Verdict verdict;
  double seconds = 0;  ///< of the engine's processes
  std::uint64_t peak_bytes = 0;
  std::string picture;  ///< of a result that is not as it should be, if pictures are wanted: SVG
};

/// Engines on cases.
struct Run {
  std::vector<Case> cases;
  std::vector<std::string> engines;
  std::vector<Finding> findings;               ///< by case, then by engine
  double seconds = 0;                          ///< by the clock
  std::vector<std::string> expected_pictures;  ///< by case: exact results, if pictures are wanted and strata is asked
};

/// How a run is done.
struct RunOptions {
  Limits limits;
  unsigned jobs = 0;  ///< 0: as many as there are cores
  bool pictures = false;
  bool judge_apart = true;               ///< in a process for each result; else in this one
  std::function<void(double)> progress;  ///< called with a fraction, never concurrently
};

/// Asks every engine for every case, and judges. Cases without expectation are `oracle_failed`.
[[nodiscard]] Run run_cases(std::vector<Case> cases, const std::vector<std::unique_ptr<Engine>>& engines,
                            const RunOptions& options);

/// Findings of an engine with an outcome.
[[nodiscard]] std::size_t count(const Run& run, std::size_t engine, Outcome outcome);

}  // namespace verify
