#include "strata/check.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/stopwatch.h"
#include "files.h"
#include "report.h"
#include "verbs.h"
#include "watched_options.h"

namespace {

std::vector<strata::Defect> diagnose(const strata::ExactMesh& mesh, const Settings& settings, const Watch& watch) {
  ProgressBar bar(settings.progress, settings.quiet);
  const std::size_t listed = settings.report.empty() ? settings.max_defects : ~std::size_t{0};
  return strata::check(mesh, watched_options(settings, bar, watch), listed);
}

/// Defects of one kind are next to each other.
void print_verdict(const LoadedMesh& operand, bool solid, std::span<const strata::Defect> defects, std::uint64_t most) {
  fmt::print("{}: {}\n", operand.path, solid ? "a solid" : "not a solid");
  std::uint64_t printed = 0;
  for (std::size_t i = 0; i < defects.size(); ++i) {
    printed = i > 0 && defects[i].kind == defects[i - 1].kind ? printed + 1 : 1;
    if (printed <= most) fmt::print("  {}: {}\n", strata::name(defects[i].severity), strata::describe(defects[i]));
    if (printed == most && defects[i].count > most)
      fmt::print("  ... and {} more of this kind\n", defects[i].count - most);
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
    report["operands"] = Json::array({operand_report(operand, defects, settings)});
    write_report(settings.report, std::move(report));
  }
  if (!settings.quiet && settings.report != "-") print_verdict(operand, solid, defects, settings.max_defects);
  return solid ? ExitCode::ok : ExitCode::negative;
}
