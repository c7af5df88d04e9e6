#include "strata/resolve.h"

#include <fmt/format.h>

#include <array>
#include <string>
#include <utility>

#include "common/stopwatch.h"
#include "files.h"
#include "report.h"
#include "reproduction.h"
#include "result_file.h"
#include "strata/carry_attributes.h"
#include "verbs.h"
#include "watched_options.h"

namespace {

/// What was asked, as a case: cases say so for the rule of winding numbers only.
verify::NewCase asked(const LoadedMesh& mesh, const Settings& settings) {
  verify::NewCase c;
  c.expression = "s0";
  c.input = settings.input;
  c.operands.emplace_back("s0", &mesh.mesh);
  return c;
}

strata::Solid evaluate(const LoadedMesh& mesh, const Settings& settings, const Watch& watch) {
  ProgressBar bar(settings.progress, settings.quiet);
  const strata::Solid solid = strata::resolve(mesh.mesh, settings.inside, watched_options(settings, bar, watch));
  if (mesh.attributes.empty()) return solid;
  const std::array given{strata::AttributedMesh{mesh.mesh, &mesh.attributes}};
  return solid.with_attributes(strata::carry_attributes(given, solid.exact_mesh(), solid.sources()));
}

}  // namespace

ExitCode run_resolve(const Settings& given) {
  Watch watch(given.timeout);
  Stopwatch stopwatch;
  Json report = {{"operation", "resolve"},
                 {"inside", name(given.inside)},
                 {"operands", nullptr},
                 {"result", nullptr},
                 {"seconds", Json::object()}};
  const strata::Format format = output_format(given);
  const std::vector<LoadedMesh> operands = read_operands(given);
  const Settings settings = with_unit_of(operands, given);
  report["seconds"]["read"] = stopwatch.lap();

  watch.on_stop(OnStop::ask);
  const Asked question = [&] { return asked(operands.front(), settings); };
  strata::Solid solid;
  try {
    solid =
        with_reproduction(question, "resolve", settings, [&] { return evaluate(operands.front(), settings, watch); });
  } catch (const strata::InputError& error) {
    report["operands"] = Json::array({operand_report(operands.front(), error.defects(), settings)});
    if (!settings.report.empty()) write_report(settings.report, std::move(report));
    throw;
  } catch (const strata::Cancelled&) {
    watch.on_stop(OnStop::leave);  // says why
    throw;
  }
  report["seconds"]["evaluate"] = stopwatch.lap();
  print_notes(solid.notes(), settings);
  report["peak_bytes"] = peak_bytes();

  watch.on_stop(OnStop::leave);
  if (!settings.report.empty())
    report["operands"] = Json::array({operand_report(operands.front(), solid.notes(), settings)});
  return write_result(solid.exact_mesh(), solid.attributes(), format, std::move(report), settings, watch, "resolve",
                      question);
}
