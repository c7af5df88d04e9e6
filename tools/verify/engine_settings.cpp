#include "verify/engine_settings.h"

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <filesystem>

#include "common/shared_folder.h"

namespace {

namespace fs = std::filesystem;

std::string from_environment(const std::string& option, const char* variable, const char* otherwise) {
  if (!option.empty()) return option;
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0' ? value : otherwise;
}

}  // namespace

verify::EngineFolders EngineSettings::folders() const {
  return {from_environment(python, "STRATA_PYTHON", "python3"),
          scripts.empty() ? shared_folder("tools/engines") : fs::path(scripts)};
}

std::string EngineSettings::named_oracle() const { return from_environment(oracle, "STRATA_ORACLE", ""); }

void add_engine_options(CLI::App& verb, EngineSettings& s, const std::string& jobs, const std::string& seconds) {
  verb.add_option(
          "--engine", s.engines,
          "strata, strata-doubles, strata-floats, strata-python, strata-node, strata-chromium, layers, "
          "manifold3d, trueform, meshlib, libigl, or a command that is called as\n"
          "COMMAND union|intersection|difference|symmetric-difference A.off B.off OUT.off; may be given several times")
      ->type_name("NAME|[NAME=]COMMAND");
  verb.add_option("--jobs", s.jobs, jobs + " at a time; all cores unless told")->type_name("N");
  verb.add_option("--seconds", s.seconds, seconds)->check(CLI::PositiveNumber)->capture_default_str();
  verb.add_option("--memory", s.megabytes, "Address space for a process; 0: no limit")
      ->type_name("MB")
      ->capture_default_str();
  verb.add_option("--oracle", s.oracle, "The oracle, unless $STRATA_ORACLE or strata-oracle in the path")
      ->type_name("PROGRAM");
  verb.add_option("--python", s.python, "Runs the engines that are scripts, unless $STRATA_PYTHON or python3")
      ->type_name("PROGRAM");
  verb.add_option("--scripts", s.scripts, "Where the engines are that are scripts")->type_name("FOLDER");
}
