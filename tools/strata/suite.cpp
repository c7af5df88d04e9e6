#include "suite.h"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>
#include <utility>

#include "command_line.h"
#include "common/run.h"
#include "common/sibling_program.h"

namespace {

constexpr const char* program = "strata-verify";

constexpr std::array<std::pair<std::string_view, const char*>, 2> verbs{
    {{"verify", "Cases with one right answer, asked of this engine or of others"},
     {"fuzz", "Random search for broken laws, in this engine or in others"}}};

}  // namespace

bool is_suite_verb(std::string_view verb) {
  return std::any_of(verbs.begin(), verbs.end(), [&](const auto& entry) { return entry.first == verb; });
}

int become_suite(char** arguments) {
  const std::string path = sibling_program(program).string();
  if (path.empty())
    return static_cast<int>(
        complain(ExitCode::file, std::string(arguments[1]) + " is a verb of the program " + program +
                                     ", which is neither beside this one, nor in ../libexec/strata, nor in the PATH"));
  execv(path.c_str(), arguments);
  return static_cast<int>(
      complain(ExitCode::file, path + ": cannot be started: " + std::generic_category().message(errno)));
}

Json suite_description() {
  const std::string path = sibling_program(program).string();
  // A copy of this program under that name would ask itself without end.
  if (own_program().filename().string() == program) return Json::array();
  if (path.empty() || path.find('\'') != std::string::npos) return Json::array();
  FILE* pipe = popen(("'" + path + "' describe").c_str(), "re");
  if (pipe == nullptr) return Json::array();
  std::string text;
  std::array<char, 4096> block{};
  while (const std::size_t n = std::fread(block.data(), 1, block.size(), pipe)) text.append(block.data(), n);
  const Json description = pclose(pipe) == 0 ? Json::parse(text, nullptr, false) : Json();
  return description.is_object() ? description["verbs"] : Json::array();
}

void add_suite_verbs(CommandLine& line) {
  for (const auto& [verb, what] : verbs) line.app.add_subcommand(std::string(verb), what);
}
