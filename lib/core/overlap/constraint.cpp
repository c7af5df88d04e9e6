#include "core/overlap/constraint.h"

namespace strata {

PointId PairIntersections::number(const InputComplex& input, const SymbolicPoint& name) {
  if (name.kind == SymbolicPoint::Kind::input) return name.id[0];
  constexpr std::size_t last_few = 8;
  const std::size_t size = constructed.size();
  std::size_t i = size - std::min(size, last_few);
  while (i < size && constructed[i] != name) ++i;
  if (i == size) constructed.push_back(name);
  return input.vertex_count() + static_cast<PointId>(i);
}

}  // namespace strata
