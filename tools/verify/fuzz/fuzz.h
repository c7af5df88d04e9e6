#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "common/exit_code.h"
#include "verify/engine_settings.h"

/// What `strata fuzz` asks for. `seconds` are for a round; of other engines, for an expression.
struct FuzzSettings : EngineSettings {
  std::uint64_t seed = 0;
  std::uint64_t rounds = 100;
  double minutes = 0;                 ///< 0: by rounds
  std::optional<std::uint64_t> only;  ///< one round alone
  std::string replay;                 ///< folder of a case whose checks are made, in this process
  std::string check;                  ///< of a replay: only this check
  std::string questions;              ///< folder where every round is written as a case; empty: none
  std::string keep = "strata-fuzz-findings";
  double shrink_seconds = 60;
};

void add_fuzz_options(CLI::App& verb, FuzzSettings& fuzz, OutputSettings& output);

/// Random search for broken laws: tests/README.md. `negative` if there is a finding.
[[nodiscard]] ExitCode run_fuzz(const FuzzSettings& fuzz, const OutputSettings& output);
