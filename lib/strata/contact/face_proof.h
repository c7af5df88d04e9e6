#pragma once
#include "strata/kernel/carriers.h"
#include "strata/overlap/constraint.h"
#include "strata/overlap/filtered_face.h"

namespace strata::contact {

/// True when two faces, and what they share, prove by themselves that the interiors of their solids meet: one reaches
/// below the other in a segment that runs inside of that one, or they lie on one another looking the same way.
/// theory.md, section 2.
[[nodiscard]] bool prove_interference(const Carriers& carriers, const FilteredFace& f, const FilteredFace& g,
                                      const Meetings& meetings);

}  // namespace strata::contact
