#pragma once
#include "core/overlap/filtered_face.h"
#include "extensions/contact/common_points.h"
#include "extensions/contact/parts.h"

namespace strata::contact {

/// True when no other face of the part of `face` contains the middle of some points. Requires that this middle is
/// inside of the face. O(log n) plus the faces near the points; rationals for those that doubles do not decide.
[[nodiscard]] bool is_sole_face(const Parts& parts, const FilteredFace& face, const CommonPoints& points);

}  // namespace strata::contact
