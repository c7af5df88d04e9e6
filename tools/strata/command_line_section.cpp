#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <map>
#include <memory>
#include <string>

#include "command_line.h"
#include "rounded_region.h"
#include "section_verbs.h"
#include "settings.h"

namespace {

using Shared = std::shared_ptr<SectionSettings>;

void add_output(CLI::App& verb, Settings& settings) {
  verb.add_option("-o,--output", settings.output, "Where polygons go: .wkt, .csv, .geojson, .svg; - is standard output")
      ->type_name("OUT")
      ->required();
  verb.add_option("--format", settings.output_format, "Format, instead of the extension of OUT: wkt, csv, geojson, svg")
      ->type_name("FORMAT");
  add_region_rounding_options(verb, settings);
}

void add_section(CommandLine& line, const Shared& section) {
  Settings& settings = line.settings;
  CLI::App* verb = line.app.add_subcommand("section", "The polygons in which a plane meets solids");
  add_common_options(*verb, settings, 1, 0);
  add_input_class(*verb, settings);
  verb->add_option("--plane", section->plane, "The plane of the points with a x + b y + c z = d; numbers or fractions")
      ->type_name("a,b,c,d")
      ->delimiter('\0')
      ->required();
  add_output(*verb, settings);
  verb->footer(fmt::format(
      R"(Coordinates are those of space but the one along which (a, b, c) is longest, counter-clockwise as seen from in front. Faces in
the plane belong to the section where the solid is in front of them.

Examples:
  strata section part.stl --plane 0,0,1,10 -o layer.svg
  strata section rock.stl ore.stl --plane 1,1,0,1/3 -o profile.geojson --report -

{})",
      exit_codes));
  line.on(*verb, [&settings, section] { return run_section(*section, settings); });
}

void add_slice(CommandLine& line, const Shared& section) {
  Settings& settings = line.settings;
  CLI::App* verb = line.app.add_subcommand("slice", "The polygons in which planes across an axis meet solids");
  add_common_options(*verb, settings, 1, 0);
  add_input_class(*verb, settings);
  verb->add_option("--along", section->along, "The axis: x, y or z")
      ->transform(CLI::CheckedTransformer(std::map<std::string, std::size_t>{{"x", 0}, {"y", 1}, {"z", 2}}))
      ->type_name("AXIS")
      ->default_str("z");
  verb->add_option("--step", section->step, "From plane to plane, from where the solids begin to where they end");
  verb->add_option("--from", section->from, "The first plane of --step");
  verb->add_option("--to", section->to, "Planes of --step are below this");
  verb->add_option("--at", section->at, "A file of coordinates, one plane each; - is standard input")
      ->type_name("FILE");
  add_output(*verb, settings);
  verb->footer(fmt::format(
      R"(Coordinates are y,z, or z,x, or x,y. Layers are closed below and open above: at the height of a bottom face the
section has this face, at that of a top face it has not.

Examples:
  strata slice part.stl --step 0.2 -o layers.svg
  strata slice shell.stl core.stl --along x --at stations.txt -o frames.csv

{})",
      exit_codes));
  line.on(*verb, [&settings, section] { return run_slice(*section, settings); });
}

}  // namespace

void add_section_verbs(CommandLine& line) {
  const auto section = std::make_shared<SectionSettings>();
  add_section(line, section);
  add_slice(line, section);
}
