#include <fmt/format.h>

#include <array>
#include <stdexcept>
#include <string>
#include <utility>

#include "common/byte_source.h"
#include "common/point_source.h"
#include "common/stopwatch.h"
#include "common/tell.h"
#include "common/watch.h"
#include "files.h"
#include "report.h"
#include "result_file.h"
#include "strata/convex.h"
#include "verbs.h"

namespace {

/// The vertices of a mesh behind others.
void append(strata::ExactMesh& points, const strata::ExactMesh& mesh) {
  const auto before = static_cast<std::uint32_t>(points.mesh.vertices.size());
  points.mesh.vertices.insert(points.mesh.vertices.end(), mesh.mesh.vertices.begin(), mesh.mesh.vertices.end());
  for (const strata::ExactVertex& e : mesh.exact) points.exact.push_back({before + e.vertex, e.position});
}

void append_points(strata::ExactMesh& points, const std::string& path, const Watch& watch) {
  ByteSource bytes(path, &watch.token());
  const auto source = make_point_source(path, bytes);
  std::vector<double> coordinates;
  for (LineBlock block; source->next(block); coordinates.clear()) {
    source->parse(block, coordinates);
    for (std::size_t i = 0; i + 3 <= coordinates.size(); i += 3)
      points.mesh.vertices.push_back({coordinates[i], coordinates[i + 1], coordinates[i + 2]});
  }
}

ExitCode refuse(const std::string& why, Json report, const Settings& settings) {
  tell("strata: {}; no result was written\n", why);
  if (!settings.report.empty()) write_report(settings.report, std::move(report));
  return ExitCode::invalid_input;
}

std::string flatness(int dimension) {
  constexpr std::array names{"there are no points", "all points are one point", "all points are on one line",
                             "all points are in one plane"};
  return fmt::format("the hull has dimension {}, not 3: {}", dimension,
                     names.at(static_cast<std::size_t>(dimension + 1)));
}

/// What crosses in an exact hull is an error of the program: the case is the hull.
verify::NewCase asked(const strata::ExactMesh& result) {
  verify::NewCase c;
  c.expression = "s0";
  c.operands.emplace_back("s0", &result);
  return c;
}

}  // namespace

ExitCode run_hull(const Settings& settings) {
  Watch watch(settings.timeout);
  Stopwatch stopwatch;
  if (settings.operands.empty() && settings.points.empty()) throw UsageError("a hull needs meshes or --points");
  Json report = {{"operation", "hull"}, {"operands", Json::array()}, {"result", nullptr}, {"seconds", Json::object()}};
  const strata::Format format = output_format(settings);
  const std::vector<LoadedMesh> operands = read_operands(settings);
  strata::ExactMesh points;
  for (const LoadedMesh& operand : operands) append(points, operand.mesh);
  if (!settings.points.empty()) append_points(points, settings.points, watch);
  if (!settings.report.empty())
    for (const LoadedMesh& operand : operands) report["operands"].push_back(operand_report(operand, {}, settings));
  report["points"] = points.mesh.vertices.size();
  report["seconds"]["read"] = stopwatch.lap();

  strata::convex::Polytope hull;
  try {
    hull = strata::convex::convex_hull(points, settings.threads);
  } catch (const std::invalid_argument& error) {
    return refuse(error.what(), std::move(report), settings);
  }
  report["dimension"] = hull.dimension;
  if (hull.dimension < 3) return refuse(flatness(hull.dimension), std::move(report), settings);
  const strata::ExactMesh result = mesh_of(hull);
  report["seconds"]["evaluate"] = stopwatch.lap();
  report["peak_bytes"] = peak_bytes();
  tell_what_is_not_carried(operands, settings);
  return write_result(result, {}, format, std::move(report), settings, watch, "hull", [&] { return asked(result); });
}
