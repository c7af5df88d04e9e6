#include <numeric>
#include <utility>

#include "core/mesh/prepare.h"
#include "core/mesh/prepare_steps.h"
#include "core/mesh/zero_area.h"

namespace strata {
namespace {

Mesh copy_of(MeshView mesh) {
  return {{mesh.vertices.begin(), mesh.vertices.end()}, {mesh.triangles.begin(), mesh.triangles.end()}};
}

void number_sources(std::vector<std::uint32_t>& sources, std::size_t count) {
  sources.resize(count);
  std::iota(sources.begin(), sources.end(), 0U);
}

[[noreturn]] void refuse(MeshView mesh, std::size_t operand, const Monitor& monitor) {
  throw InputError(diagnose(mesh, few_defects, monitor), operand);
}

}  // namespace

Prepared prepare_closed(MeshView mesh, bool allow_inside_out, std::size_t operand, const Monitor& monitor) {
  Prepared result;
  if (mesh.triangles.empty()) return result;
  Screening facts = screen(mesh, monitor);
  if (!facts.finite || !facts.indices_valid) refuse(mesh, operand, monitor);
  if (!facts.chain_closed) {
    Mesh welded = copy_of(mesh);
    const std::uint64_t count = weld(welded.vertices, welded.triangles, monitor);
    facts = screen(welded, monitor);
    if (!facts.chain_closed) refuse(mesh, operand, monitor);
    result.notes.push_back(weld_note(count));
    number_sources(result.source_face, welded.triangles.size());
    result.mesh = std::move(welded);
  }
  result.bounds = facts.bounds;
  if (facts.orientation < 0 && !allow_inside_out) refuse(mesh, operand, monitor);
  if (facts.degenerate) {
    if (!result.mesh) {
      result.mesh = copy_of(mesh);
      number_sources(result.source_face, mesh.triangles.size());
    }
    SourcedTriangles faces{std::move(result.mesh->triangles), std::move(result.source_face)};
    result.notes.push_back(removal_note(mesh, remove_zero_area(result.mesh->vertices, faces, monitor)));
    result.mesh->triangles = std::move(faces.triangles);
    result.source_face = std::move(faces.sources);
  }
  return result;
}

}  // namespace strata
