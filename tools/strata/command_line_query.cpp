#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "command_line.h"
#include "draw.h"
#include "settings.h"
#include "strata/bsp.h"
#include "verbs.h"

namespace {

void add_draw(CommandLine& line) {
  Settings& settings = line.settings;
  const auto draw = std::make_shared<DrawSettings>();
  CLI::App* verb = line.app.add_subcommand("draw", "A picture, hidden lines removed exactly, as SVG or PNG");
  add_common_options(*verb, settings, 1, 0);
  add_input_class(*verb, settings);
  add_draw_options(*verb, *draw);
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
  verb->add_option("-o,--output", settings.output, "Where the faces go, coloured by layer (PLY); - is standard output")
      ->type_name("OUT.ply");
  verb->footer(fmt::format(R"(Examples:
  strata layers house.obj tree.obj -o layers.ply
  strata layers part.stl --origin direction:0,0,-1 --report -

{})",
                           exit_codes));
  line.on(*verb, [&settings] { return run_layers(settings); });
}

void add_bsp(CommandLine& line) {
  Settings& settings = line.settings;
  CLI::App* verb =
      line.app.add_subcommand("bsp", "The binary space partition of a solid: how large it is, and its cells");
  add_common_options(*verb, settings, 1, 1);
  add_input_class(*verb, settings);
  verb->add_option("-o,--output", settings.output,
                   "Where its inside leaves go, pulled apart and coloured (.glb); - is standard output")
      ->type_name("OUT.glb");
  verb->footer(
      fmt::format("Examples:\n  strata bsp part.stl --report -\n  strata bsp part.stl -o cells.glb\n\n{}", exit_codes));
  line.on(*verb, [&settings] { return run_bsp(settings); });
}

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

void add_locate(CommandLine& line) {
  Settings& settings = line.settings;
  CLI::App* verb =
      line.app.add_subcommand("locate", "Which points are in, on or out of solids, in which and on which faces?");
  add_common_options(*verb, settings, 1, 0);
  add_input_class(*verb, settings);
  add_engine(*verb, settings, {&strata::bsp_engine});
  verb->add_option("--points", settings.points,
                   "The points: CSV with the columns x,y,z, or PLY; - is standard input (CSV)")
      ->required()
      ->type_name("FILE");
  verb->add_option("-o,--output", settings.output, "Where the answers go: CSV, or PLY; - is standard output (CSV)")
      ->required()
      ->type_name("OUT");
  verb->add_flag("--all", settings.all, "List all solids at a point, not the lowest only");
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

void add_query_verbs(CommandLine& line) {
  add_draw(line);
  add_layers(line);
  add_bsp(line);
  add_topology(line);
  add_contacts(line);
  add_locate(line);
  add_ray(line);
}
