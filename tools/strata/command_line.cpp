#include "command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <utility>

bool CommandLine::wants(std::initializer_list<const char*> verbs) const {
  return asked.empty() || std::find(verbs.begin(), verbs.end(), asked) != verbs.end();
}

void CommandLine::on(CLI::App& verb, Action run) {
  verb.callback([this, run = std::move(run)] { action = run; });
}
