#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string>

#include "command_line.h"
#include "settings.h"
#include "verbs.h"

namespace {

void add_contacts(CommandLine& line) {
  Settings& settings = line.settings;
  CLI::App* verb =
      line.app.add_subcommand("contacts", "Which solids interfere, where they touch, how far they are apart");
  add_common_options(*verb, settings, 1, 0);
  add_input_class(*verb, settings);
  verb->add_option(
          "-o,--output", settings.output,
          "A picture: the parts and, coloured by pair, where they touch; in place (.ply) or pulled apart (.glb)")
      ->type_name("OUT");
  verb->add_flag("--distance", settings.distances, "Least distances of all pairs that are apart, and where they are");
  verb->add_option("--within", settings.within, "The same of pairs only that are apart by D at most")->type_name("D");
  verb->add_option("--overlap", settings.overlaps, "A folder for what pairs that interfere have in common, a file each")
      ->type_name("DIR");
  verb->add_option("--format", settings.output_format,
                   "Of the files of that folder: off, obj, stl, ply, ...; xoff, which keeps rationals, unless told")
      ->type_name("FORMAT");
  add_rounding_options(*verb, settings);
  verb->footer(fmt::format(
      R"(Every file is a part. Parts interfere when their interiors meet, are in contact when only their boundaries do, and
are apart when they have no point in common: exactly, by the doubles in the files. Gaps of an ulp are gaps.
Parts may touch themselves anywhere; those that cross themselves want --input overlapping.

Examples:
  strata contacts housing.stl shaft.stl bearing.stl --report contacts.json
  strata contacts housing.stl shaft.stl -o contacts.glb --distance --overlap overlaps

{})",
      exit_codes));
  line.on(*verb, [&settings] { return run_contacts(settings); });
}

}  // namespace

void add_contact_verbs(CommandLine& line) { add_contacts(line); }
