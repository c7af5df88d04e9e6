#include "core/csg/shell_windings.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "core/containers/box_sweep.h"
#include "core/mesh/prepare.h"
#include "core/overlap/candidates.h"
#include "core/overlap/self_intersections.h"
#include "core/winding/local_windings.h"

namespace strata {
namespace {

constexpr std::uint32_t unset = 0xffffffffu;

/// A shell as a mesh of its own, oriented outwards.
struct Part {
  ExactMesh mesh;
  bool is_reversed = false;  ///< in the mesh it has the opposite orientation
};

bool is_reversed(ExactMeshView mesh) {
  return mesh.exact.empty() ? screen(mesh.mesh).orientation < 0 : orientation(mesh) == Sign::negative;
}

/// Divides a mesh into its shells. Requires that none share an edge.
std::vector<Part> parts_of(ExactMeshView mesh, const Shells& shells) {
  std::vector<Part> parts(shells.count);
  std::vector<std::uint32_t> exact_at(mesh.exact.empty() ? 0 : mesh.mesh.vertices.size(), unset);
  for (std::uint32_t i = 0; i < mesh.exact.size(); ++i) exact_at[mesh.exact[i].vertex] = i;
  std::vector<std::vector<std::uint32_t>> faces(shells.count);
  for (std::uint32_t f = 0; f < shells.of_face.size(); ++f) faces[shells.of_face[f]].push_back(f);
  std::vector<std::uint32_t> number(mesh.mesh.vertices.size()), last_shell(mesh.mesh.vertices.size(), unset);
  for (std::uint32_t s = 0; s < shells.count; ++s) {
    ExactMesh& part = parts[s].mesh;
    for (const std::uint32_t f : faces[s]) {
      Triangle t = mesh.mesh.triangles[f];
      for (std::uint32_t& v : t) {
        if (last_shell[v] != s) {
          last_shell[v] = s;
          number[v] = static_cast<std::uint32_t>(part.mesh.vertices.size());
          if (!exact_at.empty() && exact_at[v] != unset)
            part.exact.push_back({number[v], mesh.exact[exact_at[v]].position});
          part.mesh.vertices.push_back(mesh.mesh.vertices[v]);
        }
        v = number[v];
      }
      part.mesh.triangles.push_back(t);
    }
  }
  tbb::parallel_for(std::uint32_t{0}, shells.count, [&](std::uint32_t s) {
    Part& part = parts[s];
    part.is_reversed = is_reversed(part.mesh);
    if (part.is_reversed)
      for (Triangle& t : part.mesh.mesh.triangles) std::swap(t[1], t[2]);
  });
  return parts;
}

/// The shells whose boxes overlap those of others.
std::vector<std::uint32_t> near_others(const std::vector<Part>& parts) {
  std::vector<Box> boxes(parts.size());
  for (std::size_t s = 0; s < parts.size(); ++s)
    for (const Vertex& v : parts[s].mesh.mesh.vertices) boxes[s].include(v);
  std::vector<std::uint32_t> found;
  for_each_overlapping_pair(boxes, [&](std::uint32_t a, std::uint32_t b) { found.insert(found.end(), {a, b}); });
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

/// Shells as operands: each is a solid, and none cross.
std::vector<std::int32_t> above_apart(ExactMeshView mesh, const Shells& shells, const Monitor& monitor) {
  const std::vector<Part> parts = parts_of(mesh, shells);
  std::vector<std::int32_t> above(shells.count);
  for (std::uint32_t s = 0; s < shells.count; ++s) above[s] = parts[s].is_reversed ? -1 : 0;
  const std::vector<std::uint32_t> near = near_others(parts);
  if (near.empty()) return above;
  InputComplex complex;
  for (const std::uint32_t s : near)
    complex.add(parts[s].mesh.mesh.vertices, parts[s].mesh.mesh.triangles, parts[s].mesh.exact);
  const Candidates candidates = find_candidates(std::move(complex), monitor);
  const InputComplex& input = candidates.input();
  const LocalWindings windings(input, candidates.cells());
  tbb::parallel_for(std::uint32_t{0}, static_cast<std::uint32_t>(near.size()), [&](std::uint32_t i) {
    monitor.check();
    const Point inside = make_point(input, SymbolicPoint::weighted(input.first_face(i), 1));
    for (const auto& [other, winding] : windings.around(inside, i))
      if (other != i) above[near[i]] += parts[near[other]].is_reversed ? -winding : winding;
  });
  return above;
}

/// Shells that share edges may not be closed.
std::vector<std::int32_t> above_joined(ExactMeshView mesh, const Shells& shells, const Monitor& monitor) {
  const Candidates candidates = find_candidates(complex_of(mesh), monitor);
  const InputComplex& input = candidates.input();
  const LocalWindings windings(input, candidates.cells());
  std::vector<std::uint32_t> first(shells.count, unset);
  for (std::uint32_t f = 0; f < shells.of_face.size(); ++f)
    if (first[shells.of_face[f]] == unset) first[shells.of_face[f]] = f;
  std::vector<std::int32_t> above(shells.count);
  tbb::parallel_for(std::uint32_t{0}, shells.count, [&](std::uint32_t s) {
    monitor.check();
    const Point inside = make_point(input, SymbolicPoint::weighted(first[s], 1));
    above[s] = windings.above(first[s], inside, {&first[s], 1})[0];
  });
  return above;
}

}  // namespace

std::vector<std::int32_t> windings_above(ExactMeshView mesh, const Shells& shells, const Monitor& monitor) {
  if (shells.share_edges) return above_joined(mesh, shells, monitor);
  if (shells.count == 1) return {is_reversed(mesh) ? -1 : 0};
  return above_apart(mesh, shells, monitor);
}

}  // namespace strata
