#include "strata/bsp.h"

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <utility>

#include "cell_file.h"
#include "common/stopwatch.h"
#include "common/watch.h"
#include "files.h"
#include "report.h"
#include "rounded_output.h"
#include "verbs.h"

namespace {

using strata::bsp::BoundaryFacet;
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
          {"facets", strata::bsp::boundary_facets(region).size()},
          {"bytes", size.bytes}};
}

/// Polygons of a cell, seen counter-clockwise from outside.
CellPolygons polygons_of(const std::vector<BoundaryFacet<3>>& facets) {
  CellPolygons polygons;
  for (const BoundaryFacet<3>& f : facets) {
    std::vector<std::array<double, 3>> polygon;
    for (const auto& c : f.corners)
      polygon.push_back(
          {strata::to_nearest_double(c[0]), strata::to_nearest_double(c[1]), strata::to_nearest_double(c[2])});
    polygons.push_back(std::move(polygon));
  }
  return polygons;
}

/// The inside leaves, pulled apart.
void write_leaves(const std::string& path, const Partition<3>& region) {
  std::vector<CellPolygons> cells;
  strata::bsp::for_each_bounded_cell<3>(
      region, [&](const std::vector<BoundaryFacet<3>>& facets) { cells.push_back(polygons_of(facets)); });
  write_cells(path, cells, exploded);
}

/// A tree that Hipparchus or Apache Commons Math has dumped.
Partition<3> read_tree(const std::string& path) {
  Partition<3> region;
  try {
    region = strata::bsp::read_polyhedrons_set(read_file(path));
  } catch (const strata::IoError&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw strata::IoError(path, {}, error.what());
  }
  if (!region.is_bounded()) throw strata::IoError(path, {}, "the region has no end: it has no mesh and no picture");
  return region;
}

void print_facts(const Json& facts, const Settings& settings) {
  std::FILE* const stream = settings.output == "-" ? stderr : stdout;
  for (const auto& [key, value] : facts.items()) fmt::print(stream, "{:12} {}\n", key, value.dump());
}

}  // namespace

ExitCode run_bsp(const Settings& settings) {
  Watch watch(settings.timeout);
  Stopwatch stopwatch;
  const bool is_picture = settings.output.empty() || settings.output == "-" || settings.output.ends_with(".glb");
  if (!is_picture) (void)output_format(settings);  // of the boundary
  Json report = {{"operation", "bsp"}, {"operands", nullptr}, {"result", nullptr}, {"seconds", Json::object()}};
  const bool is_tree = settings.operands.front().ends_with(".bsp");
  const std::vector<LoadedMesh> operands = is_tree ? std::vector<LoadedMesh>() : read_operands(settings);
  report["seconds"]["read"] = stopwatch.lap();

  watch.on_stop(OnStop::ask);
  Partition<3> region;
  try {
    if (is_tree) {
      region = read_tree(settings.operands.front());
    } else {
      const strata::Solid solid = make_solid(operands, 0, settings);
      report["seconds"]["prepare"] = stopwatch.lap();
      region = strata::bsp::partition_of(solid.exact_mesh(), strata::Monitor(&watch.token()));
    }
    report["seconds"]["build"] = stopwatch.lap();
  } catch (const strata::Cancelled&) {
    watch.on_stop(OnStop::leave);  // says why
    throw;
  }
  report["result"] = tree_report(region);
  report["peak_bytes"] = peak_bytes();

  watch.on_stop(OnStop::finish);
  stopwatch.lap();
  if (!is_picture)
    write_solid(settings, output_format(settings), strata::bsp::exact_mesh_of(region));
  else if (!settings.output.empty())
    write_leaves(settings.output, region);
  report["seconds"]["write"] = stopwatch.lap();
  if (!settings.quiet && settings.report != "-") print_facts(report["result"], settings);
  if (settings.report.empty()) return ExitCode::ok;
  report["operands"] = operand_reports(operands, settings);
  write_report(settings.report, std::move(report));
  return ExitCode::ok;
}
