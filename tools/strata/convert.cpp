#include <string>
#include <utility>

#include "common/stopwatch.h"
#include "common/watch.h"
#include "files.h"
#include "report.h"
#include "verbs.h"

ExitCode run_convert(const Settings& given) {
  Watch watch(given.timeout);
  Stopwatch stopwatch;
  Json report = {{"operation", "convert"}, {"operands", Json::array()}, {"seconds", Json::object()}};
  const strata::Format format = output_format(given);
  const std::vector<LoadedMesh> operands = read_operands(given);
  const Settings settings = with_unit_of(operands, given);
  const LoadedMesh& mesh = operands.front();
  report["seconds"]["read"] = stopwatch.lap();
  if (!settings.report.empty()) report["operands"].push_back(operand_report(mesh, {}, settings));
  watch.on_stop(OnStop::finish);
  stopwatch.lap();
  write_output(settings, format, mesh.mesh, mesh.attributes);
  report["seconds"]["write"] = stopwatch.lap();
  report["peak_bytes"] = peak_bytes();
  if (!settings.report.empty()) write_report(settings.report, std::move(report));
  return ExitCode::ok;
}
