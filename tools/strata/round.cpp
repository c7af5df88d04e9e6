#include <string>
#include <utility>

#include "common/stopwatch.h"
#include "common/watch.h"
#include "files.h"
#include "report.h"
#include "rounded_output.h"
#include "strata/carry_attributes.h"
#include "verbs.h"

namespace {

using strata::CoordinateGrid;

CoordinateGrid grid_named(const std::string& target) {
  CoordinateGrid grid;
  if (target == "float32") grid.format = CoordinateGrid::Format::float32;
  if (target != "float32" && target != "float64") grid.step = parse_step("--to", target);
  return grid;
}

/// Some formats hold floats, whatever was asked for.
CoordinateGrid grid_for(const Settings& settings, strata::Format format) {
  CoordinateGrid grid = grid_named(settings.target);
  if (strata::holds_floats(format)) grid.format = CoordinateGrid::Format::float32;
  return grid;
}

}  // namespace

ExitCode run_round(const Settings& given) {
  Watch watch(given.timeout);
  Stopwatch stopwatch;
  Json report = {{"operation", "round"}, {"to", given.target}, {"operands", nullptr}, {"result", nullptr}};
  const strata::Format format = output_format(given);
  const CoordinateGrid grid = grid_for(given, format);
  const std::vector<LoadedMesh> operands = read_operands(given);
  const Settings settings = with_unit_of(operands, given);
  report["seconds"]["read"] = stopwatch.lap();
  const strata::Solid solid = make_attributed_solid(operands, 0, settings);

  watch.on_stop(OnStop::ask);
  strata::RoundedMesh rounded;
  try {
    rounded = rounded_for_output(solid.exact_mesh(), grid, settings, &watch.token());
  } catch (const strata::Cancelled&) {
    watch.on_stop(OnStop::leave);  // says why
    throw;
  }
  report["seconds"]["evaluate"] = stopwatch.lap();
  report["peak_bytes"] = peak_bytes();
  print_rounding(rounded.report, settings);
  strata::Attributes attributes;
  if (!solid.attributes().empty())
    attributes = strata::carry_attributes({solid.exact_mesh(), &solid.attributes()}, rounded, grid);
  const strata::ExactMesh mesh{std::move(rounded.mesh), {}};
  if (!settings.report.empty()) {
    report["operands"] = Json::array({operand_report(operands.front(), solid.notes(), settings)});
    report["result"] = result_report(measured(mesh, settings), {});
    report["result"]["rounding"] = to_json(rounded.report, mesh.mesh);
  }
  watch.on_stop(OnStop::finish);
  stopwatch.lap();
  write_output(settings, format, mesh, attributes);
  report["seconds"]["write"] = stopwatch.lap();
  if (!settings.report.empty()) write_report(settings.report, std::move(report));
  if (!strays(rounded.report)) return ExitCode::ok;
  print_strays(rounded.report);
  return ExitCode::not_certified;
}
