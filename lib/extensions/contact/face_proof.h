#pragma once
#include <optional>

#include "core/kernel/input_complex.h"
#include "core/overlap/constraint.h"
#include "core/overlap/filtered_face.h"

namespace strata::contact {

/// Of two faces, those that must be the only faces of their parts around a point for a proof to hold.
struct SoleFaces {
  bool first = false, second = false;
  bool either = false;  ///< one of them suffices

  friend bool operator==(const SoleFaces&, const SoleFaces&) = default;
};

/// The proof of interference by two faces: one reaches below the other in a segment in the other's interior, or they
/// overlap with the same orientation. Then the interiors of their solids meet around an interior point of the faces'
/// intersection, if the solids have no other faces there than the result permits. Nullopt for other faces. theory.md,
/// section 2.
[[nodiscard]] std::optional<SoleFaces> prove_interference(const InputComplex& input, const FilteredFace& f,
                                                          const FilteredFace& g,
                                                          const PairIntersections& intersections);

}  // namespace strata::contact
