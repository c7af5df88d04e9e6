#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "command_line.h"
#include "planar.h"
#include "settings.h"

namespace {

void add_planar_options(CLI::App& verb, PlanarSettings& planar, Settings& settings, int least, int most) {
  verb.add_option("POLYGONS", settings.operands, "Files of polygons: .wkt, .geojson, .svg; - is standard input")
      ->required()
      ->expected(least, most == 0 ? CLI::detail::expected_max_vector_size : most);
  verb.add_option("--fill", planar.fill,
                  "What loops fill: nonzero (unless told), even-odd, positive or negative winding")
      ->type_name("RULE")
      ->check(CLI::IsMember({"nonzero", "even-odd", "positive", "negative"}));
  add_run_options(verb, settings);
}

}  // namespace

void add_planar_verbs(CommandLine& line) {
  Settings& settings = line.settings;
  using strata::planar::Operation;
  CLI::App* verb = line.app.add_subcommand("planar", "Polygons in the plane: Booleans, a clean test, measures");
  const auto planar = std::make_shared<PlanarSettings>();
  verb->require_subcommand(1);
  const auto add = [&](Operation operation, const char* what) {
    const char* name = strata::name(operation);
    CLI::App* sub = verb->add_subcommand(name, what);
    if (operation == Operation::symmetric_difference) sub->alias("xor");
    add_planar_options(*sub, *planar, settings, 1, 0);
    sub->add_option("-o,--output", settings.output, "Where the polygons go; - is standard output")
        ->required()
        ->type_name("OUT");
    sub->add_option("--format", settings.output_format, "wkt, geojson or svg, instead of the extension of OUT")
        ->type_name("FORMAT");
    sub->add_flag("--exact", settings.exact,
                  "Write vertices that are no doubles as quotients (WKT); else the nearest doubles");
    sub->footer(fmt::format("Example:\n  strata planar {} A.geojson B.wkt -o OUT.svg\n\n{}", name, exit_codes));
    line.on(*sub, [&settings, planar, operation, name] { return run_planar(operation, name, *planar, settings); });
  };
  add(Operation::union_, "What is in any of the files");
  add(Operation::intersection, "What is in all of the files");
  add(Operation::difference, "What is in the first file and in no other");
  add(Operation::symmetric_difference, "What is in an odd number of the files");
  CLI::App* check = verb->add_subcommand("check", "Are the loops clean? Lists where they meet themselves");
  add_planar_options(*check, *planar, settings, 1, 1);
  check->footer(exit_codes);
  line.on(*check, [&settings] { return run_planar_check(settings); });
  CLI::App* info = verb->add_subcommand("info", "Polygons, holes and exact area of what loops fill");
  add_planar_options(*info, *planar, settings, 1, 1);
  info->footer(exit_codes);
  line.on(*info, [&settings, planar] { return run_planar_info(*planar, settings); });
}
