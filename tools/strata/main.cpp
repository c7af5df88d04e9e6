#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <functional>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>

#include "chain.h"
#include "draw.h"
#include "exit_code.h"
#include "fuzz/fuzz.h"
#include "planar.h"
#include "settings.h"
#include "strata/io/mesh_file.h"
#include "strata/mesh/defect.h"
#include "verbs.h"
#include "verify/verify.h"

namespace {

using Action = std::function<ExitCode()>;

constexpr const char* exit_codes =
    "Exit codes: 0 ok; 1 the answer is no (different, not a solid); 2 usage; 3 a file cannot be read or written;\n"
    "4 invalid input; 5 the result is not certified; 6 cancelled, out of time or out of memory.";

constexpr const char* examples = R"(Examples:
  strata union left.stl right.stl -o both.stl
  strata difference block.obj drill1.stl drill2.ply -o part.ply --certify --report part.json
  strata intersection a.glb b.3mf -o common.obj --input repair
  cat a.off | strata xor - b.off --input-format off -o - --format off > changed.off
  strata difference block.stl drill.stl -o part.xoff && strata union part.xoff bolt.stl -o whole.xoff
  strata check scan.stl
  strata compare yesterday.stl today.obj
  strata layers house.obj tree.obj -o layers.ply
  strata chain part.json -o part.stl --checkpoint part.save
  strata locate part.stl --points probes.csv -o answers.csv
  strata ray part.stl --rays beams.csv -o hits.csv --all

)";

void add_boolean(CLI::App& app, Settings& settings, Action& action, strata::Operation operation, const char* name,
                 const std::string& what) {
  CLI::App* verb = app.add_subcommand(name, what);
  add_common_options(*verb, settings, 2, 0);
  add_input_class(*verb, settings);
  add_engine(*verb, settings);
  add_output_options(*verb, settings);
  verb->footer(fmt::format("Example:\n  strata {} A.stl B.stl -o OUT.stl\n\n{}", name, exit_codes));
  verb->callback(
      [&, operation, name] { action = [&, operation, name] { return run_boolean(operation, name, settings); }; });
}

void add_eval(CLI::App& app, Settings& settings, Action& action) {
  CLI::App* verb = app.add_subcommand("eval", "An expression over meshes, or a .csg model, evaluated at once");
  verb->add_option("EXPR", settings.expression, "The expression, or the path of a model that OpenSCAD wrote (.csg)")
      ->required();
  verb->add_option("NAME=FILE", settings.bindings, "The mesh that a name stands for; - is standard input")
      ->expected(0, CLI::detail::expected_max_vector_size);
  verb->add_flag_callback(
      "--round-transforms", [&settings] { settings.placement = strata::Placement::rounded; },
      "Round what a model transforms to doubles, once; else it is exact");
  add_run_options(*verb, settings);
  add_input_class(*verb, settings);
  add_output_options(*verb, settings);
  verb->footer(fmt::format(
      R"text(Operators, the strongest first: ~a (all but a; ! is the same), a - b and a + b (union), a & b, a ^ b (in one of them),
a | b; parentheses. Names are letters, digits, _ and dots.

Examples:
  strata eval "(block | boss) - holes" block=block.stl boss=boss.stl holes=holes.obj -o part.stl
  strata eval bracket.csg -o bracket.stl --round-transforms
  strata eval "a & ~(b ^ c)" a=a.off b=b.off c=c.off -o d.off --report -

{})text",
      exit_codes));
  verb->callback([&] { action = [&] { return run_eval(settings); }; });
}

void add_chain(CLI::App& app, Settings& settings, ChainSettings& chain_settings, Action& action) {
  CLI::App* verb = app.add_subcommand("chain", "Many steps, one after the other, exactly; may be stopped and resumed");
  add_chain_options(*verb, chain_settings, settings);
  add_run_options(*verb, settings);
  add_input_class(*verb, settings);
  add_output_options(*verb, settings);
  verb->footer(fmt::format(
      R"text(STEPS.json, with paths relative to it; "start" may be null, "label", "input" and "transform" left out:
  {{"start": {{"file": "block.stl"}},
   "steps": [{{"operation": "difference", "file": "drill.stl", "label": "hole", "input": "solid",
              "transform": [[1, 0, 0, "1/3"], [0, 1, 0, 2], [0, 0, 1, 0.5], [0, 0, 0, 1]]}}]}}

Examples:
  strata chain part.json -o part.xoff --report part-report.json --exact-volumes
  strata chain part.json -o part.stl --checkpoint part.save --checkpoint-every 100 --timeout 3600
  strata chain part.json -o part.stl --checkpoint part.save --resume part.save

{})text",
      exit_codes));
  verb->callback([&] { action = [&] { return run_chain(chain_settings, settings); }; });
}

void add_verbs(CLI::App& app, Settings& settings, Action& action) {
  using strata::Operation;
  add_boolean(app, settings, action, Operation::unite, "union", "What is in any of the meshes");
  add_boolean(app, settings, action, Operation::intersect, "intersection", "What is in all of the meshes");
  add_boolean(app, settings, action, Operation::subtract, "difference", "What is in the first mesh and in no other");
  add_boolean(app, settings, action, Operation::exclude, "xor", "What is in an odd number of the meshes");

  CLI::App* check =
      app.add_subcommand("check", "Is the mesh the boundary of a solid? Lists every defect, writes nothing");
  add_common_options(*check, settings, 1, 1);
  check->footer(fmt::format("Example:\n  strata check scan.stl\n\n{}", exit_codes));
  check->callback([&] { action = [&] { return run_check(settings); }; });

  CLI::App* info = app.add_subcommand("info", "Counts, measures and defects of a mesh, whatever its state");
  add_common_options(*info, settings, 1, 1);
  info->footer(fmt::format("Example:\n  strata info scan.stl --report -\n\n{}", exit_codes));
  info->callback([&] { action = [&] { return run_info(settings); }; });

  CLI::App* compare = app.add_subcommand("compare", "Are two meshes equal as point sets, exactly?");
  add_common_options(*compare, settings, 2, 2);
  add_input_class(*compare, settings);
  compare->footer(fmt::format("Example:\n  strata compare before.stl after.obj\n\n{}", exit_codes));
  compare->callback([&] { action = [&] { return run_compare(settings); }; });
}

void add_draw(CLI::App& app, Settings& settings, DrawSettings& draw_settings, Action& action) {
  CLI::App* draw = app.add_subcommand("draw", "A picture, hidden lines removed exactly, as SVG or PNG");
  add_common_options(*draw, settings, 1, 0);
  add_input_class(*draw, settings);
  add_draw_options(*draw, draw_settings);
  draw->add_option("-o,--output", settings.output, "The picture, .svg or .png; - is standard output")
      ->required()
      ->type_name("OUT");
  draw->footer(fmt::format("Example:\n  strata draw part.stl --direction 1,2,-1 -o part.svg\n\n{}", exit_codes));
  draw->callback([&] { action = [&] { return run_draw(draw_settings, settings); }; });
}

void add_layers(CLI::App& app, Settings& settings, Action& action) {
  CLI::App* verb = app.add_subcommand("layers", "The faces of solids in layers as seen from an origin, back to front");
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
  verb->callback([&] { action = [&] { return run_layers(settings); }; });
}

void add_bsp(CLI::App& app, Settings& settings, Action& action) {
  CLI::App* verb = app.add_subcommand("bsp", "The binary space partition of a solid: how large it is, and its cells");
  add_common_options(*verb, settings, 1, 1);
  add_input_class(*verb, settings);
  verb->add_option("-o,--output", settings.output,
                   "Where its inside leaves go, pulled apart and coloured (.glb); - is standard output")
      ->type_name("OUT.glb");
  verb->footer(
      fmt::format("Examples:\n  strata bsp part.stl --report -\n  strata bsp part.stl -o cells.glb\n\n{}", exit_codes));
  verb->callback([&] { action = [&] { return run_bsp(settings); }; });
}

void add_decompose(CLI::App& app, Settings& settings, Action& action) {
  CLI::App* verb = app.add_subcommand("decompose", "A solid as convex pieces, exactly");
  add_common_options(*verb, settings, 1, 1);
  add_input_class(*verb, settings);
  verb->add_option("-o,--output", settings.output,
                   "A folder for the pieces, a file each, and decomposition.json with their walls; or a picture (.glb)")
      ->type_name("DIR|OUT.glb");
  verb->add_option("--format", settings.output_format,
                   "Of the files of a folder: off, obj, stl, ply, ...; xoff, which keeps rationals, unless told")
      ->type_name("FORMAT");
  verb->add_flag("--exploded", settings.exploded, "Pull the pieces of a picture apart");
  verb->footer(fmt::format(
      R"(Pieces have their interiors apart and make the solid together. Every vertex of a piece is a meet of planes through
vertices of the solid. Where thousands of pieces are too many and approximations do, use V-HACD or CoACD.

Examples:
  strata decompose part.stl -o pieces
  strata decompose part.stl -o pieces.glb --exploded --report -

{})",
      exit_codes));
  verb->callback([&] { action = [&] { return run_decompose(settings); }; });
}

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

void add_planar(CLI::App& app, PlanarSettings& planar, Settings& settings, Action& action) {
  using strata::plane::Operation;
  CLI::App* verb = app.add_subcommand("planar", "Polygons in the plane: Booleans, a clean test, measures");
  verb->require_subcommand(1);
  const auto add = [&](Operation operation, const char* name, const char* what) {
    CLI::App* sub = verb->add_subcommand(name, what);
    add_planar_options(*sub, planar, settings, 1, 0);
    sub->add_option("-o,--output", settings.output, "Where the polygons go; - is standard output")
        ->required()
        ->type_name("OUT");
    sub->add_option("--format", settings.output_format, "wkt, geojson or svg, instead of the extension of OUT")
        ->type_name("FORMAT");
    sub->add_flag("--exact", settings.exact,
                  "Write vertices that are no doubles as quotients (WKT); else the nearest doubles");
    sub->footer(fmt::format("Example:\n  strata planar {} A.geojson B.wkt -o OUT.svg\n\n{}", name, exit_codes));
    sub->callback([&, operation, name] {
      action = [&, operation, name] { return run_planar(operation, name, planar, settings); };
    });
  };
  add(Operation::unite, "union", "What is in any of the files");
  add(Operation::intersect, "intersection", "What is in all of the files");
  add(Operation::subtract, "difference", "What is in the first file and in no other");
  add(Operation::symmetric_difference, "xor", "What is in an odd number of the files");
  CLI::App* check = verb->add_subcommand("check", "Are the loops clean? Lists where they meet themselves");
  add_planar_options(*check, planar, settings, 1, 1);
  check->footer(exit_codes);
  check->callback([&] { action = [&] { return run_planar_check(settings); }; });
  CLI::App* info = verb->add_subcommand("info", "Polygons, holes and exact area of what loops fill");
  add_planar_options(*info, planar, settings, 1, 1);
  info->footer(exit_codes);
  info->callback([&] { action = [&] { return run_planar_info(planar, settings); }; });
}

void add_topology(CLI::App& app, Settings& settings, Action& action) {
  CLI::App* verb =
      app.add_subcommand("topology", "Sets that need not be regular: cells, parts of the boundary, components, holes");
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
  verb->callback([&] { action = [&] { return run_topology(settings); }; });
}

void add_contacts(CLI::App& app, Settings& settings, Action& action) {
  CLI::App* verb = app.add_subcommand("contacts", "Which solids interfere, where they touch, how far they are apart");
  add_common_options(*verb, settings, 1, 0);
  add_input_class(*verb, settings);
  verb->add_option(
          "-o,--output", settings.output,
          "A picture: the parts and, coloured by pair, where they touch; in place (.ply) or pulled apart (.glb)")
      ->type_name("OUT");
  verb->add_flag("--distance", settings.distances, "Least distances of all pairs that are apart, and where they are");
  verb->add_option("--overlap", settings.overlaps, "A folder for what pairs that interfere have in common, a file each")
      ->type_name("DIR");
  verb->add_option("--format", settings.output_format,
                   "Of the files of that folder: off, obj, stl, ply, ...; xoff, which keeps rationals, unless told")
      ->type_name("FORMAT");
  verb->footer(fmt::format(
      R"(Every file is a part. Parts interfere when their interiors meet, are in contact when only their boundaries do, and
are apart when they have no point in common: exactly, by the doubles in the files. Gaps of an ulp are gaps.

Examples:
  strata contacts housing.stl shaft.stl bearing.stl --report contacts.json
  strata contacts housing.stl shaft.stl -o contacts.glb --distance --overlap overlaps

{})",
      exit_codes));
  verb->callback([&] { action = [&] { return run_contacts(settings); }; });
}

void add_hull(CLI::App& app, Settings& settings, Action& action) {
  CLI::App* verb = app.add_subcommand("hull", "The convex hull of all vertices of meshes, and of points");
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
  verb->callback([&] { action = [&] { return run_hull(settings); }; });
}

void add_minkowski(CLI::App& app, Settings& settings, Action& action) {
  const auto add = [&](const char* name, const char* what, bool subtract) {
    CLI::App* verb = app.add_subcommand(name, what);
    add_common_options(*verb, settings, 2, 2);
    add_input_class(*verb, settings);
    add_output_options(*verb, settings);
    verb->footer(fmt::format("Example:\n  strata {} A.stl B.stl -o OUT.stl\n\n{}", name, exit_codes));
    verb->callback([&, subtract] { action = [&, subtract] { return run_minkowski(settings, subtract); }; });
  };
  add("minkowski", "The Minkowski sum: all sums of a point of the first mesh and one of the second", false);
  add("erosion", "Where the second mesh may be moved to and still be within the first", true);

  CLI::App* verb = app.add_subcommand("offset", "A mesh grown or shrunk by a ball of many facets");
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
  verb->callback([&] { action = [&] { return run_offset(settings); }; });
}

void add_locate(CLI::App& app, Settings& settings, Action& action) {
  CLI::App* verb =
      app.add_subcommand("locate", "Which points are in, on or out of solids, in which and on which faces?");
  add_common_options(*verb, settings, 1, 0);
  add_input_class(*verb, settings);
  add_engine(*verb, settings);
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
  verb->callback([&] { action = [&] { return run_locate(settings); }; });
}

void add_ray(CLI::App& app, Settings& settings, Action& action) {
  CLI::App* verb = app.add_subcommand("ray", "Where do rays meet solids: the first hit, or all?");
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
  verb->callback([&] { action = [&] { return run_ray(settings); }; });
}

void add_verify(CLI::App& app, Settings& settings, VerifySettings& verify_settings, Action& action) {
  CLI::App* verb = app.add_subcommand("verify", "Cases with one right answer, asked of this engine or of others");
  add_verify_options(*verb, verify_settings, settings);
  verb->footer(fmt::format(R"(Examples:
  strata verify
  strata verify --tag contact --engine strata --engine manifold3d --report board.html --report results.xml
  strata verify --case ulp-gap-face-union --engine "mine=./my-engine --boolean"

{})",
                           exit_codes));
  verb->callback([&] { action = [&] { return run_verify(verify_settings, settings); }; });
}

void add_fuzz(CLI::App& app, Settings& settings, FuzzSettings& fuzz_settings, Action& action) {
  CLI::App* verb = app.add_subcommand("fuzz", "Random search for broken laws, in this engine or in others");
  add_fuzz_options(*verb, fuzz_settings, settings);
  verb->footer(fmt::format(
      R"(Rounds are questions about solids that touch, of which laws are known: volumes of union and intersection add up, operands
commute, images of results are results of images, ... What does not hold is made small and kept as a case.

Examples:
  strata fuzz --seed 1 --minutes 10
  strata fuzz --seed 1 --rounds 50 --engine manifold3d --engine "mine=./my-engine --boolean"
  strata fuzz --seed 1 --round 17
  strata fuzz --case strata-fuzz-findings/fuzz-volumes-1-17 --engine manifold3d

{})",
      exit_codes));
  verb->callback([&] { action = [&] { return run_fuzz(fuzz_settings, settings); }; });
}

ExitCode complain(ExitCode code, const std::string& message) {
  std::fputs(("strata: " + message + "\n").c_str(), stderr);
  return code;
}

ExitCode complain(const strata::InputError& error, const Settings& settings) {
  const std::string& path = settings.operands.at(error.operand());
  for (const strata::Defect& defect : error.defects()) {
    fmt::print(stderr, "strata: {}: {}: {}\n", path, strata::name(defect.severity), strata::describe(defect));
  }
  return complain(ExitCode::invalid_input, path + " is not what was declared; no result was written");
}

ExitCode run(const Action& action, const Settings& settings) {
  try {
    check_streams(settings);
    const ExitCode code = action();
    return std::fflush(stdout) == 0 ? code : complain(ExitCode::file, "standard output cannot be written");
  } catch (const UsageError& error) {
    return complain(ExitCode::usage, error.what());
  } catch (const strata::IoError& error) {
    return complain(ExitCode::file, error.what());
  } catch (const std::system_error& error) {
    return complain(ExitCode::file, error.what());
  } catch (const strata::InputError& error) {
    return complain(error, settings);
  } catch (const strata::Cancelled& error) {
    return complain(ExitCode::stopped, std::string(error.what()) + "; no result was written");
  } catch (const std::overflow_error& error) {
    return complain(ExitCode::invalid_input, std::string(error.what()) + "; no result was written");
  } catch (const std::bad_alloc&) {
    return complain(ExitCode::stopped, "out of memory");
  } catch (const std::length_error& error) {
    return complain(ExitCode::stopped, error.what());
  } catch (const std::exception& error) {
    return complain(ExitCode::not_certified, std::string("an error of the program, please report it: ") + error.what());
  }
}

}  // namespace

int main(int argc, char** argv) {
  Settings settings;
  DrawSettings draw_settings;
  ChainSettings chain_settings;
  PlanarSettings planar_settings;
  VerifySettings verify_settings;
  FuzzSettings fuzz_settings;
  Action action;
  CLI::App app("Exact Booleans of meshes, on the doubles in the files", "strata");
  app.set_version_flag("--version", "strata " STRATA_VERSION);
  app.require_subcommand(1);
  app.footer(std::string(examples) + exit_codes);
  add_verbs(app, settings, action);
  add_eval(app, settings, action);
  add_chain(app, settings, chain_settings, action);
  add_draw(app, settings, draw_settings, action);
  add_layers(app, settings, action);
  add_bsp(app, settings, action);
  add_decompose(app, settings, action);
  add_topology(app, settings, action);
  add_contacts(app, settings, action);
  add_hull(app, settings, action);
  add_minkowski(app, settings, action);
  add_planar(app, planar_settings, settings, action);
  add_locate(app, settings, action);
  add_ray(app, settings, action);
  add_verify(app, settings, verify_settings, action);
  add_fuzz(app, settings, fuzz_settings, action);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : static_cast<int>(ExitCode::usage);
  }
  return static_cast<int>(run(action, settings));
}
