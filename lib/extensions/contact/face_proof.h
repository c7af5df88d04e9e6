#pragma once
#include <optional>

#include "core/kernel/input_complex.h"
#include "core/overlap/constraint.h"
#include "core/overlap/filtered_face.h"

namespace strata::contact {

/// Of two faces, those that must be the only ones of their parts around a point for what is said about it to hold.
struct SoleFaces {
  bool first = false, second = false;
  bool either = false;  ///< one of them is enough

  friend bool operator==(const SoleFaces&, const SoleFaces&) = default;
};

/// Faces of which one reaches below the other in a segment that runs inside of that one, or that lie on one another
/// looking the same way: the interiors of their solids meet around a point inside of what the faces share, if there the
/// solids have no other faces than is told. Nothing for other faces. theory.md, section 2.
[[nodiscard]] std::optional<SoleFaces> prove_interference(const InputComplex& input, const FilteredFace& f,
                                                          const FilteredFace& g,
                                                          const PairIntersections& intersections);

}  // namespace strata::contact
