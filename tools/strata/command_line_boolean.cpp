#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <map>
#include <string>

#include "command_line.h"
#include "extensions.h"
#include "settings.h"
#include "verbs.h"

namespace {

void add_boolean(CommandLine& line, strata::Operation operation, const std::string& what) {
  Settings& settings = line.settings;
  const char* name = strata::name(operation);
  CLI::App* verb = line.app.add_subcommand(name, what);
  if (operation == strata::Operation::symmetric_difference) verb->alias("xor");
  add_common_options(*verb, settings, 1, 0);
  add_input_class_and_holes(*verb, settings);
  add_engine(*verb, settings, boolean_engines());
  add_attribute_options(*verb, settings);
  add_output_options(*verb, settings);
  verb->footer(fmt::format("Example:\n  strata {} A.stl B.stl -o OUT.stl\n\n{}", name, exit_codes));
  line.on(*verb, [&settings, operation, name] { return run_boolean(operation, name, settings); });
}

void add_resolve(CommandLine& line) {
  Settings& settings = line.settings;
  CLI::App* verb = line.app.add_subcommand("resolve", "A mesh that crosses and overlaps itself, made a solid");
  add_common_options(*verb, settings, 1, 1);
  add_input_class_and_holes(*verb, settings);
  std::map<std::string, strata::Inside> insides;
  for (const strata::Inside inside : strata::all_insides) insides.emplace(strata::name(inside), inside);
  verb->add_option(
          "--keep", settings.inside,
          "What is inside: winding (where the winding number is positive), even-odd (where it is odd) or outer "
          "(all that the mesh closes off, without cavities)")
      ->transform(CLI::CheckedTransformer(insides))
      ->type_name("RULE")
      ->default_str("winding");
  add_attributes_option(*verb, settings);
  add_output_options(*verb, settings);
  verb->footer(fmt::format(R"(Examples:
  strata resolve crossing.stl -o solid.stl
  strata resolve shells.obj --keep outer -o hull.obj --report -

{})",
                           exit_codes));
  line.on(*verb, [&settings] { return run_resolve(settings); });
}

void add_round(CommandLine& line) {
  Settings& settings = line.settings;
  CLI::App* verb = line.app.add_subcommand("round", "A solid with coordinates of fewer digits that is a solid still");
  add_common_options(*verb, settings, 1, 1);
  add_input_class(*verb, settings);
  verb->add_option("--to", settings.target,
                   "What coordinates become: float64, float32, or multiples of a step, as 0.001 or 1/1024")
      ->required()
      ->type_name("float64|float32|STEP");
  add_attributes_option(*verb, settings);
  add_output_file(*verb, settings);
  verb->footer(fmt::format(
      R"(Faces stay as they are where rounded ones do not cross, and are rearranged where they do. What is thinner than
the grid may vanish; the report says so.

Examples:
  strata round part.xoff --to float32 -o part.ply
  strata round part.obj --to 0.001 -o part.stl --report -

{})",
      exit_codes));
  line.on(*verb, [&settings] { return run_round(settings); });
}

void add_eval(CommandLine& line) {
  Settings& settings = line.settings;
  CLI::App* verb =
      line.app.add_subcommand("eval", "An expression over meshes, or a model of OpenSCAD, evaluated at once");
  verb->add_option(
          "EXPR", settings.expression,
          "The expression, or the path of a model of OpenSCAD (.csg; .scad, if the program openscad is installed)")
      ->required();
  // Newer CLI11 takes no sign of equality in names.
  verb->add_option("MESH", settings.bindings, "NAME=FILE: the mesh that a name stands for; - is standard input")
      ->expected(0, CLI::detail::expected_max_vector_size);
  verb->add_flag_callback(
      "--round-transforms", [&settings] { settings.placement = strata::Placement::rounded; },
      "Round what a model transforms to doubles, once; else it is exact");
  verb->add_flag("--allow-path", settings.any_path, "A model may read files that are not beneath its own folder");
  verb->add_option("--font", settings.fonts, "A file of fonts that a model may name, besides those of the system")
      ->type_name("FILE")
      ->allow_extra_args(false);
  verb->add_option("-D", settings.definitions, "Of a .scad model: a variable's value, as in openscad")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  verb->add_option("--openscad", settings.openscad, "Of a .scad model: the program that evaluates it")
      ->type_name("PROGRAM")
      ->capture_default_str();
  verb->add_flag("--exact", settings.exact,
                 "Of a model in the plane, as WKT: quotients where coordinates are not doubles");
  add_run_options(*verb, settings);
  add_input_class_and_holes(*verb, settings);
  add_engine(*verb, settings, formula_engines());
  add_attribute_options(*verb, settings);
  add_output_options(*verb, settings);
  verb->footer(fmt::format(
      R"text(Operators, the strongest first: ~a (all but a; ! is the same), a - b and a + b (union), a & b, a ^ b (in one of them),
a | b; parentheses. Names are letters, digits, _ and dots.

Examples:
  strata eval "(block | boss) - holes" block=block.stl boss=boss.stl holes=holes.obj -o part.stl
  strata eval bracket.csg -o bracket.stl --round-transforms
  strata eval plate.scad -D width=40 -o plate.3mf
  strata eval outline.csg -o outline.svg
  strata eval "a & ~(b ^ c)" a=a.off b=b.off c=c.off -o d.off --report -

{})text",
      exit_codes));
  line.on(*verb, [&settings] { return run_eval(settings); });
}

void add_check(CommandLine& line) {
  Settings& settings = line.settings;
  CLI::App* verb =
      line.app.add_subcommand("check", "Is the mesh the boundary of a solid? Lists every defect, writes nothing");
  add_common_options(*verb, settings, 1, 1);
  verb->add_option("--max-defects", settings.max_defects,
                   "How many of one kind are printed; all are counted, and all are in the report")
      ->type_name("N")
      ->default_str("100");
  verb->footer(fmt::format("Example:\n  strata check scan.stl\n\n{}", exit_codes));
  line.on(*verb, [&settings] { return run_check(settings); });
}

void add_info(CommandLine& line) {
  Settings& settings = line.settings;
  CLI::App* verb = line.app.add_subcommand("info", "Counts, measures and defects of a mesh, whatever its state");
  add_common_options(*verb, settings, 1, 1);
  verb->footer(fmt::format("Example:\n  strata info scan.stl --report -\n\n{}", exit_codes));
  line.on(*verb, [&settings] { return run_info(settings); });
}

void add_convert(CommandLine& line) {
  Settings& settings = line.settings;
  CLI::App* verb = line.app.add_subcommand("convert", "A mesh, whatever its state, in another format");
  add_common_options(*verb, settings, 1, 1);
  add_attributes_option(*verb, settings);
  add_output_file(*verb, settings);
  verb->footer(fmt::format(
      R"(Colours, texture coordinates, normals, materials, images, names and units come along where the format has them. What
it cannot keep is told, and is an error with --strict.

Examples:
  strata convert part.3mf -o part.glb
  strata convert scan.ply -o scan.3mf --unit millimeter --strict

{})",
      exit_codes));
  line.on(*verb, [&settings] { return run_convert(settings); });
}

void add_compare(CommandLine& line) {
  Settings& settings = line.settings;
  CLI::App* verb = line.app.add_subcommand("compare", "Are two meshes equal as point sets, exactly?");
  add_common_options(*verb, settings, 2, 2);
  add_input_class(*verb, settings);
  verb->footer(fmt::format("Example:\n  strata compare before.stl after.obj\n\n{}", exit_codes));
  line.on(*verb, [&settings] { return run_compare(settings); });
}

void add_view(CommandLine& line) {
  Settings& settings = line.settings;
  CLI::App* verb =
      line.app.add_subcommand("view", "A page that shows meshes, to be turned, hidden and cut in a browser");
  verb->add_option("MESH", settings.bindings,
                   "Mesh files, called a, b, c, ... in order in the expression, or NAME=FILE; - is standard input")
      ->required()
      ->expected(1, CLI::detail::expected_max_vector_size);
  verb->add_option("--expression", settings.expression,
                   "Of names, with | & - ^ ~ and parentheses: its value is shown, and operands are hidden at first")
      ->type_name("E");
  verb->add_option("-o,--output", settings.output, "The page; - is standard output")->required()->type_name("OUT.html");
  add_run_options(*verb, settings);
  add_input_class(*verb, settings);
  verb->footer(fmt::format(
      R"(The page has everything inside and needs no network. It lists volumes, exactly where they are short, and areas.

Examples:
  strata view part.stl -o part.html
  strata view block.stl drill.stl --expression "a - b" -o result.html

{})",
      exit_codes));
  line.on(*verb, [&settings] { return run_view(settings); });
}

}  // namespace

void add_boolean_verbs(CommandLine& line) {
  using strata::Operation;
  if (line.wants({"union"})) add_boolean(line, Operation::union_, "What is in any of the meshes");
  if (line.wants({"intersection"})) add_boolean(line, Operation::intersection, "What is in all of the meshes");
  if (line.wants({"difference"})) add_boolean(line, Operation::difference, "What is in the first mesh and in no other");
  if (line.wants({"symmetric-difference", "xor"}))
    add_boolean(line, Operation::symmetric_difference, "What is in an odd number of the meshes");
  if (line.wants({"resolve"})) add_resolve(line);
  if (line.wants({"round"})) add_round(line);
  if (line.wants({"eval"})) add_eval(line);
  if (line.wants({"check"})) add_check(line);
  if (line.wants({"info"})) add_info(line);
  if (line.wants({"convert"})) add_convert(line);
  if (line.wants({"compare"})) add_compare(line);
  if (line.wants({"view"})) add_view(line);
}
