#pragma once
#include <string>
#include <vector>

#include "common/exit_code.h"
#include "verify/engine_settings.h"

/// What `strata verify` asks for.
struct VerifySettings : EngineSettings {
  std::string cases;                     ///< folder; empty: data/cases, here or where the program was built
  std::vector<std::string> slugs, tags;  ///< which cases; empty: all
  std::vector<std::string> reports;      ///< by extension: .json, .xml (JUnit), .html
  std::string workbench;                 ///< the address that cases of a .html report link to; empty: none
  std::string result;                    ///< a file to be judged as the result of a case; no engine is asked
  double roundoff = 0x1p-53;             ///< of the engine that made it
  bool certify = false, recertify = false;
};

void add_verify_options(CLI::App& verb, VerifySettings& verify, OutputSettings& output);

/// Cases with one right answer each, asked of engines: tests/README.md. `negative` unless every result of strata is
/// exact, and every one of another engine exact or right within rounding.
[[nodiscard]] ExitCode run_verify(const VerifySettings& verify, const OutputSettings& output);
