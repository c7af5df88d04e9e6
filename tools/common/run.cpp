#include "common/run.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <new>
#include <stdexcept>
#include <system_error>

#include "common/misuse.h"
#include "common/tell.h"
#include "common/terminal.h"
#include "strata/errors.h"

ExitCode complain(ExitCode code, const std::string& message) {
  std::fputs((painted_error("strata:") + " " + message + "\n").c_str(), stderr);
  return code;
}

namespace {

ExitCode complain(const strata::InputError& error, const std::vector<std::string>& operands) {
  const std::string path = error.operand() < operands.size() ? operands[error.operand()] : "an operand";
  for (const strata::Defect& defect : error.defects()) {
    tell("strata: {}: {}: {}\n", path, strata::name(defect.severity), strata::describe(defect));
  }
  return complain(ExitCode::invalid_input, path + " is not what was declared; no result was written");
}

}  // namespace

ExitCode run(const Action& action, const std::vector<std::string>& operands) {
  try {
    const ExitCode code = action();
    return std::fflush(stdout) == 0 ? code : complain(ExitCode::file, "standard output cannot be written");
  } catch (const UsageError& error) {
    return complain(ExitCode::usage, error.what());
  } catch (const strata::IoError& error) {
    return complain(ExitCode::file, error.what());
  } catch (const std::system_error& error) {
    return complain(ExitCode::file, error.what());
  } catch (const strata::InputError& error) {
    return complain(error, operands);
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

int run_program(CLI::App& app, int argc, char** argv, const Action& action, const std::vector<std::string>& operands) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // help, or the version
    std::fputs(explain_misuse(app, error).c_str(), stderr);
    return static_cast<int>(ExitCode::usage);
  }
  const Action explained = [&] {
    try {
      return action();
    } catch (const UsageError& error) {
      std::fputs(explain_misuse(app, error).c_str(), stderr);
      return ExitCode::usage;
    }
  };
  return static_cast<int>(run(explained, operands));
}
