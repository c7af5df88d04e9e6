#include <fmt/format.h>

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "common/stopwatch.h"
#include "files.h"
#include "report.h"
#include "reproduction.h"
#include "result_file.h"
#include "rounded_output.h"
#include "strata/combine.h"
#include "verbs.h"
#include "watched_options.h"

namespace {

/// Puts attributes into the operands, unless the engine carries none. Returns the material for cut faces.
std::optional<strata::Material> put_attributes(std::span<const LoadedMesh> operands, const Settings& settings,
                                               std::vector<strata::Operand>& views) {
  std::vector<const strata::Attributes*> lists;
  for (const LoadedMesh& operand : operands) lists.push_back(&operand.attributes);
  std::optional<strata::Material> material = settings.attributes.material_among(lists);
  if (!carries_attributes(settings.engine, lists, material, settings)) return std::nullopt;
  for (std::size_t n = 0; n < views.size(); ++n)
    if (!operands[n].attributes.empty()) views[n].attributes = &operands[n].attributes;
  return material;
}

strata::BooleanResult evaluate(strata::Operation operation, std::span<const LoadedMesh> operands, strata::Format format,
                               const Settings& settings, const Watch& watch) {
  ProgressBar bar(settings.progress, settings.quiet);
  strata::Options options = watched_options(settings, bar, watch);
  options.rounding = settings.makes_solids() ? grid_of(format, settings) : std::nullopt;
  options.exact_vertices = format == strata::Format::xoff || settings.touching != "shared";
  options.measure = !settings.report.empty() && !options.exact_vertices;
  std::vector<strata::Operand> views;
  for (const LoadedMesh& operand : operands) views.push_back({operand.mesh.mesh, operand.mesh.exact});
  const std::optional<strata::Material> cut_material = put_attributes(operands, settings, views);
  if (cut_material) options.cut_material = &*cut_material;
  if (!options.rounding || options.exact_vertices)
    return strata::combine(operation, std::span<const strata::Operand>(views), options);
  try {
    return strata::combine(operation, std::span<const strata::Operand>(views), options);
  } catch (const std::invalid_argument& error) {
    throw strata::IoError(settings.output, {}, error.what());  // a coordinate is beyond the format
  }
}

/// What was asked, as a case.
verify::NewCase asked(strata::Operation operation, std::span<const LoadedMesh> operands, const Settings& settings) {
  verify::NewCase c;
  c.expression = joined_expression(operation, operands.size());
  c.input = settings.input;
  for (std::size_t n = 0; n < operands.size(); ++n) c.operands.emplace_back(fmt::format("s{}", n), &operands[n].mesh);
  return c;
}

/// A union of one operand shows that it is a solid. The other operations of one are mistakes of whoever types them.
void check_count(strata::Operation operation, std::span<const LoadedMesh> operands, const Settings& settings) {
  if (operands.size() == 1 && operation != strata::Operation::union_)
    throw UsageError(fmt::format("it needs two operands or more, and {} is one", settings.operands.front()));
}

// An operand was refused: the report says which defects it has.
void report_refusal(const char* name, std::span<const LoadedMesh> operands, const strata::InputError& error,
                    const Settings& settings) {
  Json report = {{"operation", name}, {"operands", operand_reports(operands, settings)}, {"result", nullptr}};
  report["operands"].at(error.operand())["defects"] = to_json(error.defects());
  write_report(settings.report, std::move(report));
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

ExitCode run_boolean(strata::Operation operation, const char* name, const Settings& given) {
  Watch watch(given.timeout);
  Stopwatch stopwatch;
  Json report = {{"operation", name}, {"operands", nullptr}, {"result", nullptr}, {"seconds", Json::object()}};
  const strata::Format format = output_format(given);
  const std::vector<LoadedMesh> operands = read_operands(given);
  check_count(operation, operands, given);
  const Settings settings = with_unit_of(operands, given);
  report["seconds"]["read"] = stopwatch.lap();

  watch.on_stop(OnStop::ask);
  const Asked question = [&] { return asked(operation, operands, settings); };
  strata::BooleanResult result;
  try {
    result = with_reproduction(question, name, settings,
                               [&] { return evaluate(operation, operands, format, settings, watch); });
  } catch (const strata::InputError& error) {
    if (!settings.report.empty()) report_refusal(name, operands, error, settings);
    throw strata::InputError(error.defects(), operands[error.operand()].argument);
  } catch (const strata::Cancelled&) {
    watch.on_stop(OnStop::leave);  // says why
    throw;
  }
  report["seconds"]["evaluate"] = stopwatch.lap();
  print_notes(result.notes, settings);
  report["peak_bytes"] = peak_bytes();

  watch.on_stop(OnStop::leave);
  add_profile(report, result.profile);
  if (!settings.report.empty()) report["operands"] = operand_reports(operands, result.notes, settings);
  return write_result(std::move(result), format, std::move(report), settings, watch, name, question);
}
