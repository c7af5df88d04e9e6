#include "command_line.h"

#include <CLI/CLI.hpp>
#include <utility>

void CommandLine::on(CLI::App& verb, Action run) {
  verb.callback([this, run = std::move(run)] { action = run; });
}
