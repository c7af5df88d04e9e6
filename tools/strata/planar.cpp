#include "strata/planar.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "common/stopwatch.h"
#include "common/text_file.h"
#include "common/watch.h"
#include "planar_input.h"
#include "planar_partition.h"
#include "planar_verbs.h"
#include "rounded_region.h"

namespace {

using namespace strata::planar;

constexpr std::size_t most_listed = 100;  ///< intersections in a report

Json to_json(const SelfMeeting& m) {
  Json j = {{"kind", name(m.kind)}, {"where", place(m.where)}};
  if (m.kind == SelfMeetingKind::edges_overlapping) j["to"] = place(m.to);
  j["vertices"] = m.vertices;
  j["edges"] = m.edges;
  return j;
}

Json to_json(const std::vector<SelfMeeting>& intersections) {
  Json list = Json::array();
  for (std::size_t i = 0; i < std::min(intersections.size(), most_listed); ++i)
    list.push_back(to_json(intersections[i]));
  return list;
}

}  // namespace

ExitCode run_planar(Operation operation, const char* name, const PlanarSettings& planar, const Settings& settings) {
  Watch watch(settings.timeout);
  Stopwatch stopwatch;
  Json report = {{"operation", name}, {"operands", nullptr}, {"result", nullptr}, {"seconds", Json::object()}};
  const PlanarFormat format = output_format_of(settings);
  if (settings.exact && format != PlanarFormat::wkt)
    throw UsageError("--exact is for WKT: other formats have no quotients");
  const std::vector<PlanarFile> files = read_files(settings);
  report["operands"] = operand_facts(settings, files);
  report["seconds"]["read"] = stopwatch.lap();

  std::vector<Operand> operands;
  for (const PlanarFile& file : files) operands.push_back({file.loops, fill_rule(planar)});
  OutputRegion written;
  const Region region = cancellable(watch, settings, [&](const strata::Monitor& monitor) {
    Region r = planar.by_partitions ? combine_by_partitions(operands, operation, monitor)
                                    : combine(operands, operation, monitor);
    report["seconds"]["evaluate"] = stopwatch.lap();
    written = output_region(r, settings, monitor);
    return r;
  });
  report["seconds"]["round"] = stopwatch.lap();
  if (!settings.report.empty() || !settings.quiet) report["result"] = region_facts(region);
  if (report["result"].is_object()) report["result"]["rounding_conflicts"] = written.conflicts.size();
  report["rounding_conflicts"] = to_json(written.conflicts);
  report["rounding"] = {{"rounds", written.rounded.rounds},
                        {"largest_movement", written.rounded.largest_movement},
                        {"polygons", written.rounded.region.polygons()},
                        {"vertices", written.rounded.region.loops.vertices.size()}};
  report["seconds"]["measure"] = stopwatch.lap();

  watch.on_stop(OnStop::finish);
  write_text(settings.output,
             to_text(written.rounded.region, format, settings.exact ? Coordinates::exact : Coordinates::nearest));
  report["seconds"]["write"] = stopwatch.lap();
  report["peak_bytes"] = peak_bytes();
  if (report["result"].is_object()) print_facts(report["result"], settings);
  if (!settings.report.empty()) write_report(settings.report, std::move(report));
  return report_conflicts(written, settings);
}

ExitCode run_planar_check(const Settings& settings) {
  Watch watch(settings.timeout);
  const PlanarFile file = read_files(settings).front();
  const std::vector<SelfMeeting> intersections = self_intersections(file.loops);
  const bool clean = intersections.empty() && is_clean(file.loops);
  if (!settings.quiet && settings.report != "-") {
    fmt::print("{}: {}\n", settings.operands.front(), clean ? "clean" : "not clean");
    for (std::size_t i = 0; i < std::min(intersections.size(), most_listed); ++i)
      fmt::print("  {} at {}\n", name(intersections[i].kind), place(intersections[i].where).dump());
    if (intersections.size() > most_listed) fmt::print("  and {} more\n", intersections.size() - most_listed);
  }
  if (!settings.report.empty())
    write_report(settings.report, {{"operation", "planar check"},
                                   {"operands", operand_facts(settings, {file})},
                                   {"clean", clean},
                                   {"meetings", intersections.size()},
                                   {"listed", to_json(intersections)}});
  return clean ? ExitCode::ok : ExitCode::negative;
}

ExitCode run_planar_info(const PlanarSettings& planar, const Settings& settings) {
  Watch watch(settings.timeout);
  const PlanarFile file = read_files(settings).front();
  const Region region = cancellable(watch, settings, [&](const strata::Monitor& monitor) {
    const Operand operand(file.loops, fill_rule(planar));
    return combine(std::span(&operand, 1), Operation::union_, monitor);
  });
  Json result = region_facts(region);
  print_facts(result, settings);
  if (!settings.report.empty())
    write_report(
        settings.report,
        {{"operation", "planar info"}, {"operands", operand_facts(settings, {file})}, {"result", std::move(result)}});
  return ExitCode::ok;
}
