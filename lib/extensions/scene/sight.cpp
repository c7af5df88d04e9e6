#include "extensions/scene/sight.h"

#include "core/kernel/approximation.h"

namespace strata {

Sign Sight::orientation(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
  return SightLine(*this, a, b).orientation(c);
}

Sign Sight::depth(const Corners& triangle, Sign orientation_of_triangle, std::uint32_t vertex) const {
  // The origin is above the triangle where it is seen counter-clockwise.
  return -orientation_of_triangle * orient3d(input_, triangle[0], triangle[1], triangle[2], vertex);
}

SightLine::SightLine(const Sight& sight, std::uint32_t a, std::uint32_t b)
    : sight_(sight), a_(a), b_(b), filtered_(sight.input().exact(a) == nullptr && sight.input().exact(b) == nullptr) {
  if (!filtered_) return;
  const InputComplex& input = sight.input();
  const auto &p = input.vertex(a), &q = input.vertex(b);
  const Origin& o = sight.origin();
  plane_ = o.is_point() ? FilteredPlane(o.at, p, q) : FilteredPlane::along(q, p, o.at);
}

Sign SightLine::orientation(std::uint32_t c) const {
  if (c == a_ || c == b_) return Sign::zero;
  const InputComplex& input = sight_.input();
  if (filtered_) {
    const int side = input.exact(c) == nullptr ? plane_.side(input.vertex(c))
                                               : plane_.side_within(approximate_vertex<Bounded>(input, c));
    if (side != 0) return side > 0 ? Sign::negative : Sign::positive;
  }
  const auto point = [&](std::uint32_t v) { return make_point(input, SymbolicPoint::input(v)); };
  const Point p = point(a_), q = point(b_), r = point(c);
  const Origin& o = sight_.origin();
  // An origin at infinity is infinitely far against the direction.
  return o.is_point() ? orient3d(input, p, q, r, Point::free(o.at)) : -normal_along(input, p, q, r, o.at);
}

}  // namespace strata
