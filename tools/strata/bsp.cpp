#include "strata/bsp.h"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "cell_file.h"
#include "extensions/bsp/partition_data.h"
#include "report.h"
#include "scene_input.h"
#include "stopwatch.h"
#include "verbs.h"
#include "watch.h"

namespace {

using strata::bsp::Partition;

Json tree_report(const Partition<3>& region) {
  const strata::bsp::TreeSize size = strata::bsp::size_of_tree(region);
  return {{"nodes", size.nodes},
          {"leaves", size.leaves},
          {"inside", size.inside},
          {"depth", size.depth},
          {"mean_depth", size.mean_depth},
          {"planes", size.hyperplanes},
          {"splits", size.splits},
          {"facets", strata::bsp::facets_of(region).size()},
          {"bytes", size.bytes}};
}

void print_facts(const Json& facts, const Settings& settings) {
  std::FILE* const stream = settings.output == "-" ? stderr : stdout;
  for (const auto& [key, value] : facts.items()) fmt::print(stream, "{:12} {}\n", key, value.dump());
}

}  // namespace

ExitCode run_bsp(const Settings& settings) {
  Watch watch(settings.timeout);
  Stopwatch stopwatch;
  if (!settings.output.empty() && settings.output != "-" && !settings.output.ends_with(".glb"))
    throw UsageError(fmt::format("cells are written as glTF; give {} the extension .glb", settings.output));
  Json report = {{"operation", "bsp"}, {"operands", nullptr}, {"result", nullptr}, {"seconds", Json::object()}};
  const std::vector<LoadedMesh> operands = read_operands(settings);
  report["seconds"]["read"] = stopwatch.lap();

  watch.on_stop(OnStop::ask);
  Partition<3> region;
  try {
    const strata::Solid solid = make_solid(operands, 0, settings.input);
    report["seconds"]["prepare"] = stopwatch.lap();
    region = strata::bsp::partition_of(solid.exact_mesh(), strata::Monitor(&watch.token()));
    report["seconds"]["build"] = stopwatch.lap();
  } catch (const strata::Cancelled&) {
    watch.on_stop(OnStop::leave);  // says why
    throw;
  }
  report["result"] = tree_report(region);
  report["peak_bytes"] = peak_bytes();

  watch.on_stop(OnStop::finish);
  stopwatch.lap();
  if (!settings.output.empty()) write_cells(settings.output, region);
  report["seconds"]["write"] = stopwatch.lap();
  if (!settings.quiet && settings.report != "-") print_facts(report["result"], settings);
  if (settings.report.empty()) return ExitCode::ok;
  report["operands"] = operand_reports(operands, settings.input);
  write_report(settings.report, std::move(report));
  return ExitCode::ok;
}
