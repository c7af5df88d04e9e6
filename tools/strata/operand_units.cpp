#include "operand_units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/tell.h"

using strata::Unit;

strata::Unit unit_in(const Settings& settings) {
  if (settings.unit.empty()) return Unit::none;
  if (const auto unit = strata::unit_named(settings.unit)) return *unit;
  throw UsageError(
      fmt::format("unknown unit {}; known are micron, millimeter, centimeter, inch, foot and meter", settings.unit));
}

void convert(LoadedMesh& mesh, Unit to) {
  const strata::Rational factor = strata::ratio(mesh.unit, to);
  mesh.unit = to;
  if (factor == 1) return;
  strata::ExactMesh converted;
  converted.mesh.triangles = std::move(mesh.mesh.mesh.triangles);
  for (std::size_t v = 0; v < mesh.mesh.mesh.vertices.size(); ++v) {
    const auto number = static_cast<std::uint32_t>(v);
    strata::ExactVertex exact{number, mesh.mesh.position(number)};
    strata::Vertex rounded;
    bool is_rounded = false;
    for (std::size_t k = 0; k < 3; ++k) {
      exact.position[k] *= factor;
      rounded[k] = strata::to_nearest_double(exact.position[k]);
      if (!std::isfinite(rounded[k]))
        throw strata::IoError(mesh.path, {},
                              "a coordinate in the unit of the first operand is beyond the range of doubles");
      is_rounded |= strata::Rational(rounded[k]) != exact.position[k];
    }
    converted.mesh.vertices.push_back(rounded);
    if (is_rounded) converted.exact.push_back(std::move(exact));
  }
  mesh.mesh = std::move(converted);
}

void use_one_unit(std::vector<LoadedMesh>& operands, const Settings& settings) {
  const Unit given = unit_in(settings);
  for (LoadedMesh& mesh : operands)
    if (mesh.unit == Unit::none) mesh.unit = given;
  const auto first =
      std::find_if(operands.begin(), operands.end(), [](const LoadedMesh& m) { return m.unit != Unit::none; });
  if (first == operands.end()) return;
  const Unit unit = first->unit;
  const auto say = [&](const LoadedMesh& mesh, const std::string& what) {
    if (!settings.quiet) tell("strata: {}: note: {}\n", mesh.path, what);
  };
  for (LoadedMesh& mesh : operands) {
    if (mesh.unit == Unit::none) {
      say(mesh, fmt::format("says no unit: taken for {}, as that of {}; --unit can say another", strata::name(unit),
                            first->path));
      mesh.unit = unit;
    } else if (mesh.unit != unit) {
      say(mesh, fmt::format("converted from {} to {}, exactly", strata::name(mesh.unit), strata::name(unit)));
      convert(mesh, unit);
    }
  }
}
