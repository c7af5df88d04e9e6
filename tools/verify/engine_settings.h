#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "verify/child.h"
#include "verify/engine.h"

namespace CLI {
class App;
}  // namespace CLI

/// Megabytes of address space for a process. Programs with a sanitizer reserve all there is.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr std::uint64_t default_megabytes = 0;
#else
inline constexpr std::uint64_t default_megabytes = 4096;
#endif

/// What goes to the terminal.
struct OutputSettings {
  bool quiet = false;
  bool progress = false;
};

/// Who is asked, and what it may take: what `strata verify` and `strata fuzz` have in common.
struct EngineSettings {
  std::vector<std::string> engines;  ///< empty: strata
  unsigned jobs = 0;                 ///< questions at a time; 0: as many as there are cores
  double seconds = 20;
  std::uint64_t megabytes = default_megabytes;
  std::string oracle;   ///< program; empty: $STRATA_ORACLE, else strata-oracle in the path
  std::string python;   ///< program; empty: $STRATA_PYTHON, else python3
  std::string scripts;  ///< folder of the engines that are scripts; empty: where the program was built

  [[nodiscard]] verify::Limits limits() const { return {seconds, megabytes << 20}; }
  [[nodiscard]] verify::EngineFolders folders() const;
  /// The program asked for, or the variable's; empty where nothing is said.
  [[nodiscard]] std::string named_oracle() const;
};

/// `jobs` and `seconds` say what these count for the verb.
void add_engine_options(CLI::App& verb, EngineSettings& settings, const std::string& jobs, const std::string& seconds);
