#include "strata/resolve.h"

#include <utility>

#include "core/csg/arena.h"
#include "core/csg/boolean.h"
#include "core/csg/found_class.h"
#include "core/csg/solid_data.h"
#include "core/mesh/prepare.h"

namespace strata {
namespace {

bool has_negative_volume(ExactMeshView mesh) {
  const Screening facts = screen(mesh.mesh);
  if (!facts.finite || !facts.indices_valid || !facts.chain_closed) return false;
  return mesh.exact.empty() ? facts.orientation < 0 : orientation(mesh) == Sign::negative;
}

/// What `automatic` operands turn out to be; notes of others come from the operation.
FoundClass class_of(const Operand& operand, const Options& options) {
  if (options.input != InputClass::automatic) return {options.input, {}};
  return find_class({&operand, 1}, Monitor(options.cancel));
}

}  // namespace

Solid resolve(ExactMesh mesh, Inside inside, const Options& options) {
  BooleanResult result;
  arena_for(options, mesh.mesh.triangles.size()).execute([&] {
    // Reversed as a whole, a mesh has the negative winding numbers: odd where they were odd, and not 0 where they were.
    if (inside != Inside::winding && has_negative_volume(mesh))
      for (Triangle& t : mesh.mesh.triangles) std::swap(t[1], t[2]);
    const Operand operand{mesh.mesh, mesh.exact};
    FoundClass found = class_of(operand, options);
    Options now = options;
    now.input = found.input;
    now.exact_vertices = true;
    now.measure = false;
    result = boolean(Rule::of_one(inside), {&operand, 1}, now);
    result.notes.insert(result.notes.begin(), found.notes.begin(), found.notes.end());
  });
  Solid solid(Shared<Solid::Data>::make(Solid::Data{
      {std::move(result.mesh), std::move(result.exact)}, std::move(result.sources), std::move(result.notes)}));
  return inside == Inside::outer ? solid.without_cavities(options) : solid;
}

}  // namespace strata
