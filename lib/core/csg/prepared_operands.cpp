#include "core/csg/prepared_operands.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "strata/monitor.h"

namespace strata {

PreparedOperands::PreparedOperands(std::span<const Operand> given, const Options& options,
                                   std::vector<std::optional<Prepared>> known)
    : given_(given), input_(options.input) {
  prepared_.reserve(given.size());
  for (std::size_t i = 0; i < given.size(); ++i) {
    Monitor(options.cancel).check();
    const Operand& operand = given[i];
    if (!known.empty() && known[i]) {
      prepared_.push_back(*std::move(known[i]));
      continue;
    }
    const bool is_known = operand.is_checked && !operand.exact.empty();
    prepared_.push_back(is_known ? Prepared{} : prepare({operand.mesh, operand.exact}, options, i));
  }
}

InputComplex PreparedOperands::complex() const {
  InputComplex complex(input_ == InputClass::solid ? SelfIntersections::none : SelfIntersections::possible);
  for (std::size_t i = 0; i < given_.size(); ++i) {
    const MeshView mesh = prepared_[i].mesh ? MeshView(*prepared_[i].mesh) : given_[i].mesh;
    complex.add(mesh.vertices, mesh.triangles, given_[i].exact, prepared_[i].bounds);
  }
  return complex;
}

std::vector<Defect> PreparedOperands::notes() const {
  std::vector<Defect> notes;
  for (const Prepared& p : prepared_) notes.insert(notes.end(), p.notes.begin(), p.notes.end());
  return notes;
}

void PreparedOperands::restore(std::vector<Source>& sources) const {
  const auto is_renumbered = [](const Prepared& p) { return !p.source_face.empty(); };
  if (std::none_of(prepared_.begin(), prepared_.end(), is_renumbered)) return;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, sources.size(), 1 << 13), [&](const auto& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) {
      const auto& renumbered = prepared_[sources[i].operand].source_face;
      if (!renumbered.empty()) sources[i].face = renumbered[sources[i].face];
    }
  });
}

}  // namespace strata
