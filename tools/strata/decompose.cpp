#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "cell_file.h"
#include "common/progress.h"
#include "common/stopwatch.h"
#include "common/watch.h"
#include "files.h"
#include "mesh_folder.h"
#include "region_file.h"
#include "report.h"
#include "strata/carry_attributes.h"
#include "strata/convex.h"
#include "strata/measure.h"
#include "verbs.h"

namespace {

using strata::convex::Decomposition;

bool is_picture(const std::string& path) { return path == "-" || path.ends_with(".glb") || path.ends_with(".GLB"); }

void check_output(const Settings& settings) {
  if (settings.exploded && !is_picture(settings.output))
    throw UsageError("--exploded is for pictures: give -o the name of a .glb file");
  if (is_picture(settings.output) && !settings.output_format.empty())
    throw UsageError("pictures are written as glTF: --format is for the files of a folder");
  if (!settings.output.empty() && !is_picture(settings.output) && !RegionFile::is_named(settings))
    MeshFolder::check(settings);
}

Json facts(const Decomposition& d) {
  return {{"reflex_edges", d.reflex_edges},
          {"cuts", d.cuts},
          {"pieces", d.pieces.size()},
          {"walls", d.walls.size()},
          {"points", d.points.size()}};
}

void write_picture(const Decomposition& d, const Settings& settings) {
  std::vector<CellPolygons> cells;
  for (const auto& piece : d.pieces) {
    CellPolygons& polygons = cells.emplace_back();
    for (const Decomposition::Polygon& facet : piece) {
      auto& polygon = polygons.emplace_back();
      for (const std::uint32_t point : facet) polygon.push_back(d.points[point]);
    }
  }
  write_cells(settings.output, cells, settings.exploded ? exploded : in_place);
}

strata::Vertex middle_of(const strata::BoundingBox& box) {
  strata::Vertex middle{};
  for (std::size_t i = 0; i < 3; ++i) middle[i] = box.lower[i] / 2 + box.upper[i] / 2;
  return middle;
}

/// True where a picture shows what a solid carries.
bool has_looks(const strata::Solid& solid) {
  const strata::Attributes& a = solid.attributes();
  return a.find(strata::channel_names::color) != nullptr || a.find(strata::channel_names::material) != nullptr;
}

/// A piece as it stands in a picture of the solid: around the origin, in units of the solid's size, as floats.
strata::Mesh placed(const strata::Solid& piece, const strata::BoundingBox& box, bool is_exploded) {
  const strata::Vertex middle = middle_of(box), own = middle_of(piece.bounding_box());
  double size = 0;
  for (std::size_t i = 0; i < 3; ++i) size = std::max(size, box.upper[i] - box.lower[i]);
  strata::Mesh mesh = piece.mesh();
  for (strata::Vertex& v : mesh.vertices)
    for (std::size_t i = 0; i < 3; ++i) {
      const double away = (is_exploded ? exploded : in_place) * (own[i] - middle[i]);
      v[i] = static_cast<float>((v[i] - middle[i] + away) / size);
    }
  return mesh;
}

/// The pieces in their own colours and textures, each an object.
void write_painted_picture(const strata::Solid& solid, const std::vector<strata::Solid>& pieces,
                           const Settings& settings) {
  std::vector<strata::Mesh> meshes;
  std::vector<strata::AttributedMesh> parts;
  strata::ExactMesh all;
  std::vector<strata::Source> sources;
  std::vector<std::int32_t> object;
  std::vector<std::string> names;
  for (const strata::Solid& piece : pieces) meshes.push_back(placed(piece, solid.bounding_box(), settings.exploded));
  for (std::uint32_t p = 0; p < pieces.size(); ++p) {
    const strata::Mesh& mesh = meshes[p];
    parts.push_back({strata::ExactMeshView(mesh, {}), &pieces[p].attributes()});
    const auto first = static_cast<std::uint32_t>(all.mesh.vertices.size());
    all.mesh.vertices.insert(all.mesh.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto [a, b, c] = mesh.triangles[t];
      all.mesh.triangles.push_back({first + a, first + b, first + c});
      sources.push_back({p, t});
      object.push_back(static_cast<std::int32_t>(p));
    }
    names.push_back(fmt::format("piece {}", p));
  }
  strata::Attributes attributes = strata::carry_attributes(parts, all, sources);
  std::erase_if(attributes.channels, [](const strata::Channel& c) { return c.name == strata::channel_names::object; });
  attributes.objects = std::move(names);
  attributes.channels.push_back({std::string(strata::channel_names::object), strata::Element::face,
                                 strata::Interpolation::nearest, 1, std::move(object)});
  Settings of_picture = settings;
  of_picture.strict = of_picture.tells_losses = false;
  write_output(of_picture, strata::Format::glb, all, attributes);
}

/// A coordinate: a number, or a fraction as text where doubles are not exact.
Json place(const strata::RationalPoint& p) {
  Json xyz = Json::array();
  for (const strata::Rational& exact : p) {
    const double x = strata::to_nearest_double(exact);
    xyz.push_back(strata::to_rational(x) == exact ? Json(x) : Json(exact.str()));
  }
  return xyz;
}

Json walls(const Decomposition& d) {
  Json list = Json::array();
  for (const strata::convex::Wall& wall : d.walls) {
    Json polygon = Json::array();
    for (const std::uint32_t point : wall.polygon) polygon.push_back(place(d.position(point)));
    list.push_back({{"pieces", wall.pieces}, {"polygon", std::move(polygon)}});
  }
  return list;
}

/// Space as the pieces, the cavities and the outside divide it: each with its shells and its neighbours, and the convex
/// polygons between them.
Json volumes(const strata::Solid& solid, const Decomposition& d) {
  const strata::convex::VolumeComplex complex = strata::convex::volumes_of(solid, d);
  const strata::ExactMesh points{{complex.points, {}}, complex.exact};
  constexpr std::array marks{"outer", "cavity", "piece"};
  Json list = Json::array(), interfaces = Json::array();
  for (const strata::convex::Volume& v : complex.volumes)
    list.push_back({{"mark", marks[static_cast<std::size_t>(v.mark)]},
                    {"selected", v.mark == strata::convex::Mark::piece},
                    {"shells", v.shells},
                    {"neighbours", v.neighbours}});
  for (const strata::convex::Interface& i : complex.interfaces) {
    Json polygon = Json::array();
    for (const std::uint32_t point : i.polygon) polygon.push_back(place(points.position(point)));
    interfaces.push_back({{"volumes", i.volumes}, {"polygon", std::move(polygon)}});
  }
  return {{"first_piece", complex.first_piece}, {"volumes", std::move(list)}, {"interfaces", std::move(interfaces)}};
}

/// The pieces of a solid, as they are written.
struct Pieces {
  Decomposition decomposition;
  std::vector<strata::Solid> carried;  ///< as solids that carry what the solid does; none where this is nothing

  [[nodiscard]] strata::ExactMesh mesh(std::uint32_t p) const {
    return carried.empty() ? mesh_of(decomposition.polytope(p)) : carried[p].exact_mesh();
  }
  [[nodiscard]] strata::Attributes attributes(std::uint32_t p) const {
    return carried.empty() ? strata::Attributes{} : carried[p].attributes();
  }
};

std::vector<strata::Solid> carried_pieces(const strata::Solid& solid, const Decomposition& d, const Settings& settings,
                                          const Watch& watch) {
  const auto cut_material = settings.attributes.material_among({&solid.attributes()});
  if (!cut_material && solid.attributes().empty()) return {};
  strata::Options options;
  options.threads = settings.threads;
  options.cancel = &watch.token();
  if (cut_material) options.cut_material = &*cut_material;
  return strata::convex::pieces_of(solid, d, options);
}

/// A file for every piece, and last decomposition.json, which names them and tells their walls.
void write_folder(const Pieces& pieces, const Settings& settings) {
  const Decomposition& d = pieces.decomposition;
  const MeshFolder folder(settings, "piece", d.pieces.size());
  Json list = Json::array();
  for (std::uint32_t p = 0; p < d.pieces.size(); ++p) {
    const strata::ExactMesh mesh = pieces.mesh(p);
    list.push_back({{"file", folder.write(p, mesh, pieces.attributes(p), MeshContent::solid)},
                    {"facets", d.pieces[p].size()},
                    {"volume_exact", volume(mesh).str()}});
  }
  Json document = {{"pieces", std::move(list)}, {"walls", walls(d)}};
  write_text(folder.path("decomposition.json"), document.dump(1) + "\n");
}

/// All pieces in one file, each a group.
void write_file(const Pieces& pieces, const Settings& settings) {
  RegionFile file(settings);
  for (std::uint32_t p = 0; p < pieces.decomposition.pieces.size(); ++p)
    file.add(pieces.mesh(p), pieces.attributes(p), fmt::format("piece {}", p), MeshContent::solid);
  file.write();
}

void write_pieces(const Pieces& pieces, const Settings& settings) {
  if (RegionFile::is_named(settings))
    write_file(pieces, settings);
  else
    write_folder(pieces, settings);
}

}  // namespace

ExitCode run_decompose(const Settings& settings) {
  Watch watch(settings.timeout);
  Stopwatch stopwatch;
  check_output(settings);
  if (settings.volumes && settings.report.empty()) throw UsageError("--volumes go into the report: give --report");
  Json report = {{"operation", "decompose"}, {"operands", nullptr}, {"result", nullptr}, {"seconds", Json::object()}};
  const std::vector<LoadedMesh> operands = read_operands(settings);
  report["seconds"]["read"] = stopwatch.lap();

  watch.on_stop(OnStop::ask);
  Pieces pieces;
  Decomposition& d = pieces.decomposition;
  strata::Solid solid;
  const bool writes_picture = is_picture(settings.output);
  try {
    solid = make_attributed_solid(operands, 0, settings);
    report["seconds"]["prepare"] = stopwatch.lap();
    ProgressBar bar(settings.progress, settings.quiet);
    const strata::Progress progress = [&bar](double fraction) { bar.show(fraction); };
    d = strata::convex::decompose(solid, strata::Monitor(&watch.token(), &progress));
    if (!settings.output.empty()) pieces.carried = carried_pieces(solid, d, settings, watch);
    report["seconds"]["decompose"] = stopwatch.lap();
  } catch (const strata::Cancelled&) {
    watch.on_stop(OnStop::leave);  // says why
    throw;
  }
  report["result"] = facts(d);
  report["peak_bytes"] = peak_bytes();

  watch.on_stop(OnStop::finish);
  stopwatch.lap();
  if (writes_picture && !pieces.carried.empty() && has_looks(pieces.carried.front())) {
    write_painted_picture(solid, pieces.carried, settings);
  } else if (writes_picture) {
    tell_what_is_not_carried(operands, settings);
    write_picture(d, settings);
  } else if (!settings.output.empty()) {
    write_pieces(pieces, with_unit_of(operands, settings));
  }
  report["seconds"]["write"] = stopwatch.lap();
  if (!settings.quiet && settings.report != "-")
    for (const auto& [key, value] : report["result"].items())
      fmt::print(settings.output == "-" ? stderr : stdout, "{:12} {}\n", key, value.dump());
  if (settings.report.empty()) return ExitCode::ok;
  if (settings.volumes) report["volumes"] = volumes(solid, d);
  report["operands"] = operand_reports(operands, settings);
  write_report(settings.report, std::move(report));
  return ExitCode::ok;
}
