#include "result_file.h"

#include <fmt/format.h>

#include <optional>
#include <string_view>
#include <utility>

#include "common/stopwatch.h"
#include "common/tell.h"
#include "rounded_output.h"
#include "strata/carry_attributes.h"
#include "strata/check.h"
#include "strata/errors.h"
#include "strata/measure.h"
#include "strata/solid.h"

namespace {

// Checks what the file will hold: XOFF does not round, binary STL and glTF round once more, to floats.
bool certify(const strata::ExactMesh& mesh, strata::Format format, const Settings& settings, const Watch& watch) {
  strata::Options options;
  options.threads = settings.threads;
  options.cancel = &watch.token();
  if (format == strata::Format::xoff) return strata::is_embedded(mesh, options);
  if (!strata::holds_floats(format)) return strata::is_embedded(mesh.mesh, options);
  const std::string bytes = strata::to_string(mesh.mesh, format);
  return strata::is_embedded(strata::read_mesh(std::string_view(bytes), format, settings.output).mesh, options);
}

strata::ExactMesh separated(const strata::ExactMesh& mesh) {
  return strata::Solid::trusted(mesh).separated().exact_mesh();
}

/// Gives sheets of what is written copies of their own. Edges that this divides have new vertices, which are rounded in
/// turn. Returns false if that is no solid any more.
bool separate(RoundedOutput& rounded, const strata::ExactMesh& exact, strata::Format format, const Settings& settings,
              const Watch& watch) {
  const strata::Solid separated = strata::Solid::trusted(rounded.mesh ? *rounded.mesh : exact)
                                      .with_attributes(std::move(rounded.attributes))
                                      .separated();
  rounded.mesh = separated.exact_mesh();
  rounded.attributes = separated.attributes();
  const auto grid = grid_of(format, settings);
  if (!grid || !settings.makes_solids()) return true;
  strata::RoundedMesh again = rounded_for_output(*rounded.mesh, *grid, settings, &watch.token());
  if (!rounded.attributes.empty())
    rounded.attributes = strata::carry_attributes({*rounded.mesh, &rounded.attributes}, again, *grid);
  rounded.mesh = strata::ExactMesh{std::move(again.mesh), {}};
  return again.report.rounds == 0;
}

/// Exact results of solids are solids.
std::string crossing_for_no_rounding(const char* verb, const Asked& asked, const Settings& settings) {
  constexpr const char* error = "faces of the exact result cross";
  return fmt::format("{}: an operand crosses itself (`strata check` tells), or this is an error of the program. {}",
                     error, keep_reproduction(asked, verb, error, settings));
}

/// Writes what was rounded. For the report: what it was rounded from, or facts about that.
ExitCode write(const strata::ExactMesh& exact, const std::optional<strata::MeasuredBoundary>& known,
               RoundedOutput rounded, strata::Format format, Json report, const Settings& settings, Watch& watch,
               Stopwatch& stopwatch, const char* verb, const Asked& asked) {
  if (settings.touching == "separate" && !separate(rounded, exact, format, settings, watch)) {
    tell("strata: sheets that touch cannot be separated in the numbers of the format; nothing was written\n");
    return ExitCode::not_certified;
  }
  const strata::ExactMesh& written = rounded.mesh ? *rounded.mesh : exact;
  report["seconds"]["round"] = stopwatch.lap();
  if (settings.touching == "refuse") {
    const strata::Topology topology = strata::topology(written);
    if (topology.non_manifold_edges + topology.non_manifold_vertices > 0) {
      tell("strata: the result touches itself in {} edges and {} vertices; nothing was written\n",
           topology.non_manifold_edges, topology.non_manifold_vertices);
      if (!settings.report.empty()) report["result"] = result_report(known ? *known : measured(exact, settings), {});
      if (!settings.report.empty()) write_report(settings.report, std::move(report));
      return ExitCode::not_certified;
    }
  }
  std::optional<bool> rounded_valid;
  if (settings.certify) {
    rounded_valid = certify(written, format, settings, watch);
    report["seconds"]["certify"] = stopwatch.lap();
  }
  watch.on_stop(OnStop::leave);
  if (!settings.report.empty()) {
    report["result"] = result_report(
        known ? *known : measured(settings.touching == "separate" ? separated(exact) : exact, settings), rounded_valid);
    report["result"]["rounding"] = std::move(rounded.report);
  }
  watch.on_stop(OnStop::finish);
  stopwatch.lap();
  write_output(settings, format, written, rounded.attributes);
  report["seconds"]["write"] = stopwatch.lap();
  if (!settings.report.empty()) write_report(settings.report, std::move(report));
  if (rounded.strays) print_strays(*rounded.strays);
  if (rounded_valid != false) return rounded.strays ? ExitCode::not_certified : ExitCode::ok;
  const std::string why = format != strata::Format::xoff ? "faces of the result cross after rounding"
                                                         : crossing_for_no_rounding(verb, asked, settings);
  tell("strata: not certified: {}; it was written all the same\n", why);
  return ExitCode::not_certified;
}

/// Says why, where it is stopped.
RoundedOutput rounded_until_stopped(const strata::ExactMesh& exact, const strata::Attributes& attributes,
                                    strata::Format format, const Settings& settings, Watch& watch) {
  try {
    return rounded_output(exact, attributes, format, settings, &watch.token());
  } catch (const strata::Cancelled&) {
    watch.on_stop(OnStop::leave);
    throw;
  }
}

}  // namespace

ExitCode write_result(const strata::ExactMesh& exact, const strata::Attributes& attributes, strata::Format format,
                      Json report, const Settings& settings, Watch& watch, const char* verb, const Asked& asked) {
  Stopwatch stopwatch;
  RoundedOutput rounded = rounded_until_stopped(exact, attributes, format, settings, watch);
  return write(exact, {}, std::move(rounded), format, std::move(report), settings, watch, stopwatch, verb, asked);
}

ExitCode write_result(strata::BooleanResult result, strata::Format format, Json report, const Settings& settings,
                      Watch& watch, const char* verb, const Asked& asked) {
  Stopwatch stopwatch;
  const strata::ExactMesh mesh{std::move(result.mesh), std::move(result.exact)};
  RoundedOutput output = result.rounding
                             ? rounded_output(*result.rounding, mesh.mesh, std::move(result.attributes), settings)
                             : rounded_until_stopped(mesh, result.attributes, format, settings, watch);
  return write(mesh, result.measured, std::move(output), format, std::move(report), settings, watch, stopwatch, verb,
               asked);
}
