#pragma once
#include <cstddef>
#include <string>

#include "common/exit_code.h"
#include "settings.h"

/// What `strata chain` asks for beside the common settings.
struct ChainSettings {
  std::string document;        ///< path of the steps; "-" is stdin
  std::string checkpoint;      ///< path; empty: none
  std::size_t every = 0;       ///< steps between checkpoints; 0: one at the end, or when stopped
  std::string resume;          ///< path of a checkpoint; empty: from the start
  bool exact_volumes = false;  ///< in the report, after every step
};

/// All options of the verb.
void add_chain_options(CLI::App& verb, ChainSettings& chain, Settings& settings);

/// Steps of a document, one after the other, exactly: chain.md.
[[nodiscard]] ExitCode run_chain(const ChainSettings& chain, Settings& settings);
