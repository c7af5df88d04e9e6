#include <fmt/format.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/byte_source.h"
#include "common/point_source.h"
#include "common/progress.h"
#include "common/stopwatch.h"
#include "common/watch.h"
#include "location_table.h"
#include "report.h"
#include "row_file.h"
#if STRATA_HAS_BSP
#include "strata/bsp.h"
#endif
#include "strata/io.h"
#include "strata/query.h"
#include "stream_blocks.h"
#include "threads.h"
#include "verbs.h"

namespace {

using Form = LocationTable::Form;
using strata::Vertex;

/// Points on their way through the stages.
struct PointBlock {
  LineBlock lines;
  std::vector<double> coordinates;
  std::string rows;
  WhereCounts counts;
};

Form form_of(const Settings& settings) {
  const bool ply = strata::format_of(settings.output) == strata::Format::ply;
  if (ply && settings.nearest) throw UsageError("--nearest has no place in PLY; write CSV");
  if (ply && settings.all) throw UsageError("--all lists have no place in PLY; write CSV");
  return ply ? Form::ply : settings.all ? Form::csv_all : Form::csv;
}

/// Answers all points; returns how many are where.
WhereCounts stream_points(const LocationTable& table, Form form, const Settings& settings, const Watch& watch) {
  ProgressBar bar(settings.progress, settings.quiet);
  ByteSource bytes(settings.points, &watch.token());
  const auto points = make_point_source(settings.points, bytes);
  const auto count = form == Form::ply ? points->count() : std::optional<std::uint64_t>(0);
  RowFile file(
      settings.output, [&](std::uint64_t rows) { return table.header(rows); }, count);
  WhereCounts counts{};
  stream_blocks<PointBlock>(
      [&](PointBlock& block) {
        bar.show(bytes.fraction());
        return points->next(block.lines);
      },
      [&](PointBlock& block) {
        block.coordinates.clear();
        block.rows.clear();
        block.counts = {};
        points->parse(block.lines, block.coordinates);
        table.append_rows(block.coordinates, block.rows, block.counts);
      },
      [&](const PointBlock& block) {
        for (std::size_t i = 0; i < counts.size(); ++i) counts[i] += block.counts[i];
        file.write(block.rows);
      });
  file.finish(counts[0] + counts[1] + counts[2]);
  return counts;
}

Json counts_report(const WhereCounts& counts) {
  const auto [out, on, in] = counts;
  return {{"count", out + on + in}, {"in", in}, {"on", on}, {"out", out}};
}

LocationTable::Locate locator_of(const strata::Scene& scene, [[maybe_unused]] const strata::Engine* engine,
                                 const Watch& watch) {
  const strata::Monitor monitor(&watch.token());
#if STRATA_HAS_BSP
  if (engine == &strata::bsp_engine)
    return [locator = strata::bsp::PartitionLocator(scene, monitor)](const Vertex& q) { return locator.locate(q); };
#endif
  return [locator = strata::Locator(scene, monitor)](const Vertex& q) { return locator.locate(q); };
}

/// Of all solids the nearest boundary, by trees of their own.
LocationTable::FindNearest nearest_of([[maybe_unused]] const strata::Scene& scene, const Settings& settings,
                                      [[maybe_unused]] const Watch& watch) {
  if (!settings.nearest) return {};
#if STRATA_HAS_BSP
  using Region = strata::bsp::Partition<3>;
  std::vector<Region> regions;
  for (std::uint32_t s = 0; s < scene.solid_count(); ++s)
    regions.push_back(strata::bsp::partition_of(scene.solid(s), strata::Monitor(&watch.token())));
  return [regions = std::move(regions)](const Vertex& q) {
    std::optional<strata::bsp::NearestPoint<3>> best;
    for (const Region& region : regions) {
      auto found = nearest_boundary_point(
          region, {strata::to_rational(q[0]), strata::to_rational(q[1]), strata::to_rational(q[2])});
      if (found && (!best || found->squared_distance < best->squared_distance)) best = std::move(found);
    }
    std::optional<LocationTable::Nearest> answer;
    if (best) {
      answer.emplace();
      for (std::size_t i = 0; i < 3; ++i) answer->point[i] = strata::to_nearest_double(best->point[i]);
      answer->distance = best->distance;
    }
    return answer;
  };
#else
  throw UsageError("--nearest needs the extension bsp, which this build of strata does not have");
#endif
}

/// Everything from the solids to the finished file.
void locate(std::span<const LoadedMesh> operands, Form form, const Settings& settings, const Watch& watch,
            Json& report) {
  Stopwatch stopwatch;
  const SceneInput input(operands, settings);
  report["seconds"]["prepare"] = stopwatch.lap();
  const LocationTable table(locator_of(input.scene(), settings.engine, watch), input, form,
                            nearest_of(input.scene(), settings, watch));
  report["seconds"]["build"] = stopwatch.lap();
  const WhereCounts counts = stream_points(table, form, settings, watch);
  report["points"] = counts_report(counts);
  report["seconds"]["locate"] = stopwatch.lap();
}

void print_counts(const Json& points) {
  for (const auto& [key, value] : points.items())
    fmt::print("{:14} {}\n", key == "count" ? "points" : key, value.dump());
}

}  // namespace

ExitCode run_locate(const Settings& settings) {
  Watch watch(settings.timeout);
  Stopwatch stopwatch;
  const Form form = form_of(settings);
  Json report = {{"operation", "locate"}, {"operands", nullptr}, {"points", nullptr}};
  const std::vector<LoadedMesh> operands = read_operands(settings);
  report["seconds"]["read"] = stopwatch.lap();

  watch.on_stop(OnStop::ask);
  try {
    on_threads(settings, [&] { locate(operands, form, settings, watch, report); });
  } catch (const strata::Cancelled&) {
    watch.on_stop(OnStop::leave);  // says why
    throw;
  }
  report["peak_bytes"] = peak_bytes();

  watch.on_stop(OnStop::finish);
  if (!settings.quiet && settings.output != "-" && settings.report != "-") print_counts(report["points"]);
  if (settings.report.empty()) return ExitCode::ok;
  report["operands"] = operand_reports(operands, settings);
  write_report(settings.report, std::move(report));
  return ExitCode::ok;
}
