#include "extensions/scene/sight.h"

#include "core/kernel/approximation.h"

namespace strata {

Sign Sight::turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const { return SightLine(*this, a, b).turn(c); }

Sign Sight::depth(const Corners& triangle, Sign turn_of_triangle, std::uint32_t vertex) const {
  // The origin is above the triangle where it is seen counter-clockwise.
  return -turn_of_triangle * orient3d(carriers_, triangle[0], triangle[1], triangle[2], vertex);
}

SightLine::SightLine(const Sight& sight, std::uint32_t a, std::uint32_t b)
    : sight_(sight),
      a_(a),
      b_(b),
      filtered_(sight.carriers().exact(a) == nullptr && sight.carriers().exact(b) == nullptr) {
  if (!filtered_) return;
  const Carriers& carriers = sight.carriers();
  const auto &p = carriers.vertex(a), &q = carriers.vertex(b);
  const Origin& o = sight.origin();
  plane_ = o.is_point() ? FilteredPlane(o.at, p, q) : FilteredPlane::along(q, p, o.at);
}

Sign SightLine::turn(std::uint32_t c) const {
  if (c == a_ || c == b_) return Sign::zero;
  const Carriers& carriers = sight_.carriers();
  if (filtered_) {
    const int side = carriers.exact(c) == nullptr ? plane_.side(carriers.vertex(c))
                                                  : plane_.side_within(approximate_vertex<Bounded>(carriers, c));
    if (side != 0) return side > 0 ? Sign::negative : Sign::positive;
  }
  const auto point = [&](std::uint32_t v) { return make_point(carriers, PointName::input(v)); };
  const Point p = point(a_), q = point(b_), r = point(c);
  const Origin& o = sight_.origin();
  // A far origin is infinitely far against the direction.
  return o.is_point() ? orient3d(carriers, p, q, r, Point::free(o.at)) : -normal_along(carriers, p, q, r, o.at);
}

}  // namespace strata
