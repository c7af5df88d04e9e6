#include "extensions/contact/common_points.h"

#include <algorithm>

namespace strata::contact {

CommonPoints common_points(const Carriers& carriers, const Meetings& meetings) {
  CommonPoints names;
  const auto add = [&](PointId id) {
    const auto is_known = [id](const EqualVertices& e) { return e.b == id; };
    if (std::any_of(meetings.equal.begin(), meetings.equal.end(), is_known)) return;
    const PointName name =
        id < carriers.vertex_count() ? PointName::input(id) : meetings.constructed[id - carriers.vertex_count()];
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  };
  for (const Constraint& c : meetings.constraints) {
    if (c.kind == ConstraintKind::coplanar) continue;
    add(c.tail);
    add(c.head);
  }
  return names;
}

}  // namespace strata::contact
