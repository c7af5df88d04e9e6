#include "run_command.h"

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "command_line.h"

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

void add_verbs(CommandLine& line) {
  add_boolean_verbs(line);
  add_extension_verbs(line);
  if (line.wants({"batch"})) add_batch_verb(line);
  add_about_verbs(line);
}

/// `strata help VERB...` is `strata VERB... --help`.
std::vector<char*> without_help_verb(int count, char** arguments) {
  static char option[] = "--help";
  std::vector<char*> words(arguments, arguments + count);
  if (count > 1 && std::string_view(arguments[1]) == "help") {
    words.erase(words.begin() + 1);
    words.push_back(option);
  }
  words.push_back(nullptr);
  return words;
}

/// Verbs that describe all others.
bool is_about_all(std::string_view verb) { return verb == "completion" || verb == "manual" || verb == "describe"; }

}  // namespace

int run_command(int count, char** arguments, unsigned threads) {
  std::vector<char*> words = without_help_verb(count, arguments);
  count = static_cast<int>(words.size()) - 1;
  Settings settings;
  settings.threads = threads;
  Action action;
  CLI::App app("Exact Booleans of meshes, on the doubles in the files", "strata");
  app.allow_windows_style_options(false);  // /a is a path
  app.set_version_flag("--version", "strata " STRATA_VERSION);
  app.require_subcommand(1);
  app.footer(std::string(examples) + exit_codes);
  CommandLine line{app, settings, action, count > 1 && !is_about_all(words[1]) ? words[1] : ""};
  add_verbs(line);
  if (line.asked.empty()) {
    add_suite_verbs(line);
  } else if (app.get_subcommands({}).empty()) {  // it asks for help, or for what there is not
    line.asked = {};
    add_verbs(line);
    add_suite_verbs(line);
  }
  const Action checked = [&] {
    check_streams(settings);
    return action();
  };
  return run_program(app, count, words.data(), checked, settings.operands);
}
