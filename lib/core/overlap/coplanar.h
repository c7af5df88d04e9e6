#pragma once
#include <cstdint>

#include "core/kernel/input_complex.h"
#include "core/overlap/constraint.h"
#include "core/overlap/filtered_face.h"

namespace strata {

/// meet_faces for two faces in one plane: every edge of either face, clipped to the other, becomes a constraint there.
bool meet_coplanar_faces(const InputComplex& input, const FilteredFace& f, const FilteredFace& g,
                         PairIntersections& intersections);

/// meet_faces for two faces with the same three vertices: each covers the other.
bool meet_same_face(std::uint32_t f, const InputComplex::Indices& vf, std::uint32_t g, const InputComplex::Indices& vg,
                    PairIntersections& intersections);

}  // namespace strata
