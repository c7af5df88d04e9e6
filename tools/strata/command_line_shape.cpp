#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string>

#include "command_line.h"
#include "settings.h"
#include "verbs.h"

namespace {

void add_decompose(CommandLine& line) {
  Settings& settings = line.settings;
  CLI::App* verb = line.app.add_subcommand("decompose", "A solid as convex pieces, exactly");
  add_common_options(*verb, settings, 1, 1);
  add_input_class(*verb, settings);
  verb->add_option(
          "-o,--output", settings.output,
          "A folder for the pieces, a file each, and decomposition.json with their walls; or one file, in which "
          "they are groups (.obj, .ply, .vtk, .msh); or a picture (.glb), in the materials and textures of the mesh or "
          "else a color for each piece")
      ->type_name("DIR|OUT");
  verb->add_option("--format", settings.output_format,
                   "Of the files of a folder: off, obj, stl, ply, ...; xoff, which keeps rationals, unless told")
      ->type_name("FORMAT");
  add_rounding_options(*verb, settings);
  add_strict_option(*verb, settings);
  add_attribute_options(*verb, settings);
  verb->add_flag("--volumes", settings.volumes,
                 "Report the outside, cavities and pieces as volumes: shells, neighbours, what is between them");
  verb->add_flag("--exploded", settings.exploded, "Pull the pieces of a picture apart");
  verb->footer(fmt::format(
      R"(Pieces have their interiors apart and make the solid together. Every vertex of a piece is a meet of planes through
vertices of the solid. Where thousands of pieces are too many and approximations do, use V-HACD or CoACD.

Examples:
  strata decompose part.stl -o pieces
  strata decompose part.stl -o pieces.glb --exploded --report -

{})",
      exit_codes));
  line.on(*verb, [&settings] { return run_decompose(settings); });
}

void add_hull(CommandLine& line) {
  Settings& settings = line.settings;
  CLI::App* verb = line.app.add_subcommand("hull", "The convex hull of all vertices of meshes, and of points");
  verb->add_option("MESH", settings.operands, "Mesh files in any state; - is standard input")
      ->expected(0, CLI::detail::expected_max_vector_size);
  verb->add_option("--points", settings.points,
                   "More points: CSV with the columns x,y,z, or PLY; - is standard input (CSV)")
      ->type_name("FILE");
  add_run_options(*verb, settings);
  add_output_options(*verb, settings);
  verb->footer(fmt::format(R"(Examples:
  strata hull part.stl bolt.obj -o hull.stl
  strata hull --points cloud.csv -o hull.xoff --report -

{})",
                           exit_codes));
  line.on(*verb, [&settings] { return run_hull(settings); });
}

void add_sums(CommandLine& line) {
  Settings& settings = line.settings;
  const auto add = [&](const char* name, const char* what, bool subtract) {
    CLI::App* verb = line.app.add_subcommand(name, what);
    add_common_options(*verb, settings, 2, 2);
    add_input_class(*verb, settings);
    add_output_options(*verb, settings);
    verb->footer(fmt::format("Example:\n  strata {} A.stl B.stl -o OUT.stl\n\n{}", name, exit_codes));
    line.on(*verb, [&settings, subtract] { return run_minkowski(settings, subtract); });
  };
  add("minkowski", "The Minkowski sum: all sums of a point of the first mesh and one of the second", false);
  add("erosion", "Where the second mesh may be moved to and still be within the first", true);
}

void add_offset(CommandLine& line) {
  Settings& settings = line.settings;
  CLI::App* verb = line.app.add_subcommand("offset", "A mesh grown or shrunk by a ball of many facets");
  add_common_options(*verb, settings, 1, 1);
  verb->add_option("--by", settings.distance, "The distance, in units of the mesh; negative shrinks")
      ->required()
      ->type_name("R");
  verb->add_option("--facets", settings.facets, "About how many facets the ball has, 20 to 500000")
      ->type_name("N")
      ->check(CLI::Range(20, 500'000))
      ->capture_default_str();
  add_input_class(*verb, settings);
  add_output_options(*verb, settings);
  verb->footer(fmt::format(
      R"(The ball contains the sphere of that radius and lies in one larger by a factor of 1 + excess, which the report has.

Examples:
  strata offset part.stl --by 0.5 -o grown.stl --report -
  strata offset part.stl --by -0.5 --facets 80 -o shrunk.xoff

{})",
      exit_codes));
  line.on(*verb, [&settings] { return run_offset(settings); });
}

}  // namespace

void add_shape_verbs(CommandLine& line) {
  add_decompose(line);
  add_hull(line);
  add_sums(line);
  add_offset(line);
}
