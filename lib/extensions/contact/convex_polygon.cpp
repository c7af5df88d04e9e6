#include "extensions/contact/convex_polygon.h"

#include "core/kernel/filters.h"

namespace strata::contact {

ConvexPolygon::ConvexPolygon(std::vector<RationalPoint> corners)
    : corners_(std::move(corners)), normal_(cross<Rational>(corners_[1] - corners_[0], corners_[2] - corners_[0])) {
  for (std::size_t i = 0; i < corners_.size(); ++i)
    inward_.push_back(cross<Rational>(normal_, corners_[(i + 1) % corners_.size()] - corners_[i]));
}

bool ConvexPolygon::has(const RationalPoint& p) const {
  if (!dot<Rational>(normal_, p - corners_[0]).is_zero()) return false;
  for (std::size_t i = 0; i < corners_.size(); ++i)
    if (dot<Rational>(inward_[i], p - corners_[i]).sign() < 0) return false;
  return true;
}

std::optional<Interval> ConvexPolygon::part_of_line(const RationalPoint& p, const RationalPoint& d) const {
  if (!dot<Rational>(normal_, d).is_zero() || !dot<Rational>(normal_, p - corners_[0]).is_zero()) return std::nullopt;
  std::optional<Rational> from, to;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const Rational at_p = dot<Rational>(inward_[i], p - corners_[i]), along = dot<Rational>(inward_[i], d);
    if (along.is_zero()) {
      if (at_p.sign() < 0) return std::nullopt;
      continue;
    }
    const Rational t = -at_p / along;
    std::optional<Rational>& bound = along.sign() > 0 ? from : to;
    if (!bound || (along.sign() > 0 ? t > *bound : t < *bound)) bound = t;
  }
  if (*from >= *to) return std::nullopt;
  return Interval(*from, *to);
}

}  // namespace strata::contact
