#include <fmt/format.h>

#include <utility>

#include "common/stopwatch.h"
#include "common/watch.h"
#include "files.h"
#include "report.h"
#include "strata/check.h"
#include "verbs.h"

ExitCode run_compare(const Settings& settings) {
  const Watch watch(settings.timeout);
  Stopwatch stopwatch;
  Json report = {{"operation", "compare"}, {"operands", Json::array()}};
  const std::vector<LoadedMesh> operands = read_operands(settings);
  report["seconds"]["read"] = stopwatch.lap();
  const strata::Solid first = make_solid(operands, 0, settings), second = make_solid(operands, 1, settings);
  const bool equal = first == second;
  report["seconds"]["evaluate"] = stopwatch.lap();
  report["peak_bytes"] = peak_bytes();

  report["equal"] = equal;
  if (!settings.report.empty()) {
    for (const LoadedMesh& operand : operands) {
      report["operands"].push_back(
          operand_report(operand, strata::defects_as_operand(operand.mesh, settings.input), settings));
    }
    write_report(settings.report, std::move(report));
  }
  if (!settings.quiet && settings.report != "-") fmt::print("{}\n", equal ? "equal" : "different");
  return equal ? ExitCode::ok : ExitCode::negative;
}
