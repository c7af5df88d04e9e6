#pragma once
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "attribute_options.h"
#include "common/usage_error.h"
#include "strata/options.h"
#include "strata/transform.h"

namespace CLI {
class App;
}  // namespace CLI

/// What the command line asked for. Each verb uses the part that it has options for.
struct Settings {
  std::vector<std::string> operands;                       ///< paths; "-" is stdin
  std::string expression;                                  ///< or the path of a model
  std::vector<std::string> bindings;                       ///< NAME=FILE, for names of the expression
  strata::Placement placement = strata::Placement::exact;  ///< of what a model transforms
  bool any_path = false;                                   ///< a model may read files that are not beneath its folder
  std::vector<std::string> fonts;                          ///< files, for texts of a model
  std::vector<std::string> definitions;                    ///< NAME=VALUE, for variables of a program of OpenSCAD
  std::string openscad = "openscad";                       ///< the program that evaluates it
  std::string input_format;                                ///< of all operands; empty: by extension
  strata::InputClass input = strata::InputClass::automatic;
  strata::Inside inside = strata::Inside::winding;
  const strata::Engine* engine = nullptr;  ///< none: the arrangement
  std::string output;                      ///< path; "-" is stdout
  std::string output_format;               ///< empty: by extension
  AttributeSettings attributes;            ///< which ones are carried, and what cuts are made of
  std::string unit;                        ///< of operands whose files say none; empty: none
  bool objects = false;                    ///< each object of a file is an operand
  bool strict = false;                     ///< what a format cannot keep is an error
  bool tells_losses = true;                ///< else it is not told, since it was told of a file like this one
  std::string report;                      ///< path of the JSON report; "-" is stdout; empty: none
  std::uint64_t max_defects = 100;         ///< of one kind that are printed
  bool certify = false;
  std::string touching = "shared";  ///< what sheets that touch share: shared, separate or refuse
  std::string rounding = "valid";   ///< valid: solids again; nearest: each vertex by itself
  std::string grid;                 ///< step of coordinates; empty: all numbers of the format
  std::string target;               ///< of round: float64, float32 or a step
  std::string origin = "auto";      ///< x,y,z, direction:x,y,z or auto
  std::string points;               ///< path of the points to locate; "-" is stdin
  std::string rays;                 ///< path of the rays to cast; "-" is stdin
  bool all = false;                 ///< list all solids at a point, or all hits of a ray
  bool first = false;               ///< list the first hit of a ray only
  bool exploded = false;            ///< pieces pulled apart
  bool exact = false;               ///< rationals beside doubles
  bool distances = false;           ///< of all parts that are apart
  std::optional<double> within;     ///< of parts that are apart by this at most
  std::string overlaps;             ///< folder for what parts have in common
  double distance = 0;              ///< by which a solid is grown, or shrunk if it is negative
  std::uint32_t facets = 320;       ///< of the ball that does it, about
  std::size_t most_hole_edges = std::numeric_limits<std::size_t>::max();  ///< of input class soup
  unsigned threads = 0;                                                   ///< 0: all cores
  bool quiet = false;
  bool progress = false;
  double timeout = 0;  ///< seconds; 0: none

  std::vector<std::string> operators;  ///< of topology, one after the other
  std::vector<std::string> open;       ///< names of operands without their boundaries

  bool volumes = false;  ///< report space as the pieces of a solid divide it
  bool nearest = false;  ///< tell the point of the boundary that is nearest to each point

  /// Must what is rounded be a solid?
  [[nodiscard]] bool makes_solids() const { return rounding == "valid" || !grid.empty(); }
};

/// Whatever all verbs have.
void add_run_options(CLI::App& verb, Settings& settings);

/// The same and operands. `least` and `most` bound their number; most 0: no bound.
void add_common_options(CLI::App& verb, Settings& settings, int least, int most);

/// --input CLASS.
void add_input_class(CLI::App& verb, Settings& settings);

/// --input CLASS, and --fill-holes all|N in its place: input class soup, with a limit.
void add_input_class_and_holes(CLI::App& verb, Settings& settings);

/// --engine, with the arrangement and these.
void add_engine(CLI::App& verb, Settings& settings, const std::vector<const strata::Engine*>& engines);

/// -o and --format.
void add_output_file(CLI::App& verb, Settings& settings);

/// The same and what goes with making a solid.
void add_output_options(CLI::App& verb, Settings& settings);

/// --strict, which is among the options above, for verbs that have others.
void add_strict_option(CLI::App& verb, Settings& settings);

/// --attributes all|none|NAME,...
void add_attributes_option(CLI::App& verb, Settings& settings);

/// The same and --cut-material NAME.
void add_attribute_options(CLI::App& verb, Settings& settings);

/// --rounding valid|nearest, --grid.
void add_rounding_options(
    CLI::App& verb, Settings& settings,
    const std::string& valid = "where faces would cross, they are rearranged, so that the file holds a solid");

/// --origin x,y,z|auto|direction:x,y,z.
void add_origin_option(CLI::App& verb, Settings& settings);

/// Throws UsageError where stdin or stdout would be used twice.
void check_streams(const Settings& settings);
