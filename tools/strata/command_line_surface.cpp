#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <map>
#include <memory>
#include <string>

#include "command_line.h"
#include "settings.h"
#include "surface_verbs.h"

namespace {

using Shared = std::shared_ptr<SurfaceSettings>;

void add_folder(CLI::App& verb, Settings& settings, const char* meshes, const char* document) {
  verb.add_option(
          "-o,--output", settings.output,
          fmt::format("A folder for the {0}, a file each, and {1}, which lists them; or one file, in which they are "
                      "groups (.obj, .ply, .vtk, .msh)",
                      meshes, document))
      ->type_name("DIR|OUT");
  verb.add_option("--format", settings.output_format,
                  "Of the files: off, obj, stl, ply, ...; xoff, which keeps rationals, unless told")
      ->type_name("FORMAT");
  add_strict_option(verb, settings);
}

void add_clip(CommandLine& line, const Shared& surface) {
  Settings& settings = line.settings;
  CLI::App* verb = line.app.add_subcommand("clip", "The part of a surface inside, outside or on a solid");
  add_common_options(*verb, settings, 2, 2);
  add_input_class(*verb, settings);
  std::map<std::string, strata::ClipTo> parts;
  for (const strata::ClipTo part : strata::all_clips) parts.emplace(strata::name(part), part);
  verb->add_option("--keep", surface->keep, "Which part: inside, outside or on (in the solid's boundary)")
      ->transform(CLI::CheckedTransformer(parts))
      ->type_name("PART")
      ->default_str("inside");
  verb->add_option("-o,--output", settings.output, "Where the part goes; - is standard output")
      ->type_name("OUT")
      ->required();
  verb->add_option("--format", settings.output_format, "Format of the part, instead of the extension of OUT")
      ->type_name("FORMAT");
  add_attributes_option(*verb, settings);
  add_strict_option(*verb, settings);
  verb->footer(fmt::format(R"(The first mesh is the surface, open or not, oriented or not; the second one is the solid.

Examples:
  strata clip terrain.obj building.stl -o under.obj
  strata clip terrain.obj building.stl --keep outside -o around.obj

{})",
                           exit_codes));
  line.on(*verb, [&settings, surface] { return run_clip(*surface, settings); });
}

void add_split(CommandLine& line, const Shared& surface) {
  Settings& settings = line.settings;
  CLI::App* verb = line.app.add_subcommand("split", "The pieces into which surfaces and planes divide a solid");
  add_common_options(*verb, settings, 1, 0);
  add_input_class(*verb, settings);
  verb->add_option("--plane", surface->planes,
                   "Also by the plane of the points with a x + b y + c z = d; numbers or fractions; may be repeated")
      ->type_name("a,b,c,d")
      ->delimiter('\0')
      ->allow_extra_args(false)
      ->take_all();
  add_folder(*verb, settings, "pieces", "split.json");
  add_attribute_options(*verb, settings);
  add_rounding_options(*verb, settings);
  verb->footer(fmt::format(
      R"(The first mesh is the solid, the others are surfaces, open or not. Where a surface ends inside the solid it divides
nothing, unless others go on. Pieces make the solid together, exactly.

Examples:
  strata split rock.stl fault.obj horizon.obj -o blocks
  strata split part.stl --plane 0,0,1,10 --plane 1,1,0,1/3 -o pieces --report -

{})",
      exit_codes));
  line.on(*verb, [&settings, surface] { return run_split(*surface, settings); });
}

void add_imprint(CommandLine& line) {
  Settings& settings = line.settings;
  CLI::App* verb =
      line.app.add_subcommand("imprint", "Surfaces with one another's traces as edges; nothing is removed");
  add_common_options(*verb, settings, 1, 0);
  add_folder(*verb, settings, "surfaces", "imprint.json");
  add_attributes_option(*verb, settings);
  verb->footer(fmt::format(R"(Example:
  strata imprint fluid.stl housing.stl -o conformal

{})",
                           exit_codes));
  line.on(*verb, [&settings] { return run_imprint(settings); });
}

void add_cells(CommandLine& line, const Shared& surface) {
  Settings& settings = line.settings;
  CLI::App* verb = line.app.add_subcommand("cells", "Every volume that surfaces enclose together, closed or not");
  add_common_options(*verb, settings, 1, 0);
  add_folder(*verb, settings, "cells", "cells.json");
  add_attributes_option(*verb, settings);
  add_rounding_options(*verb, settings);
  verb->add_flag("--walls", surface->walls,
                 "Also the walls between cells, and walls.csv: the cells in front and behind, the faces of operands. "
                 "Cell 0 is the unbounded one");
  verb->footer(fmt::format(R"(Example:
  strata cells walls.obj roof.obj floor.obj -o rooms --walls

{})",
                           exit_codes));
  line.on(*verb, [&settings, surface] { return run_cells(*surface, settings); });
}

}  // namespace

void add_surface_verbs(CommandLine& line) {
  const auto surface = std::make_shared<SurfaceSettings>();
  add_clip(line, surface);
  add_split(line, surface);
  add_imprint(line);
  add_cells(line, surface);
}
