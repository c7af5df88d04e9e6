#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>

#include "command_line.h"
#include "strata/errors.h"
#include "strata/io.h"
#include "strata/options.h"

namespace {

constexpr const char* examples = R"(Examples:
  strata union left.stl right.stl -o both.stl
  strata difference block.obj drill1.stl drill2.ply -o part.ply --certify --report part.json
  strata intersection a.glb b.3mf -o common.obj --input repair
  cat a.off | strata symmetric-difference - b.off --input-format off -o - --format off > changed.off
  strata difference block.stl drill.stl -o part.xoff && strata union part.xoff bolt.stl -o whole.xoff
  strata check scan.stl
  strata compare yesterday.stl today.obj
  strata layers house.obj tree.obj -o layers.ply
  strata chain part.json -o part.stl --checkpoint part.save
  strata locate part.stl --points probes.csv -o answers.csv
  strata ray part.stl --rays beams.csv -o hits.csv --all

)";

ExitCode complain(ExitCode code, const std::string& message) {
  std::fputs(("strata: " + message + "\n").c_str(), stderr);
  return code;
}

ExitCode complain(const strata::InputError& error, const Settings& settings) {
  const std::string& path = settings.operands.at(error.operand());
  for (const strata::Defect& defect : error.defects()) {
    fmt::print(stderr, "strata: {}: {}: {}\n", path, strata::name(defect.severity), strata::describe(defect));
  }
  return complain(ExitCode::invalid_input, path + " is not what was declared; no result was written");
}

ExitCode run(const Action& action, const Settings& settings) {
  try {
    check_streams(settings);
    const ExitCode code = action();
    return std::fflush(stdout) == 0 ? code : complain(ExitCode::file, "standard output cannot be written");
  } catch (const UsageError& error) {
    return complain(ExitCode::usage, error.what());
  } catch (const strata::IoError& error) {
    return complain(ExitCode::file, error.what());
  } catch (const std::system_error& error) {
    return complain(ExitCode::file, error.what());
  } catch (const strata::InputError& error) {
    return complain(error, settings);
  } catch (const strata::Cancelled& error) {
    return complain(ExitCode::stopped, std::string(error.what()) + "; no result was written");
  } catch (const std::overflow_error& error) {
    return complain(ExitCode::invalid_input, std::string(error.what()) + "; no result was written");
  } catch (const std::bad_alloc&) {
    return complain(ExitCode::stopped, "out of memory");
  } catch (const std::length_error& error) {
    return complain(ExitCode::stopped, error.what());
  } catch (const std::exception& error) {
    return complain(ExitCode::internal, std::string("an error of the program, please report it: ") + error.what());
  }
}

}  // namespace

int main(int argc, char** argv) {
  Settings settings;
  Action action;
  CLI::App app("Exact Booleans of meshes, on the doubles in the files", "strata");
  app.set_version_flag("--version", "strata " STRATA_VERSION);
  app.require_subcommand(1);
  app.footer(std::string(examples) + exit_codes);
  CommandLine line{app, settings, action};
  add_boolean_verbs(line);
  add_query_verbs(line);
  add_shape_verbs(line);
  add_planar_verbs(line);
  add_suite_verbs(line);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : static_cast<int>(ExitCode::usage);
  }
  return static_cast<int>(run(action, settings));
}
