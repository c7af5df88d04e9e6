#include "core/csg/resolve_again.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

#include "core/containers/collect.h"
#include "core/containers/huge_pages.h"
#include "core/csg/boolean.h"
#include "core/mesh/equal_vertices.h"
#include "core/mesh/prepare.h"
#include "core/overlap/self_intersections.h"
#include "core/overlap/shells.h"
#include "core/round/resolve_in_place.h"

namespace strata {
namespace {

using FacePairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// Are pairs of faces that cross known, and few beside all faces?
bool are_few(const MovingMesh& mesh, const ChangedRegion& region) {
  constexpr std::size_t part = 8;
  return region.is_complete() && region.has_area_everywhere() &&
         region.wrong_pairs().size() <= mesh.mesh().triangles.size() / part;
}

/// Vertices in one place become one.
void join_equal_vertices(MovingMesh& mesh, const ChangedRegion& region) {
  std::vector<VertexMove> moves;
  for (const auto& [vertex, first] : region.equal_vertices())
    moves.push_back({vertex, first, mesh.mesh().vertices[vertex], 0});
  mesh.move(moves);
}

/// Of a whole mesh but for the faces that cross. Where stars are not known, they are found.
FacePatches patches_of(const MovingMesh& mesh, const FacePairs& crossings, const Monitor& monitor) {
  const std::size_t count = mesh.mesh().triangles.size();
  std::vector<bool> is_other(count, false);  // it crosses others, or is no longer there
  for (const auto& [face, other] : crossings) is_other[face] = is_other[other] = true;
  for (std::uint32_t f = 0; f < count; ++f)
    if (!mesh.is_left(f)) is_other[f] = true;
  const InputComplex complex = complex_of(mesh.mesh());
  const Shells shells = find_patches(complex, mesh.stars() ? *mesh.stars() : EmbeddedStars(complex, monitor), is_other);
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> number(shells.count, none);
  FacePatches patches;
  for (std::uint32_t f = 0; f < count; ++f) {
    if (is_other[f]) continue;
    std::uint32_t& patch = number[shells.of_face[f]];
    if (patch == none) {
      patch = static_cast<std::uint32_t>(patches.is_known.size());
      patches.is_known.push_back(false);
    }
    patches.faces.push_back(f);
    patches.patch.push_back(patch);
  }
  return patches;
}

std::optional<std::vector<VertexMove>> resolve_few(MovingMesh& mesh, const ChangedRegion& region,
                                                   const std::vector<std::uint32_t>& wrong, const GridRounding& grid,
                                                   const Monitor& monitor) {
  std::optional<FacePatches> patches;
  if (mesh.swept()) patches = region.patches(wrong);
  join_equal_vertices(mesh, region);
  if (!patches) patches = patches_of(mesh, region.wrong_pairs(), monitor);
  return resolve_in_place(mesh, region.wrong_pairs(), *patches, grid, monitor);
}

/// Without triangles that repeat a vertex, and with faces of positive area only.
Prepared without_degenerate_faces(const Mesh& mesh) {
  Mesh distinct{mesh.vertices, on_first_vertices(ExactMeshView(mesh, {}))};
  std::vector<std::uint32_t> kept;
  for (std::uint32_t f = 0; f < distinct.triangles.size(); ++f) {
    if (repeats_vertex(distinct.triangles[f])) continue;
    distinct.triangles[kept.size()] = distinct.triangles[f];
    kept.push_back(f);
  }
  distinct.triangles.resize(kept.size());
  Prepared prepared = prepare_closed(distinct, true);
  for (std::uint32_t& f : prepared.source_face) f = kept[f];
  if (prepared.source_face.empty()) prepared.source_face = std::move(kept);
  if (!prepared.mesh) prepared.mesh = std::move(distinct);
  return prepared;
}

std::vector<VertexMove> moves_of_new_vertices(const BooleanResult& result, const GridRounding& grid, int bits_less) {
  const std::vector<Vertex>& points = result.mesh.vertices;
  std::vector<bool> is_exact(points.size(), false);
  for (const ExactVertex& e : result.exact) is_exact[e.vertex] = true;
  std::vector<bool> is_new = is_exact;
  if (!grid.holds_all_doubles())
    for (std::size_t v = 0; v < is_new.size(); ++v) is_new[v] = is_exact[v] || !grid.holds(points[v]);
  std::vector<VertexMove> moves;
  if (std::none_of(is_new.begin(), is_new.end(), [](bool x) { return x; })) return moves;
  std::vector<bool> is_moved = is_new;
  for (const Triangle& t : result.mesh.triangles)
    if (bits_less > 0 && (is_new[t[0]] || is_new[t[1]] || is_new[t[2]]))
      for (const std::uint32_t v : t) is_moved[v] = true;
  for (std::uint32_t v = 0; v < points.size(); ++v)
    if (is_moved[v] || bits_less >= GridRounding::most_bits)
      moves.push_back(move_to_grid(v, points[v], is_exact[v], grid, bits_less));
  return moves;
}

/// The faces that cross are searched for in all of it.
std::vector<VertexMove> resolve_whole(MovingMesh& mesh, const GridRounding& grid, int bits_less,
                                      const Monitor& monitor) {
  const MovingMesh::Parts from = std::move(mesh).take();
  const Prepared prepared = without_degenerate_faces(from.mesh);
  if (prepared.mesh->triangles.empty()) {
    mesh = MovingMesh({}, {}, {});
    return {};
  }
  InputComplex complex(SelfIntersections::possible);
  complex.add(prepared.mesh->vertices, prepared.mesh->triangles, {}, prepared.bounds);
  BooleanResult result = resolved(std::move(complex), Inside::winding, monitor);
  std::vector<std::uint32_t> source_face;
  std::vector<double> moved;
  resize_fresh(source_face, result.sources.size());
  resize_fresh(moved, result.sources.size());
  tbb::parallel_for(std::size_t{0}, result.sources.size(), [&](std::size_t i) {
    const std::uint32_t source = prepared.source_face[result.sources[i].face];
    source_face[i] = from.source_face[source];
    moved[i] = from.moved[source];
  });
  std::vector<VertexMove> moves = moves_of_new_vertices(result, grid, bits_less);
  mesh = MovingMesh(std::move(result.mesh), std::move(source_face), std::move(moved));
  return moves;
}

}  // namespace

bool resolve_again(MovingMesh& mesh, const ChangedRegion& region, const std::vector<std::uint32_t>& wrong,
                   const GridRounding& grid, int bits_less, const Monitor& monitor) {
  std::optional<std::vector<VertexMove>> moves;
  if (bits_less == 0 && are_few(mesh, region)) moves = resolve_few(mesh, region, wrong, grid, monitor);
  if (!moves) moves = resolve_whole(mesh, grid, bits_less, monitor);
  mesh.move(*moves);
  return !moves->empty();
}

}  // namespace strata
