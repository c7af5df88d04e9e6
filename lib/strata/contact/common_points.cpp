#include "strata/contact/common_points.h"

#include <algorithm>

#include "strata/kernel/predicates.h"

namespace strata::contact {

CommonPoints common_points(const Carriers& carriers, const Meetings& meetings) {
  CommonPoints names;
  const auto add = [&](PointId id) {
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

namespace {

/// True when names stand for three places at least.
bool are_three_places(const Carriers& carriers, const CommonPoints& names) {
  boost::container::static_vector<Point, 3> places;
  for (const PointName& name : names) {
    const Point p = make_point(carriers, name);
    if (std::any_of(places.begin(), places.end(), [&](const Point& q) { return equal(carriers, p, q); })) continue;
    if (places.size() == 2) return true;
    places.push_back(p);
  }
  return false;
}

}  // namespace

bool proves_interference(const Carriers& carriers, const Meetings& meetings) {
  const Constraint& c = meetings.constraints.front();
  if (are_coplanar(meetings))
    return same_orientation(carriers, c.face, c.other) == Sign::positive &&
           are_three_places(carriers, common_points(carriers, meetings));
  return c.kind != ConstraintKind::point && !c.line.edge;
}

}  // namespace strata::contact
