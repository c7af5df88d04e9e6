#pragma once
#include <cstdint>

#include "strata/kernel/carriers.h"
#include "strata/overlap/constraint.h"

namespace strata {

/// meet_faces for two faces in one plane: every edge of either, clipped to the other, becomes a constraint there.
bool meet_coplanar_faces(const Carriers& carriers, std::uint32_t f, std::uint32_t g, Meetings& meetings);

}  // namespace strata
