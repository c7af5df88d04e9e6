#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string>

#include "command_line.h"
#include "settings.h"
#include "verbs.h"

namespace {

void add_topology(CommandLine& line) {
  Settings& settings = line.settings;
  CLI::App* verb = line.app.add_subcommand(
      "topology", "Sets that need not be regular: cells, parts of the boundary, components, holes");
  verb->add_option("MESH", settings.bindings,
                   "Mesh or complex (.sgc) files, called a, b, c, ... in order, or NAME=FILE; - is standard input")
      ->required()
      ->expected(1, CLI::detail::expected_max_vector_size);
  verb->add_option("--expression", settings.expression,
                   "Of names, with | & - ^ ~ and parentheses; the union unless told")
      ->type_name("E");
  verb->add_option("--operator", settings.operators,
                   "Applied to the result, one after the other: interior, closure, boundary, exterior, complement, "
                   "regularized, open-regularized, membrane, dangle, skin, wound, hair, cut, holes")
      ->type_name("OP")
      ->take_all();
  verb->add_option("--open", settings.open, "Operands without their boundaries")->type_name("NAME")->take_all();
  verb->add_option("-o,--output", settings.output, "Where the complex goes (.sgc); - is standard output")
      ->type_name("OUT.sgc");
  add_input_class(*verb, settings);
  add_run_options(*verb, settings);
  verb->footer(fmt::format(
      R"(Nothing is regularized: a closed solid minus an open one keeps their common boundary. Counts are of cells of dimension 0, 1, 2
and 3; parts are the interior, the exterior and of the boundary skin and wound (touching both), hair and cut (dangling).

Examples:
  strata topology block.stl drill.stl --expression "a - b" --report - -o part.sgc
  strata topology block.stl drill.stl --expression "a - b" --open b --operator hair
  strata topology part.sgc --operator interior --operator closure -o regular.sgc

{})",
      exit_codes));
  line.on(*verb, [&settings] { return run_topology(settings); });
}

}  // namespace

void add_complex_verbs(CommandLine& line) { add_topology(line); }
