#include "strata/surface.h"

#include <fmt/format.h>

#include <array>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "common/output_file.h"
#include "files.h"
#include "mesh_folder.h"
#include "plane_option.h"
#include "strata/carry_attributes.h"
#include "strata/measure.h"
#include "surface_verbs.h"
#include "verb_run.h"

namespace {

using strata::Surface;

/// A mesh that a verb made.
struct MadeMesh {
  strata::ExactMesh mesh;
  strata::Attributes attributes;
  Json facts;
};

/// What a verb made: meshes of one kind, for a folder, or for one file.
struct Product {
  const char* stem = "";  ///< of file names
  MeshContent content = MeshContent::solid;
  std::vector<MadeMesh> meshes;
  Json result = Json::object();
  std::function<void(const MeshFolder&)> write_more = {};  ///< into the folder
};

Surface surface_of(VerbRun& run, std::size_t k) {
  try {
    const LoadedMesh& operand = run.operands()[k];
    Surface surface(operand.mesh);
    run.note(k, surface.notes());
    if (operand.attributes.empty()) return surface;
    const std::array given{strata::AttributedMesh{operand.mesh, &operand.attributes}};
    return surface.with_attributes(strata::carry_attributes(given, surface.exact_mesh(), surface.sources()));
  } catch (const strata::InputError& error) {
    throw strata::InputError(error.defects(), k);
  }
}

std::vector<Surface> surfaces_from(VerbRun& run, std::size_t first) {
  std::vector<Surface> surfaces;
  for (std::size_t k = first; k < run.operands().size(); ++k) surfaces.push_back(surface_of(run, k));
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
    product.meshes.push_back({solid.exact_mesh(), solid.attributes(), std::move(facts)});
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
    const MadeMesh& made = product.meshes[i];
    Json entry = {{"file", folder.write(i, made.mesh, made.attributes, product.content)}};
    entry.update(made.facts);
    list.push_back(std::move(entry));
  }
  if (product.write_more) product.write_more(folder);
  write_text(folder.path(fmt::format("{}.json", verb)), Json({{"files", std::move(list)}}).dump(1) + "\n");
}

void write_file(const Product& product, const Settings& settings) {
  RegionFile file(settings);
  for (std::size_t i = 0; i < product.meshes.size(); ++i)
    file.add(product.meshes[i].mesh, product.meshes[i].attributes, fmt::format("{} {}", product.stem, i),
             product.content);
  file.write();
}

/// Computes, and writes what was made into the folder that -o names, or the file, if there is one.
template <class Make>
ExitCode run_to_folder(const char* verb, const Settings& settings, const Make& make) {
  const bool is_file = RegionFile::is_named(settings);
  if (!settings.output.empty() && !is_file) MeshFolder::check(settings);
  VerbRun run(verb, settings);
  Product product;
  run.evaluate([&](const strata::Options& options) { product = make(run, options); });
  run.begin_writing();
  const Settings of_files = with_unit_of(run.operands(), settings);
  if (is_file)
    write_file(product, of_files);
  else if (!settings.output.empty())
    write_folder(product, verb, of_files);
  return run.end(std::move(product.result));
}

}  // namespace

ExitCode run_clip(const SurfaceSettings& surface, const Settings& settings) {
  const strata::Format format = output_format(settings);
  VerbRun run("clip", settings);
  Surface part;
  run.evaluate([&](const strata::Options& options) {
    const strata::Solid solid = run.solid(1);
    part = strata::clip(surface_of(run, 0), solid, surface.keep, options);
  });
  run.begin_writing();
  write_output(with_unit_of(run.operands(), settings), format, part.exact_mesh(), part.attributes());
  Json result = facts_of(part.exact_mesh());
  result["keep"] = name(surface.keep);
  return run.end(std::move(result));
}

ExitCode run_split(const SurfaceSettings& surface, const Settings& settings) {
  std::vector<strata::Plane> planes;
  for (const std::string& text : surface.planes) planes.push_back(parse_plane(text));
  if (planes.empty() && settings.operands.size() < 2)
    throw UsageError("it needs a surface or a --plane that divides the solid");
  return run_to_folder("split", settings, [&](VerbRun& run, const strata::Options& options) {
    const strata::Solid solid = with_attributes_of(run.operands().front(), run.solid(0));
    std::vector<Surface> surfaces = surfaces_from(run, 1);
    for (const strata::Plane& plane : planes) surfaces.push_back(Surface::of_plane(plane, solid.bounding_box()));
    std::vector<const strata::Attributes*> lists;
    for (const LoadedMesh& operand : run.operands()) lists.push_back(&operand.attributes);
    const auto cut_material = settings.attributes.material_among(lists);
    strata::Options with_material = options;
    if (cut_material) with_material.cut_material = &*cut_material;
    return of_solids("piece", "pieces", strata::split(solid, surfaces, with_material));
  });
}

ExitCode run_imprint(const Settings& settings) {
  return run_to_folder("imprint", settings, [&](VerbRun& run, const strata::Options& options) {
    Product product;
    product.stem = "surface";
    std::size_t triangles = 0;
    for (const Surface& s : strata::imprint(surfaces_from(run, 0), options)) {
      Json facts = facts_of(s.exact_mesh());
      facts["of"] = run.operands()[product.meshes.size()].path;
      product.meshes.push_back({s.exact_mesh(), s.attributes(), std::move(facts)});
      triangles += s.mesh().triangles.size();
    }
    product.content = MeshContent::surface;
    product.result = {{"surfaces", product.meshes.size()}, {"triangles", triangles}};
    return product;
  });
}

ExitCode run_cells(const SurfaceSettings& surface, const Settings& settings) {
  if (surface.walls && (settings.output.empty() || RegionFile::is_named(settings)))
    throw UsageError("--walls go into the folder that -o names");
  return run_to_folder("cells", settings, [&](VerbRun& run, const strata::Options& options) {
    std::vector<Surface> surfaces = surfaces_from(run, 0);
    strata::Arrangement a = strata::arrange(surfaces, options);
    Product product = of_solids("cell", "cells", strata::cells_of(a, surfaces, options));
    for (std::size_t i = 0; i < product.meshes.size(); ++i) product.meshes[i].facts["cell"] = i + 1;
    product.result["walls"] = a.cells.size();
    if (surface.walls)
      product.write_more = [a = std::move(a), surfaces = std::move(surfaces), &settings](const MeshFolder& folder) {
        write_walls(a, surfaces, folder, settings);
      };
    return product;
  });
}
