#include <fmt/format.h>

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "files.h"
#include "progress.h"
#include "report.h"
#include "stopwatch.h"
#include "strata/csg/check.h"
#include "strata/csg/combine.h"
#include "verbs.h"
#include "watch.h"

namespace {

strata::BooleanResult evaluate(strata::Operation operation, std::span<const LoadedMesh> operands,
                               const Settings& settings, const Watch& watch) {
  ProgressBar bar(settings.progress, settings.quiet);
  strata::Options options;
  options.input = settings.input;
  options.threads = settings.threads;
  options.exact_vertices = !settings.report.empty();
  options.progress = [&bar](double fraction) { bar.show(fraction); };
  options.cancel = &watch.token();
  std::vector<strata::MeshView> views;
  for (const LoadedMesh& operand : operands) views.emplace_back(operand.mesh.mesh);
  return strata::combine(operation, views, options);
}

// Checks what the file will hold: binary STL rounds once more, to floats.
bool certify(const strata::Mesh& mesh, strata::Format format, const Settings& settings, const Watch& watch) {
  strata::Options options;
  options.threads = settings.threads;
  options.cancel = &watch.token();
  if (format != strata::Format::stl) return strata::is_embedded(mesh, options);
  const std::string bytes = strata::to_string(mesh, format);
  return strata::is_embedded(strata::read_mesh(std::string_view(bytes), format, settings.output).mesh, options);
}

// An operand was refused: the report says which defects it has.
void report_refusal(const char* name, std::span<const LoadedMesh> operands, const strata::InputError& error,
                    const Settings& settings) {
  Json report = {{"operation", name}, {"operands", operand_reports(operands, settings.input)}, {"result", nullptr}};
  report["operands"].at(error.operand())["defects"] = to_json(error.defects());
  write_report(settings.report, std::move(report));
}

void print_notes(std::span<const strata::Defect> notes, const Settings& settings) {
  if (settings.quiet) return;
  for (const strata::Defect& note : notes) fmt::print(stderr, "strata: {}\n", strata::describe(note));
}

// What the report says about time and counts, in the order of the stages.
void add_profile(Json& report, const strata::Profile& profile) {
  Json stages = Json::object();
  for (const auto& [stage, seconds] : profile.seconds) stages[stage] = seconds;
  Json counts = Json::object();
  for (const auto& [what, count] : profile.counts) counts[what] = count;
  report["seconds"]["stages"] = std::move(stages);
  report["counts"] = std::move(counts);
}

}  // namespace

ExitCode run_boolean(strata::Operation operation, const char* name, const Settings& settings) {
  Watch watch(settings.timeout);
  Stopwatch stopwatch;
  Json report = {{"operation", name}, {"operands", nullptr}, {"result", nullptr}, {"seconds", Json::object()}};
  const strata::Format format = output_format(settings);
  const std::vector<LoadedMesh> operands = read_operands(settings);
  report["seconds"]["read"] = stopwatch.lap();

  watch.on_stop(OnStop::ask);
  strata::BooleanResult result;
  try {
    result = evaluate(operation, operands, settings, watch);
  } catch (const strata::InputError& error) {
    if (!settings.report.empty()) report_refusal(name, operands, error, settings);
    throw;
  } catch (const strata::Cancelled&) {
    watch.on_stop(OnStop::leave);  // says why
    throw;
  }
  report["seconds"]["evaluate"] = stopwatch.lap();
  std::optional<bool> rounded_valid;
  if (settings.certify) {
    rounded_valid = certify(result.mesh, format, settings, watch);
    report["seconds"]["certify"] = stopwatch.lap();
  }
  print_notes(result.notes, settings);
  report["peak_bytes"] = peak_bytes();

  watch.on_stop(OnStop::leave);
  const strata::ExactMesh exact{std::move(result.mesh), std::move(result.exact)};
  if (!settings.report.empty()) {
    report["operands"] = operand_reports(operands, settings.input);
    report["result"] = result_report(exact, rounded_valid);
  }

  watch.on_stop(OnStop::finish);
  stopwatch.lap();
  write_output(settings, format, exact.mesh);
  report["seconds"]["write"] = stopwatch.lap();
  add_profile(report, result.profile);
  if (!settings.report.empty()) write_report(settings.report, std::move(report));
  if (rounded_valid != false) return ExitCode::ok;
  fmt::print(stderr, "strata: not certified: faces of the result cross after rounding; it was written all the same\n");
  return ExitCode::not_certified;
}
