#pragma once
#include <functional>
#include <string>
#include <vector>

#include "common/exit_code.h"
#include "common/usage_error.h"

namespace CLI {
class App;
}  // namespace CLI

/// What runs once the command line is understood.
using Action = std::function<ExitCode()>;

/// Writes "strata: <message>" to standard error; returns the code.
ExitCode complain(ExitCode code, const std::string& message);

/// Runs an action and tells what it throws: on standard error, and by the code. An InputError is about one of
/// `operands`, the paths of the input.
[[nodiscard]] ExitCode run(const Action& action, const std::vector<std::string>& operands);

/// Parses the arguments, which set `action` and `operands`, and runs the action. Returns the exit status of the
/// program.
[[nodiscard]] int run_program(CLI::App& app, int argc, char** argv, const Action& action,
                              const std::vector<std::string>& operands);
