#pragma once
#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include "exit_code.h"
#include "settings.h"

/// Megabytes of address space for a process. Programs with a sanitizer reserve all there is.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr std::uint64_t default_megabytes = 0;
#else
inline constexpr std::uint64_t default_megabytes = 4096;
#endif

/// What `strata verify` asks for.
struct VerifySettings {
  std::string cases;                     ///< folder; empty: data/cases, here or where the program was built
  std::vector<std::string> slugs, tags;  ///< which cases; empty: all
  std::vector<std::string> engines;      ///< empty: strata
  std::vector<std::string> reports;      ///< by extension: .json, .xml (JUnit), .html
  unsigned jobs = 0;
  double seconds = 20;
  std::uint64_t megabytes = default_megabytes;
  std::string result;         ///< a file to be judged as the result of a case; no engine is asked
  double roundoff = 0x1p-53;  ///< of the engine that made it
  bool certify = false, recertify = false;
  std::string oracle;   ///< program; empty: $STRATA_ORACLE, else strata-oracle in the path
  std::string python;   ///< program; empty: $STRATA_PYTHON, else python3
  std::string scripts;  ///< folder of the engines that are scripts
};

void add_verify_options(CLI::App& verb, VerifySettings& verify, Settings& settings);

/// Cases with one right answer each, asked of engines: tests/README.md. `negative` unless every result of strata is
/// exact, and every one of another engine exact or right within rounding.
[[nodiscard]] ExitCode run_verify(const VerifySettings& verify, const Settings& settings);
