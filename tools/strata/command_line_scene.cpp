#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "command_line.h"
#include "draw.h"
#include "extensions.h"
#include "settings.h"
#include "verbs.h"

namespace {

void add_draw(CommandLine& line) {
  Settings& settings = line.settings;
  const auto draw = std::make_shared<DrawSettings>();
  CLI::App* verb = line.app.add_subcommand("draw", "A picture, hidden lines removed exactly, as SVG or PNG");
  add_common_options(*verb, settings, 1, 0);
  add_input_class(*verb, settings);
  add_draw_options(*verb, *draw);
  add_attributes_option(*verb, settings);
  verb->add_option("-o,--output", settings.output, "The picture, .svg or .png; - is standard output")
      ->required()
      ->type_name("OUT");
  verb->footer(fmt::format("Example:\n  strata draw part.stl --direction 1,2,-1 -o part.svg\n\n{}", exit_codes));
  line.on(*verb, [&settings, draw] { return run_draw(*draw, settings); });
}

void add_layers(CommandLine& line) {
  Settings& settings = line.settings;
  CLI::App* verb =
      line.app.add_subcommand("layers", "The faces of solids in layers as seen from an origin, back to front");
  add_common_options(*verb, settings, 1, 0);
  add_input_class(*verb, settings);
  add_origin_option(*verb, settings);
  verb->add_option(
          "-o,--output", settings.output,
          "Where the faces go, coloured by layer: PLY, or a picture in glTF (.glb); - is standard output, in PLY")
      ->type_name("OUT.ply|OUT.glb");
  verb->footer(fmt::format(R"(Examples:
  strata layers house.obj tree.obj -o layers.ply
  strata layers part.stl --origin direction:0,0,-1 --report -

{})",
                           exit_codes));
  line.on(*verb, [&settings] { return run_layers(settings); });
}

void add_locate(CommandLine& line) {
  Settings& settings = line.settings;
  CLI::App* verb =
      line.app.add_subcommand("locate", "Which points are in, on or out of solids, in which and on which faces?");
  add_common_options(*verb, settings, 1, 0);
  add_input_class(*verb, settings);
  add_engine(*verb, settings, locating_engines());
  verb->add_option("--points", settings.points,
                   "The points: CSV with the columns x,y,z, or PLY; - is standard input (CSV)")
      ->required()
      ->type_name("FILE");
  verb->add_option("-o,--output", settings.output, "Where the answers go: CSV, or PLY; - is standard output (CSV)")
      ->required()
      ->type_name("OUT");
  verb->add_flag("--all", settings.all, "List all solids at a point, not the lowest only");
  verb->add_flag("--nearest", settings.nearest,
                 "Four more columns: the distance to the nearest boundary, negative inside, and the point of it");
  verb->footer(fmt::format(
      R"(Rows are x,y,z,where,solid,face: where is in, on or out; solid is the lowest solid that the point is on, else in;
face is the lowest face of that solid that it is on. Solids and faces are counted from 0, in the order of the files.
In PLY, where is 0 (out), 1 (on) or 2 (in), and what there is not is -1.

Examples:
  strata locate part.stl --points probes.csv -o answers.csv
  generate | strata locate a.off b.off --points - -o - --all | grep ,on,

{})",
      exit_codes));
  line.on(*verb, [&settings] { return run_locate(settings); });
}

void add_ray(CommandLine& line) {
  Settings& settings = line.settings;
  CLI::App* verb = line.app.add_subcommand("ray", "Where do rays meet solids: the first hit, or all?");
  add_common_options(*verb, settings, 1, 0);
  add_input_class(*verb, settings);
  verb->add_option("--rays", settings.rays, "The rays: CSV with the columns x,y,z,dx,dy,dz; - is standard input")
      ->required()
      ->type_name("FILE");
  verb->add_option("-o,--output", settings.output, "Where the hits go: CSV; - is standard output")
      ->required()
      ->type_name("OUT");
  verb->add_flag("--first", settings.first, "The first hit of each ray (default)");
  verb->add_flag("--all", settings.all, "All hits of each ray");
  verb->add_flag("--exact", settings.exact, "Four more columns: the place and t as rationals");
  verb->footer(fmt::format(
      R"(Rows are ray,hit,x,y,z,t,solid,face,passage: the place is x,y,z + t * (dx,dy,dz) of the ray, in nearest doubles; passage
is entering, leaving, touching or along (the surface). Rays, hits, solids and faces are counted from 0, in the order of
the files. A ray that meets nothing has a row with its number only.

Examples:
  strata ray part.stl --rays beams.csv -o hits.csv
  generate | strata ray a.off b.off --rays - -o - --all --exact

{})",
      exit_codes));
  line.on(*verb, [&settings] { return run_ray(settings); });
}

}  // namespace

void add_scene_verbs(CommandLine& line) {
  add_draw(line);
  add_layers(line);
  add_locate(line);
  add_ray(line);
}
