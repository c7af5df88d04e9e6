#include "run_command.h"

#include <CLI/CLI.hpp>
#include <string>

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
}

}  // namespace

int run_command(int count, char** arguments, unsigned threads) {
  Settings settings;
  settings.threads = threads;
  Action action;
  CLI::App app("Exact Booleans of meshes, on the doubles in the files", "strata");
  app.set_version_flag("--version", "strata " STRATA_VERSION);
  app.require_subcommand(1);
  app.footer(std::string(examples) + exit_codes);
  CommandLine line{app, settings, action, count > 1 ? arguments[1] : ""};
  add_verbs(line);
  if (app.get_subcommands({}).empty()) {  // it asks for help, or for what there is not
    line.asked = {};
    add_verbs(line);
    add_suite_verbs(line);
  }
  const Action checked = [&] {
    check_streams(settings);
    return action();
  };
  return run_program(app, count, arguments, checked, settings.operands);
}
