#include "suite.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include "command_line.h"
#include "common/run.h"
#include "common/scratch.h"
#include "common/sibling_program.h"
#include "common/text_file.h"
#include "core/system/program.h"

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
  strata::system::become(path, arguments);
  return static_cast<int>(
      complain(ExitCode::file, path + ": cannot be started: " + std::generic_category().message(errno)));
}

Json suite_description() {
  const std::string path = sibling_program(program).string();
  // A copy of this program under that name would ask itself without end.
  if (path.empty() || own_program().stem().string() == program) return Json::array();
  const Scratch scratch;
  const auto text = scratch.path() / "description.json";
  strata::system::Process suite({.words = {path, "describe"}, .output = text});
  if (const auto end = suite.wait(); end.crashed || end.code != 0) return Json::array();
  const Json description = Json::parse(read_file(text.string()), nullptr, false);
  return description.is_object() ? description["verbs"] : Json::array();
}

void add_suite_verbs(CommandLine& line) {
  for (const auto& [verb, what] : verbs) line.app.add_subcommand(std::string(verb), what);
}
