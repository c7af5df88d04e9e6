#include "settings.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <map>
#include <string>

#include "strata/combine.h"

void add_common_options(CLI::App& verb, Settings& settings, int least, int most) {
  verb.add_option("MESH", settings.operands, "Mesh files; - is standard input")
      ->required()
      ->expected(least, most == 0 ? CLI::detail::expected_max_vector_size : most);
  if (most == 0) verb.add_flag("--objects", settings.objects, "Each object of a file is an operand, not the file");
  add_run_options(verb, settings);
}

void add_run_options(CLI::App& verb, Settings& settings) {
  verb.add_option("--input-format", settings.input_format, "Format of the operands, instead of their extension")
      ->type_name("FORMAT");
  verb.add_option("--unit", settings.unit,
                  "Unit of operands whose files say none: micron, millimeter, centimeter, inch, foot or meter")
      ->type_name("UNIT");
  verb.add_option("--report", settings.report, "Write a report in JSON; - is standard output")->type_name("FILE");
  verb.add_option("-j,--threads", settings.threads, "Threads; the result does not depend on it")->type_name("N");
  verb.add_option("--timeout", settings.timeout, "Give up after this time, with exit code 6")
      ->type_name("SECONDS")
      ->check(CLI::PositiveNumber);
  verb.add_flag("--progress", settings.progress, "Show progress at once, also when not on a terminal");
  verb.add_flag("-q,--quiet", settings.quiet, "Errors only");
}

void add_engine(CLI::App& verb, Settings& settings, const std::vector<const strata::Engine*>& engines) {
  std::map<std::string, const strata::Engine*> by_name = {{"arrangement", nullptr}};
  for (const strata::Engine* e : engines) by_name.emplace(e->name, e);
  verb.add_option_function<std::string>(
          "--engine", [&settings, by_name](const std::string& word) { settings.engine = by_name.at(word); },
          "What computes the answer, which is the same: arrangement, for all sizes; bsp, binary space partitions; "
          "layers, signed coverings about an origin")
      ->type_name("ENGINE")
      ->check(CLI::IsMember(by_name))
      ->default_str("arrangement");
}

void add_input_class(CLI::App& verb, Settings& settings) {
  std::map<std::string, strata::InputClass> classes;
  for (const strata::InputClass input : strata::all_input_classes) classes.emplace(strata::name(input), input);
  verb.add_option_function<std::string>(
          "--input", [&settings, classes](const std::string& word) { settings.input = classes.at(word); },
          "What the operands are: automatic (closed; what crosses itself is found and resolved), solid (closed, and a "
          "promise that it does not cross itself, nor touch itself but in common vertices and edges), overlapping "
          "(closed, may cross itself), "
          "repair (a soup that is closed once equal vertices are one) or soup (any triangles: holes are filled)")
      ->type_name("CLASS")
      ->check(CLI::IsMember(classes))
      ->default_str("automatic");
}

void add_input_class_and_holes(CLI::App& verb, Settings& settings) {
  add_input_class(verb, settings);
  verb.add_option_function<std::string>(
          "--fill-holes",
          [&settings](const std::string& word) {
            settings.input = strata::InputClass::soup;
            if (word == "all") return;
            const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), settings.most_hole_edges);
            if (error != std::errc{} || end != word.data() + word.size())
              throw CLI::ValidationError("--fill-holes", "all or a number of edges, not " + word);
          },
          "The same as --input soup: all holes are filled, or those of at most N edges and others refused")
      ->type_name("all|N")
      ->excludes("--input");
}

void add_output_file(CLI::App& verb, Settings& settings) {
  verb.add_option("-o,--output", settings.output, "Where the result goes; - is standard output")
      ->required()
      ->type_name("OUT");
  verb.add_option("--format", settings.output_format, "Format of the result, instead of the extension of OUT")
      ->type_name("FORMAT");
  add_strict_option(verb, settings);
}

void add_strict_option(CLI::App& verb, Settings& settings) {
  verb.add_flag("--strict", settings.strict, "What the format cannot keep is an error, and not only told");
}

void add_output_options(CLI::App& verb, Settings& settings) {
  add_output_file(verb, settings);
  verb.add_option(
          "--touching", settings.touching,
          "Edges and vertices in which the result touches itself: shared (listed once), separate (a copy for each "
          "sheet: a 2-manifold) or refuse (exit code 5, nothing is written)")
      ->type_name("HOW")
      ->check(CLI::IsMember({"shared", "separate", "refuse"}))
      ->default_str("shared");
  add_rounding_options(verb, settings);
  verb.add_flag("--certify", settings.certify,
                "Check that no faces cross in the rounded result; exit code 5 if some do");
}

void add_rounding_options(CLI::App& verb, Settings& settings, const std::string& valid) {
  verb.add_option("--rounding", settings.rounding,
                  "How exact vertices become the numbers that a file can hold: valid (" + valid +
                      ") or nearest (each by itself)")
      ->type_name("HOW")
      ->check(CLI::IsMember({"valid", "nearest"}))
      ->default_str("valid");
  verb.add_option("--grid", settings.grid,
                  "Coordinates are multiples of this, as 0.001 or 1/1024; implies --rounding valid")
      ->type_name("STEP");
}

void add_origin_option(CLI::App& verb, Settings& settings) {
  verb.add_option("--origin", settings.origin,
                  "Where the scene is seen from: a point, a direction along which all rays run, or auto")
      ->type_name("x,y,z|auto|direction:x,y,z")
      ->default_str("auto");
}

void check_streams(const Settings& settings) {
  const auto from_stdin = std::count(settings.operands.begin(), settings.operands.end(), "-");
  if (from_stdin > 1) throw UsageError("standard input can be one operand only");
  if (from_stdin == 1 && settings.points == "-")
    throw UsageError("standard input cannot be both a mesh and the points");
  if (from_stdin == 1 && settings.rays == "-") throw UsageError("standard input cannot be both a mesh and the rays");
  if (from_stdin == 1 && settings.input_format.empty()) throw UsageError("standard input needs --input-format");
  if (settings.output == "-" && settings.report == "-") {
    throw UsageError("result and report cannot both go to standard output");
  }
}
