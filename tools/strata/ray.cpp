#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <vector>

#include "common/byte_source.h"
#include "common/csv.h"
#include "common/progress.h"
#include "common/stopwatch.h"
#include "common/watch.h"
#include "hit_table.h"
#include "report.h"
#include "row_file.h"
#include "scene_input.h"
#include "strata/errors.h"
#include "stream_blocks.h"
#include "threads.h"
#include "verbs.h"

namespace {

/// Rays on their way through the stages.
struct RayBlock {
  LineBlock lines;
  std::uint64_t first_ray = 0;
  std::vector<double> numbers;
  std::string rows;
  RayCounts counts;
};

/// Calls `visit(line)` for every row of a table: lines that are not blank.
template <class Visit>
void for_each_row(const LineBlock& block, const Visit& visit) {
  for_each_line(block, [&](const char* first, const char* last, std::uint64_t line) {
    while (first != last && (*first == ' ' || *first == '\t')) ++first;
    if (first != last) visit(line);
  });
}

std::uint64_t count_rows(const LineBlock& block) {
  std::uint64_t rows = 0;
  for_each_row(block, [&](std::uint64_t) { ++rows; });
  return rows;
}

[[noreturn]] void refuse_direction(const std::string& name, const LineBlock& block, std::uint64_t row) {
  std::uint64_t at = 0;
  for_each_row(block, [&](std::uint64_t line) {
    if (at++ == row) throw strata::IoError(name, {line, {}}, "the direction of the ray is zero");
  });
  throw strata::IoError(name, {}, "the direction of a ray is zero");
}

void answer(const HitTable& table, const std::string& name, RayBlock& block) {
  block.rows.clear();
  block.counts = {};
  for (std::size_t i = 0; i < block.numbers.size(); i += 6) {
    const double* n = block.numbers.data() + i;
    const strata::Ray ray{{n[0], n[1], n[2]}, {n[3], n[4], n[5]}};
    if (ray.direction == strata::Vertex{}) refuse_direction(name, block.lines, i / 6);
    table.append_rows(block.first_ray + i / 6, ray, block.rows, block.counts);
  }
}

/// Answers all rays.
RayCounts stream_rays(const HitTable& table, const Settings& settings, const Watch& watch) {
  ProgressBar bar(settings.progress, settings.quiet);
  ByteSource bytes(settings.rays, &watch.token());
  CsvReader reader(bytes, {"x", "y", "z", "dx", "dy", "dz"});
  RowFile file(
      settings.output, [&](std::uint64_t) { return table.header(); }, 0);
  RayCounts counts;
  std::uint64_t rays = 0;
  stream_blocks<RayBlock>(
      [&](RayBlock& block) {
        bar.show(bytes.fraction());
        if (!reader.next(block.lines)) return false;
        block.first_ray = rays;
        rays += count_rows(block.lines);
        return true;
      },
      [&](RayBlock& block) {
        block.numbers.clear();
        reader.parse(block.lines, block.numbers);
        answer(table, bytes.name(), block);
      },
      [&](const RayBlock& block) {
        counts.rays += block.counts.rays;
        counts.meeting += block.counts.meeting;
        counts.hits += block.counts.hits;
        file.write(block.rows);
      });
  file.finish(counts.hits);
  return counts;
}

/// Everything from the solids to the finished file.
void cast_rays(std::span<const LoadedMesh> operands, const Settings& settings, const Watch& watch, Json& report) {
  Stopwatch stopwatch;
  const SceneInput input(operands, settings);
  report["seconds"]["prepare"] = stopwatch.lap();
  const strata::RayCaster caster(input.scene());
  report["seconds"]["build"] = stopwatch.lap();
  const HitTable table(caster, input, {settings.all, settings.exact});
  const RayCounts counts = stream_rays(table, settings, watch);
  report["rays"] = {{"count", counts.rays}, {"meeting", counts.meeting}, {"hits", counts.hits}};
  report["seconds"]["cast"] = stopwatch.lap();
}

}  // namespace

ExitCode run_ray(const Settings& settings) {
  if (settings.first && settings.all) throw UsageError("--first and --all exclude each other");
  Watch watch(settings.timeout);
  Stopwatch stopwatch;
  Json report = {{"operation", "ray"}, {"operands", nullptr}, {"rays", nullptr}};
  const std::vector<LoadedMesh> operands = read_operands(settings);
  report["seconds"]["read"] = stopwatch.lap();

  watch.on_stop(OnStop::ask);
  try {
    on_threads(settings, [&] { cast_rays(operands, settings, watch, report); });
  } catch (const strata::Cancelled&) {
    watch.on_stop(OnStop::leave);  // says why
    throw;
  }
  report["peak_bytes"] = peak_bytes();

  watch.on_stop(OnStop::finish);
  if (!settings.quiet && settings.output != "-" && settings.report != "-")
    for (const auto& [key, value] : report["rays"].items())
      fmt::print("{:14} {}\n", key == "count" ? "rays" : key, value.dump());
  if (settings.report.empty()) return ExitCode::ok;
  report["operands"] = operand_reports(operands, settings);
  write_report(settings.report, std::move(report));
  return ExitCode::ok;
}
