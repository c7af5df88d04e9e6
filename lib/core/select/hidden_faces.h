#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/kernel/input_complex.h"
#include "core/overlap/constraint.h"
#include "core/select/rule.h"
#include "strata/options.h"

namespace strata {

/// The faces, in order, that meet coplanar faces only and of which the rule keeps nothing. `met`: what faces meet,
/// where coplanar pairs are listed and not intersected. Faces all of whose partners have their own vertices may be
/// missing. Requires solids. theory.md, "Covered faces". O(n log n) in the number of coplanar pairs. Throws Cancelled.
[[nodiscard]] std::vector<std::uint32_t> find_hidden_faces(const InputComplex& input,
                                                           std::span<const PairIntersections> met, const Rule& rule,
                                                           const Monitor& monitor);

}  // namespace strata
