#include "strata/check.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/progress.h"
#include "common/stopwatch.h"
#include "common/watch.h"
#include "files.h"
#include "report.h"
#include "verbs.h"

namespace {

std::vector<strata::Defect> diagnose(const strata::ExactMesh& mesh, const Settings& settings, const Watch& watch) {
  ProgressBar bar(settings.progress, settings.quiet);
  strata::Options options;
  options.threads = settings.threads;
  options.progress = [&bar](double fraction) { bar.show(fraction); };
  options.cancel = &watch.token();
  return strata::check(mesh, options);
}

void print_verdict(const LoadedMesh& operand, bool solid, std::span<const strata::Defect> defects) {
  fmt::print("{}: {}\n", operand.path, solid ? "a solid" : "not a solid");
  for (const strata::Defect& defect : defects) {
    fmt::print("  {}: {}\n", strata::name(defect.severity), strata::describe(defect));
  }
}

}  // namespace

ExitCode run_check(const Settings& settings) {
  Watch watch(settings.timeout);
  Stopwatch stopwatch;
  Json report = {{"operation", "check"}, {"operands", Json::array()}};
  const LoadedMesh operand = std::move(read_operands(settings).front());
  report["seconds"]["read"] = stopwatch.lap();

  watch.on_stop(OnStop::ask);
  std::vector<strata::Defect> defects;
  try {
    defects = diagnose(operand.mesh, settings, watch);
  } catch (const strata::Cancelled&) {
    watch.on_stop(OnStop::leave);  // says why
    throw;
  }
  report["seconds"]["evaluate"] = stopwatch.lap();
  report["peak_bytes"] = peak_bytes();
  const bool solid = std::none_of(defects.begin(), defects.end(), [](const strata::Defect& defect) {
    return defect.severity == strata::Severity::error;
  });

  watch.on_stop(OnStop::leave);
  report["solid"] = solid;
  if (!settings.report.empty()) {
    report["operands"] = Json::array({operand_report(operand, defects)});
    write_report(settings.report, std::move(report));
  }
  if (!settings.quiet && settings.report != "-") print_verdict(operand, solid, defects);
  return solid ? ExitCode::ok : ExitCode::negative;
}
