#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "command_line.h"
#include "planar_verbs.h"
#include "rounded_region.h"
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

void add_planar_queries(CLI::App& verb, const std::shared_ptr<PlanarSettings>& planar, CommandLine& line) {
  Settings& settings = line.settings;
  const auto add = [&](const char* name, const char* what, int most, auto* run, const char* example) {
    CLI::App* sub = verb.add_subcommand(name, what);
    add_planar_options(*sub, *planar, settings, 1, most);
    sub->footer(fmt::format("Example:\n  strata planar {}\n\n{}", example, exit_codes));
    line.on(*sub, [&settings, planar, run] { return run(*planar, settings); });
    return sub;
  };
  CLI::App* bridge = add("bridge", "Every polygon as one loop: holes are joined to it by edges there and back", 1,
                         run_planar_bridge, "bridge A.wkt -o OUT.svg");
  bridge->add_option("-o,--output", settings.output, "Where the loops go; - is standard output")
      ->required()
      ->type_name("OUT");
  bridge->add_option("--format", settings.output_format, "wkt, geojson or svg, instead of the extension of OUT")
      ->type_name("FORMAT");
  add_region_rounding_options(*bridge, settings);
  CLI::App* locate = add("locate", "Which points are in, on or out of what loops fill", 1, run_planar_locate,
                         "locate A.geojson --points probes.csv -o answers.csv");
  locate->add_option("--points", settings.points, "The points: CSV with the columns x,y; - is standard input")
      ->required()
      ->type_name("FILE");
  locate->add_option("-o,--output", settings.output, "Where rows x,y,where go (CSV); - is standard output")
      ->required()
      ->type_name("OUT");
  add("contacts", "Which files interfere, touch or are apart; --report has where they touch", 0, run_planar_contacts,
      "contacts A.wkt B.wkt C.svg --report contacts.json");
  add("decompose", "Faces, edges and vertices of the plane as polygons divide it; --report has them", 1,
      run_planar_decompose, "decompose A.wkt --report faces.json");
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
    add_region_rounding_options(*sub, settings);
    sub->add_option_function<std::string>(
           "--engine", [planar](const std::string& word) { planar->by_partitions = word == "bsp"; },
           "What computes the result, which is the same: arrangement, for all sizes; bsp, binary space partitions")
        ->type_name("ENGINE")
        ->check(CLI::IsMember({"arrangement", "bsp"}))
        ->default_str("arrangement");
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
  add_planar_queries(*verb, planar, line);
}
