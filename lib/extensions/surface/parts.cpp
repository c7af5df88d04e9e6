#include "extensions/surface/parts.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "core/csg/arena.h"
#include "extensions/surface/surface_data.h"
#include "extensions/surface/walls.h"
#include "strata/carry_attributes.h"

namespace strata {
namespace {

using Index = std::uint32_t;
constexpr Index unnumbered = std::numeric_limits<Index>::max();

/// A wall as a part of an operand, with its first face there.
struct OperandWall {
  Index wall = 0;
  Source face;
  bool is_reversed = false;
};

/// The walls of every operand, in order.
std::vector<std::vector<OperandWall>> walls_of_operands(const Walls& walls, std::size_t operands) {
  std::vector<std::vector<OperandWall>> lists(operands);
  const auto add = [&](Index wall, const Source& face, bool is_reversed) {
    std::vector<OperandWall>& list = lists[face.operand];
    if (list.empty() || list.back().wall != wall) list.push_back({wall, face, is_reversed});
  };
  const Boundary& boundary = walls.boundary();
  auto cover = boundary.covers.begin();
  for (Index w = 0; w < walls.size(); ++w) {
    add(w, boundary.sources[w], false);
    for (; cover != boundary.covers.end() && cover->triangle == w; ++cover)
      add(w, walls.source(cover->face), walls.is_reversed(*cover));
  }
  return lists;
}

/// `number`: as for MeshPart.
Surface surface_of_walls(const ExactMesh& mesh, std::span<const OperandWall> walls, std::vector<Index>& number) {
  MeshPart part(mesh, number);
  std::vector<Source> sources;
  for (const OperandWall& w : walls) {
    part.add(mesh.mesh.triangles[w.wall], w.is_reversed);
    sources.push_back(w.face);
  }
  return surface_of(std::move(part).mesh(), std::move(sources));
}

/// A part of one of the operands, with what that one carries.
Surface carried(Surface part, std::span<const Surface> operands, Index operand, const Options& options) {
  const Attributes& attributes = operands[operand].attributes();
  if (attributes.empty()) return part;
  std::vector<AttributedMesh> meshes(operands.size());
  meshes[operand] = {operands[operand].exact_mesh(), &attributes};
  return part.with_attributes(carry_attributes(meshes, part.exact_mesh(), part.sources(), options));
}

}  // namespace

bool carry_nothing(std::span<const Surface> surfaces) {
  return std::ranges::all_of(surfaces, [](const Surface& s) { return s.attributes().empty(); });
}

std::vector<AttributedMesh> attributed_meshes(std::span<const Surface> surfaces) {
  std::vector<AttributedMesh> meshes;
  for (const Surface& s : surfaces) meshes.push_back({s.exact_mesh(), &s.attributes()});
  return meshes;
}

MeshPart::~MeshPart() {
  for (const Index v : used_) number_[v] = unnumbered;
}

void MeshPart::add(const Triangle& triangle, bool is_reversed) {
  Triangle t{};
  for (std::size_t i = 0; i < 3; ++i) {
    Index& number = number_[triangle[i]];
    if (number == unnumbered) {
      number = static_cast<Index>(used_.size());
      used_.push_back(triangle[i]);
      part_.mesh.vertices.push_back(mesh_.mesh.vertices[triangle[i]]);
    }
    t[i] = number;
  }
  if (is_reversed) std::swap(t[1], t[2]);
  part_.mesh.triangles.push_back(t);
}

ExactMesh MeshPart::mesh() && {
  if (!mesh_.exact.empty())
    for (Index v = 0; v < used_.size(); ++v) {
      const auto exact = std::lower_bound(mesh_.exact.begin(), mesh_.exact.end(), used_[v],
                                          [](const ExactVertex& e, Index w) { return e.vertex < w; });
      if (exact != mesh_.exact.end() && exact->vertex == used_[v]) part_.exact.push_back({v, exact->position});
    }
  return std::move(part_);
}

std::vector<Solid> split(const Solid& solid, std::span<const Surface> surfaces, const Options& options) {
  std::vector<Surface> operands{Surface(solid)};
  operands.insert(operands.end(), surfaces.begin(), surfaces.end());
  const Arrangement a = arrange(operands, options);
  const std::vector<std::int32_t> windings = a.windings(0);
  std::vector<Index> inside;
  for (Index c = 1; c < a.cell_count; ++c)
    if (windings[c] > 0) inside.push_back(c);
  std::vector<Solid> pieces = solids_of(a, inside);
  if (carry_nothing(operands) && options.cut_material == nullptr) return pieces;
  const std::vector<AttributedMesh> sources = attributed_meshes(operands);
  for (Solid& piece : pieces)
    piece = piece.with_attributes(
        carry_attributes(sources, piece.exact_mesh(), piece.sources(), options, CutFaces::of_later_operands));
  return pieces;
}

Surface clip(const Surface& surface, const Solid& solid, ClipTo part, const Options& options) {
  const std::array operands{surface, Surface(solid.exact_mesh())};
  const Arrangement a = arrange(operands, options);
  const std::vector<std::int32_t> windings = a.windings(1);
  std::vector<OperandWall> kept;
  for (Index w = 0; w < a.cells.size(); ++w) {  // the surface's faces come before those of the solid
    if (a.sources[w].operand != 0) continue;
    const bool in_front = windings[a.cells[w][0]] > 0, behind = windings[a.cells[w][1]] > 0;
    const ClipTo is = in_front != behind ? ClipTo::on : in_front ? ClipTo::inside : ClipTo::outside;
    if (is == part) kept.push_back({w, a.sources[w], false});
  }
  std::vector<Index> number(a.mesh.mesh.vertices.size(), unnumbered);
  return carried(surface_of_walls(a.mesh, kept, number), operands, 0, options);
}

std::vector<Surface> imprint(std::span<const Surface> surfaces, const Options& options) {
  const Monitor monitor(options.cancel, &options.progress);
  monitor.check();
  std::size_t faces = 0;
  for (const Surface& s : surfaces) faces += s.mesh().triangles.size();
  std::vector<Surface> result(surfaces.size());
  if (faces == 0) return result;
  arena_for(options, faces).execute([&] {
    const Walls walls(surfaces, monitor);
    monitor.report(0.8);
    const ExactMesh mesh = walls.mesh(monitor);
    std::vector<Index> number(mesh.mesh.vertices.size(), unnumbered);
    const auto lists = walls_of_operands(walls, result.size());
    for (Index k = 0; k < result.size(); ++k)
      result[k] = carried(surface_of_walls(mesh, lists[k], number), surfaces, k, options);
  });
  monitor.report(1);
  return result;
}

}  // namespace strata
