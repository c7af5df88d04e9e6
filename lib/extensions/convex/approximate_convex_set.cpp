#include "extensions/convex/approximate_convex_set.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/exact/bounded.h"

namespace strata::convex {
namespace {

/// An interval that contains every coordinate which rounds to this double.
Bounded rounded(double x) { return {x, std::abs(x) * Bounded::rounding + Bounded::underflow}; }

/// The coordinate along a direction that is exact.
Bounded along(const Vertex& direction, const Vertex& rounded_point) {
  Bounded sum;
  for (std::size_t i = 0; i < 3; ++i) sum = sum + Bounded(direction[i]) * rounded(rounded_point[i]);
  return sum;
}

/// Is x outside of one of the half-spaces of a, translated by any point of b?
bool is_beyond(std::span<const ApproximateConvexSet::HalfSpace> of_a, std::span<const Vertex> points_of_b,
               const Vertex& x) {
  return std::any_of(of_a.begin(), of_a.end(), [&](const ApproximateConvexSet::HalfSpace& h) {
    const Bounded place = along(h.direction, x) - h.reach;
    return std::all_of(points_of_b.begin(), points_of_b.end(),
                       [&](const Vertex& b) { return (place - along(h.direction, b)).sign() == Sign::positive; });
  });
}

}  // namespace

std::optional<Sign> rounded_side(const Vertex& p, const Vertex& q, const Vertex& r, const Vertex& x) {
  const auto from_p = [&](const Vertex& to, std::size_t i) { return rounded(to[i]) - rounded(p[i]); };
  Bounded height;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    height = height + (from_p(q, j) * from_p(r, k) - from_p(q, k) * from_p(r, j)) * from_p(x, i);
  }
  return height.sign();
}

void ApproximateConvexSet::add_facet(const Vertex& p, const Vertex& q, const Vertex& r) {
  const Vertex u{q[0] - p[0], q[1] - p[1], q[2] - p[2]}, v{r[0] - p[0], r[1] - p[1], r[2] - p[2]};
  HalfSpace h{{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]},
              -std::numeric_limits<double>::infinity()};
  for (const Vertex& b : points_) {
    const double upper = along(h.direction, b).upper();
    if (std::isnan(upper)) return;
    h.reach = std::max(h.reach, upper);
  }
  half_spaces_.push_back(h);
}

bool sum_misses(const ApproximateConvexSet& a, const ApproximateConvexSet& b, const Vertex& x) {
  return is_beyond(a.half_spaces_, b.points_, x) || is_beyond(b.half_spaces_, a.points_, x);
}

}  // namespace strata::convex
