#include "extensions/contact/common_points.h"

#include <algorithm>

namespace strata::contact {

CommonPoints common_points(const InputComplex& input, const PairIntersections& intersections) {
  CommonPoints names;
  const auto add = [&](PointId id) {
    const auto is_known = [id](const EqualVertices& e) { return e.b == id; };
    if (std::any_of(intersections.equal.begin(), intersections.equal.end(), is_known)) return;
    const SymbolicPoint name =
        id < input.vertex_count() ? SymbolicPoint::input(id) : intersections.constructed[id - input.vertex_count()];
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  };
  for (const Constraint& c : intersections.constraints) {
    if (c.kind == ConstraintKind::coplanar) continue;
    add(c.tail);
    add(c.head);
  }
  return names;
}

}  // namespace strata::contact
