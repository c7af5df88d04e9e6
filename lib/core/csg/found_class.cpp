#include "core/csg/found_class.h"

#include <tbb/parallel_for.h>

#include <exception>
#include <utility>
#include <vector>

#include "core/csg/inspection.h"
#include "core/mesh/prepare.h"

namespace strata {
namespace {

/// What keeps an operand from being a solid as it is.
struct Found {
  std::vector<Defect> notes;
  KnownCrossings crossings;
  std::optional<Prepared> prepared;
};

Found found_by(Inspection inspection, Prepared prepared) {
  std::vector<Defect> notes = inspection.defects(Severity::note, prepared.source_face);
  return {std::move(notes), std::move(inspection).take_crossings(), std::move(prepared)};
}

Found to_resolve(const Operand& operand, std::size_t number, Inspection::Keeps keeps, const Screening* facts,
                 const Monitor& monitor) {
  if (operand.is_checked || operand.mesh.triangles.empty()) return {};
  if (operand.exact.empty()) {
    FirstLook look = look_at(operand.mesh, monitor, keeps, facts);
    if (look.is_solid) return {{}, {}, look.unchanged()};
    if (look.all) return found_by(*std::move(look.all), look.unchanged());
  }
  Prepared prepared = prepare({operand.mesh, operand.exact}, Options{}, number);
  const ExactMeshView ready(prepared.mesh ? MeshView(*prepared.mesh) : operand.mesh, operand.exact);
  return found_by(Inspection(ready, monitor, keeps), std::move(prepared));
}

}  // namespace

// Operands are searched at the same time, so that what is serial of one goes with what is parallel of others. Of
// several errors, that of the first operand is thrown.
FoundClass find_class(std::span<const Operand> operands, const Monitor& monitor, const Screening* facts) {
  const auto keeps = operands.size() == 1 ? Inspection::Keeps::intersections : Inspection::Keeps::pairs;
  std::vector<Found> found_of(operands.size());
  std::vector<std::exception_ptr> errors(operands.size());
  tbb::parallel_for(std::size_t{0}, operands.size(), [&](std::size_t i) {
    try {
      found_of[i] = to_resolve(operands[i], i, keeps, facts, monitor);
    } catch (...) {
      errors[i] = std::current_exception();
    }
  });
  FoundClass found;
  for (std::size_t i = 0; i < operands.size(); ++i) {
    if (errors[i]) std::rethrow_exception(errors[i]);
    const std::vector<Defect>& notes = found_of[i].notes;
    if (!notes.empty()) found.input = InputClass::overlapping;
    found.notes.insert(found.notes.end(), notes.begin(), notes.end());
    found.known.prepared.push_back(std::move(found_of[i].prepared));
  }
  if (operands.size() == 1) found.known.crossings = std::move(found_of.front().crossings);
  return found;
}

}  // namespace strata
