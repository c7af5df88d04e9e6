#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string>

#include "command_line.h"
#include "settings.h"
#include "verbs.h"

namespace {

void add_bsp(CommandLine& line) {
  Settings& settings = line.settings;
  CLI::App* verb =
      line.app.add_subcommand("bsp", "The binary space partition of a solid: how large it is, and its cells");
  add_common_options(*verb, settings, 1, 1);
  add_input_class(*verb, settings);
  verb->add_option(
          "-o,--output", settings.output,
          "Where its inside leaves go, pulled apart and coloured (.glb; - is standard output), or the boundary "
          "of the region (any format of meshes)")
      ->type_name("OUT");
  verb->add_option("--format", settings.output_format, "Format of a boundary, instead of the extension of OUT")
      ->type_name("FORMAT");
  add_rounding_options(*verb, settings);
  verb->footer(
      fmt::format("Examples:\n  strata bsp part.stl --report -\n  strata bsp part.stl -o cells.glb\n  strata bsp "
                  "tree.bsp -o part.off\n\n"
                  "FILE.bsp is a tree as Hipparchus and Apache Commons Math dump it.\n\n{}",
                  exit_codes));
  line.on(*verb, [&settings] { return run_bsp(settings); });
}

/// Booleans of regions of the line.
void add_intervals(CommandLine& line) {
  Settings& settings = line.settings;
  CLI::App* verb = line.app.add_subcommand("intervals", "Regions of the line: Booleans of intervals, exactly");
  verb->require_subcommand(1);
  for (const strata::Operation operation : strata::all_operations) {
    CLI::App* sub = verb->add_subcommand(strata::name(operation), "Of intervals in files");
    if (operation == strata::Operation::symmetric_difference) sub->alias("xor");
    sub->preparse_callback([&settings](std::size_t) { settings.input_format = "csv"; });  // nothing else is read
    sub->add_option("INTERVALS", settings.operands, "CSV with the columns lower,upper; - is standard input")
        ->required()
        ->expected(1, CLI::detail::expected_max_vector_size);
    sub->add_option("-o,--output", settings.output, "Where the intervals go (CSV); - is standard output")
        ->required()
        ->type_name("OUT");
    sub->add_option("--report", settings.report, "Write a report in JSON; - is standard output")->type_name("FILE");
    sub->add_flag("-q,--quiet", settings.quiet, "Errors only");
    sub->footer(fmt::format(
        "Ends are numbers, quotients (1/3), or -inf and inf. Intervals are closed, those of one file are joined.\n\n"
        "Example:\n  strata intervals {} A.csv B.csv -o OUT.csv\n\n{}",
        strata::name(operation), exit_codes));
    line.on(*sub, [&settings, operation] { return run_intervals(operation, settings); });
  }
}

}  // namespace

void add_partition_verbs(CommandLine& line) {
  add_bsp(line);
  add_intervals(line);
}
