#pragma once
#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "exit_code.h"
#include "settings.h"
#include "verify/verify.h"

/// What `strata fuzz` asks for.
struct FuzzSettings {
  std::uint64_t seed = 0;
  std::uint64_t rounds = 100;
  double minutes = 0;                 ///< 0: by rounds
  std::optional<std::uint64_t> only;  ///< one round alone
  std::string replay;                 ///< folder of a case whose checks are made, in this process
  std::string check;                  ///< of a replay: only this check
  std::string questions;              ///< folder where every round is written as a case; empty: none
  std::vector<std::string> engines;   ///< empty: strata
  std::string keep = "strata-fuzz-findings";
  unsigned jobs = 0;
  double seconds = 20;  ///< for a round; of other engines, for an expression
  double shrink_seconds = 60;
  std::uint64_t megabytes = default_megabytes;
  std::string oracle;   ///< program; empty: $STRATA_ORACLE, else strata-oracle in the path, else none
  std::string python;   ///< program; empty: $STRATA_PYTHON, else python3
  std::string scripts;  ///< folder of the engines that are scripts
};

void add_fuzz_options(CLI::App& verb, FuzzSettings& fuzz, Settings& settings);

/// Random search for broken laws: tests/README.md. `negative` if there is a finding.
[[nodiscard]] ExitCode run_fuzz(const FuzzSettings& fuzz, const Settings& settings);
