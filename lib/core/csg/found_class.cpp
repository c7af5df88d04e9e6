#include "core/csg/found_class.h"

#include <utility>

#include "core/csg/inspection.h"
#include "core/mesh/equal_vertices.h"
#include "core/mesh/prepare.h"

namespace strata {
namespace {

/// What keeps an operand from being a solid as it is.
std::vector<Defect> to_resolve(const Operand& operand, std::size_t number, const Monitor& monitor) {
  if (operand.is_checked || operand.mesh.triangles.empty()) return {};
  if (operand.exact.empty() && is_plainly_solid(operand.mesh, monitor)) return {};
  const Prepared prepared = prepare({operand.mesh, operand.exact}, InputClass::automatic, number);
  const ExactMeshView ready(prepared.mesh ? MeshView(*prepared.mesh) : operand.mesh, operand.exact);
  const std::vector<Triangle> triangles = on_first_vertices(ready);
  return Inspection({{ready.mesh.vertices, triangles}, operand.exact}, monitor)
      .defects(Severity::note, prepared.source_face);
}

}  // namespace

FoundClass find_class(std::span<const Operand> operands, const Monitor& monitor) {
  FoundClass found;
  for (std::size_t i = 0; i < operands.size(); ++i) {
    const std::vector<Defect> notes = to_resolve(operands[i], i, monitor);
    if (!notes.empty()) found.input = InputClass::overlapping;
    found.notes.insert(found.notes.end(), notes.begin(), notes.end());
  }
  return found;
}

}  // namespace strata
