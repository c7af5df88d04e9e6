#pragma once
#include <vector>

#include "core/cells/windings.h"
#include "strata/query.h"

namespace strata {

[[nodiscard]] WindingNumbers numbers_of(const Windings& windings);

/// The location of a point with these winding numbers, if it is off the surfaces, which lies on `faces` of the scene.
[[nodiscard]] Location location_of(Windings windings, std::vector<Contact> faces);

}  // namespace strata
