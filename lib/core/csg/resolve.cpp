#include "strata/resolve.h"

#include <array>
#include <optional>
#include <utility>

#include "core/csg/arena.h"
#include "core/csg/boolean.h"
#include "core/csg/found_class.h"
#include "core/csg/solid_data.h"
#include "core/mesh/prepare.h"

namespace strata {
namespace {

bool has_negative_volume(ExactMeshView mesh, const Screening& facts) {
  if (!facts.finite || !facts.indices_valid || !facts.chain_closed) return false;
  return mesh.exact.empty() ? facts.orientation < 0 : orientation(mesh) == Sign::negative;
}

/// What an `automatic` operand turns out to be; notes of others come from the operation.
FoundClass class_of(const Operand& operand, const Options& options, const Screening* facts) {
  if (options.input != InputClass::automatic) return {options.input, {}, {}};
  return find_class({&operand, 1}, Monitor(options.cancel), facts);
}

/// Turns a mesh of negative volume round, which has the negative winding numbers then: odd where they were odd, and not
/// 0 where they were. Returns what is known of it.
Screening turned_outwards(ExactMesh& mesh, const Monitor& monitor) {
  Screening facts = screen(mesh.mesh, monitor);
  if (!has_negative_volume(mesh, facts)) return facts;
  for (Triangle& t : mesh.mesh.triangles) std::swap(t[1], t[2]);
  facts.orientation = -facts.orientation;
  return facts;
}

}  // namespace

Solid resolve(ExactMesh mesh, Inside inside, const Options& options) {
  Options now = options;
  now.exact_vertices = true;
  now.measure = false;
  FoundClass found;
  const std::array operand{Operand{mesh.mesh, mesh.exact}};
  arena_for(options, worth_in_faces(operand, options.input)).execute([&] {
    std::optional<Screening> facts;
    if (inside != Inside::winding) facts = turned_outwards(mesh, Monitor(options.cancel));
    found = class_of(operand.front(), options, facts ? &*facts : nullptr);
  });
  now.input = found.input;
  BooleanResult result;
  arena_for(options, worth_in_faces(operand, found.input)).execute([&] {
    result = boolean(Rule::of_one(inside), operand, now, std::move(found.known));
  });
  result.notes.insert(result.notes.begin(), found.notes.begin(), found.notes.end());
  Solid solid(Shared<Solid::Data>::make(Solid::Data{
      {std::move(result.mesh), std::move(result.exact)}, std::move(result.sources), std::move(result.notes)}));
  return inside == Inside::outer ? solid.without_cavities(options) : solid;
}

}  // namespace strata
