#include <fmt/format.h>

#include <functional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "common/progress.h"
#include "common/stopwatch.h"
#include "common/watch.h"
#include "files.h"
#include "report.h"
#include "reproduction.h"
#include "result_file.h"
#include "strata/convex.h"
#include "verbs.h"

namespace {

strata::Options options_of(const Settings& settings, const Watch& watch, ProgressBar& bar) {
  strata::Options options;
  options.threads = settings.threads;
  options.progress = [&bar](double fraction) { bar.show(fraction); };
  options.cancel = &watch.token();
  return options;
}

using Make = std::function<strata::Solid(std::span<const strata::Solid>, const strata::Options&, Json&)>;

/// What verbs that make one solid of others have in common; `make` may add to the report.
ExitCode run_making(const char* verb, const Settings& settings, const Make& make) {
  Watch watch(settings.timeout);
  Stopwatch stopwatch;
  Json report = {{"operation", verb}, {"operands", nullptr}, {"result", nullptr}, {"seconds", Json::object()}};
  const strata::Format format = output_format(settings);
  const std::vector<LoadedMesh> operands = read_operands(settings);
  std::vector<strata::Solid> solids;
  for (std::size_t k = 0; k < operands.size(); ++k) solids.push_back(make_solid(operands, k, settings));
  report["seconds"]["read"] = stopwatch.lap();

  watch.on_stop(OnStop::ask);
  const Asked question = [&]() -> verify::NewCase {
    throw std::runtime_error(fmt::format("cases have no {}: the command is its own reproduction", verb));
  };
  strata::Solid solid;
  try {
    ProgressBar bar(settings.progress, settings.quiet);
    const strata::Options options = options_of(settings, watch, bar);
    solid = with_reproduction(question, verb, settings, [&] { return make(solids, options, report); });
  } catch (const strata::Cancelled&) {
    watch.on_stop(OnStop::leave);  // says why
    throw;
  }
  report["seconds"]["evaluate"] = stopwatch.lap();
  report["peak_bytes"] = peak_bytes();
  watch.on_stop(OnStop::leave);
  tell_what_is_not_carried(operands, settings);
  if (!settings.report.empty()) report["operands"] = operand_reports(operands, settings);
  return write_result(solid.exact_mesh(), {}, format, std::move(report), settings, watch, verb, question);
}

}  // namespace

ExitCode run_minkowski(const Settings& settings, bool subtract) {
  return run_making(subtract ? "erosion" : "minkowski", settings,
                    [&](std::span<const strata::Solid> solids, const strata::Options& options, Json&) {
                      if (!subtract) return strata::convex::minkowski_sum(solids[0], solids[1], options);
                      if (solids[1].is_empty()) throw UsageError("an erosion by nothing is all of space");
                      return strata::convex::erosion(solids[0], solids[1], options);
                    });
}

ExitCode run_offset(const Settings& settings) {
  return run_making(
      "offset", settings, [&](std::span<const strata::Solid> solids, const strata::Options& options, Json& report) {
        try {
          const auto found = strata::convex::offset(solids[0], settings.distance, settings.facets, options);
          report["distance"] = settings.distance;
          report["facets"] = settings.facets;
          report["excess"] = found.excess;
          return found.solid;
        } catch (const std::invalid_argument& error) {
          throw UsageError(error.what());
        }
      });
}
