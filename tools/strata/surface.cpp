#include "strata/surface.h"

#include <fmt/format.h>

#include <array>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "common/output_file.h"
#include "common/stopwatch.h"
#include "files.h"
#include "mesh_folder.h"
#include "plane_option.h"
#include "report.h"
#include "strata/measure.h"
#include "surface_verbs.h"
#include "watched_options.h"

namespace {

using strata::Surface;

/// What a verb made: meshes of one kind for a folder, or one for a file.
struct Product {
  const char* stem = "";  ///< of file names; empty: one mesh, for a file
  std::vector<strata::ExactMesh> meshes;
  std::vector<Json> facts;  ///< per mesh
  Json result = Json::object();
  std::function<void(const MeshFolder&)> write_more = {};  ///< into the folder
};

Surface surface_of(std::span<const LoadedMesh> operands, std::size_t k, const Settings& settings) {
  try {
    Surface surface(operands[k].mesh);
    if (!settings.quiet)
      for (const strata::Defect& note : surface.notes())
        fmt::print(stderr, "strata: {}: {}\n", operands[k].path, strata::describe(note));
    return surface;
  } catch (const strata::InputError& error) {
    throw strata::InputError(error.defects(), k);
  }
}

std::vector<Surface> surfaces_from(std::span<const LoadedMesh> operands, std::size_t first, const Settings& settings) {
  std::vector<Surface> surfaces;
  for (std::size_t k = first; k < operands.size(); ++k) surfaces.push_back(surface_of(operands, k, settings));
  return surfaces;
}

Json facts_of(const strata::ExactMesh& mesh) {
  return {
      {"vertices", mesh.mesh.vertices.size()}, {"triangles", mesh.mesh.triangles.size()}, {"area", strata::area(mesh)}};
}

Product of_solids(const char* stem, const char* counted, const std::vector<strata::Solid>& solids) {
  Product product;
  product.stem = stem;
  strata::Rational total = 0;
  for (const strata::Solid& solid : solids) {
    Json facts = facts_of(solid.exact_mesh());
    const strata::Rational volume = solid.volume();
    facts["volume_exact"] = volume.str();
    total += volume;
    product.meshes.push_back(solid.exact_mesh());
    product.facts.push_back(std::move(facts));
  }
  product.result = {
      {counted, solids.size()}, {"volume", strata::to_nearest_double(total)}, {"volume_exact", total.str()}};
  return product;
}

/// The walls and a table of them: which cells a wall divides, and which faces it is part of, a row each.
void write_walls(const strata::Arrangement& a, const std::vector<Surface>& surfaces, const MeshFolder& folder,
                 const Settings& settings) {
  const std::string extension = settings.output_format.empty() ? "xoff" : settings.output_format;
  Settings of_walls = settings;
  of_walls.output = folder.path("walls." + extension);
  of_walls.output_format.clear();
  write_output(of_walls, output_format(of_walls), a.mesh);
  OutputFile table(folder.path("walls.csv"));
  table.write("wall,in_front,behind,operand,face,reversed\n");
  auto cover = a.covers.begin();
  for (std::size_t w = 0; w < a.cells.size(); ++w) {
    const auto row = [&](const strata::Source& face, bool is_reversed) {
      table.write(fmt::format("{},{},{},{},{},{}\n", w, a.cells[w][0], a.cells[w][1], face.operand,
                              surfaces[face.operand].sources()[face.face].face, is_reversed ? 1 : 0));
    };
    row(a.sources[w], false);
    for (; cover != a.covers.end() && cover->wall == w; ++cover) row(cover->face, cover->is_reversed);
  }
  table.finish();
}

void write_folder(const Product& product, const char* verb, const Settings& settings) {
  const MeshFolder folder(settings, product.stem, product.meshes.size());
  Json list = Json::array();
  for (std::size_t i = 0; i < product.meshes.size(); ++i) {
    Json entry = {{"file", folder.write(i, product.meshes[i])}};
    entry.update(product.facts[i]);
    list.push_back(std::move(entry));
  }
  if (product.write_more) product.write_more(folder);
  write_text(folder.path(fmt::format("{}.json", verb)), Json({{"files", std::move(list)}}).dump(1) + "\n");
}

using Evaluate = std::function<Product(std::span<const LoadedMesh>, const strata::Options&)>;

/// Reads, computes with a progress bar, writes and reports.
ExitCode run(const char* verb, const Settings& settings, bool to_folder, const Evaluate& evaluate) {
  Watch watch(settings.timeout);
  Stopwatch stopwatch;
  if (to_folder && !settings.output.empty()) MeshFolder::check(settings);
  if (!to_folder) (void)output_format(settings);
  Json report = {{"operation", verb}, {"operands", nullptr}, {"result", nullptr}, {"seconds", Json::object()}};
  const std::vector<LoadedMesh> operands = read_operands(settings);
  report["seconds"]["read"] = stopwatch.lap();

  watch.on_stop(OnStop::ask);
  Product product;
  try {
    ProgressBar bar(settings.progress, settings.quiet);
    product = evaluate(operands, watched_options(settings, bar, watch));
  } catch (const strata::Cancelled&) {
    watch.on_stop(OnStop::leave);  // says why
    throw;
  }
  report["seconds"]["evaluate"] = stopwatch.lap();
  report["result"] = product.result;
  report["peak_bytes"] = peak_bytes();

  watch.on_stop(OnStop::finish);
  if (!to_folder) write_output(settings, output_format(settings), product.meshes.front());
  if (to_folder && !settings.output.empty()) write_folder(product, verb, settings);
  report["seconds"]["write"] = stopwatch.lap();
  if (!settings.quiet && settings.report != "-")
    for (const auto& [key, value] : product.result.items())
      if (const std::string text = value.dump(); text.size() < 100)  // longer fractions are for the report
        fmt::print(settings.output == "-" ? stderr : stdout, "{:12} {}\n", key, text);
  if (settings.report.empty()) return ExitCode::ok;
  report["operands"] = Json::array();
  for (const LoadedMesh& operand : operands) report["operands"].push_back(operand_report(operand, {}));
  write_report(settings.report, std::move(report));
  return ExitCode::ok;
}

}  // namespace

ExitCode run_clip(const SurfaceSettings& surface, const Settings& settings) {
  return run("clip", settings, false, [&](std::span<const LoadedMesh> operands, const strata::Options& options) {
    const strata::Solid solid = make_solid(operands, 1, settings);
    const Surface part = strata::clip(surface_of(operands, 0, settings), solid, surface.keep, options);
    Product product;
    product.result = facts_of(part.exact_mesh());
    product.result["keep"] = name(surface.keep);
    product.meshes.push_back(part.exact_mesh());
    return product;
  });
}

ExitCode run_split(const SurfaceSettings& surface, const Settings& settings) {
  std::vector<strata::Plane> planes;
  for (const std::string& text : surface.planes) planes.push_back(parse_plane(text));
  if (planes.empty() && settings.operands.size() < 2)
    throw UsageError("split needs a surface or a --plane that divides the solid");
  return run("split", settings, true, [&](std::span<const LoadedMesh> operands, const strata::Options& options) {
    const strata::Solid solid = make_solid(operands, 0, settings);
    std::vector<Surface> surfaces = surfaces_from(operands, 1, settings);
    for (const strata::Plane& plane : planes) surfaces.push_back(Surface::of_plane(plane, solid.bounding_box()));
    return of_solids("piece", "pieces", strata::split(solid, surfaces, options));
  });
}

ExitCode run_imprint(const Settings& settings) {
  return run("imprint", settings, true, [&](std::span<const LoadedMesh> operands, const strata::Options& options) {
    Product product;
    product.stem = "surface";
    std::size_t triangles = 0;
    for (const Surface& s : strata::imprint(surfaces_from(operands, 0, settings), options)) {
      product.facts.push_back(facts_of(s.exact_mesh()));
      product.facts.back()["of"] = operands[product.meshes.size()].path;
      product.meshes.push_back(s.exact_mesh());
      triangles += s.mesh().triangles.size();
    }
    product.result = {{"surfaces", product.meshes.size()}, {"triangles", triangles}};
    return product;
  });
}

ExitCode run_cells(const SurfaceSettings& surface, const Settings& settings) {
  if (surface.walls && settings.output.empty()) throw UsageError("--walls go into the folder that -o names");
  return run("cells", settings, true, [&](std::span<const LoadedMesh> operands, const strata::Options& options) {
    std::vector<Surface> surfaces = surfaces_from(operands, 0, settings);
    strata::Arrangement a = strata::arrange(surfaces, options);
    Product product = of_solids("cell", "cells", a.solids());
    for (std::size_t i = 0; i < product.facts.size(); ++i) product.facts[i]["cell"] = i + 1;
    product.result["walls"] = a.cells.size();
    if (surface.walls)
      product.write_more = [a = std::move(a), surfaces = std::move(surfaces), &settings](const MeshFolder& folder) {
        write_walls(a, surfaces, folder, settings);
      };
    return product;
  });
}
