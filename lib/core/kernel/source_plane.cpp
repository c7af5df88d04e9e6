#include "core/kernel/source_plane.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/exact/big_integer.h"
#include "core/kernel/exact_evaluation.h"
#include "core/kernel/nearest.h"

namespace strata {
namespace {

/// A plane through constructed vertices gets back the small integers of the plane from which they come. Small planes
/// are not worth the search for a factor.
void divide_by_common_factor(HPlane<Integer>& p) {
  constexpr unsigned large = 300;
  if (bit_length(abs(p.d) + abs(p.a) + abs(p.b) + abs(p.c)) <= large) return;
  const Integer factor = gcd(gcd(p.a, p.b), gcd(p.c, p.d));
  for (Integer* x : {&p.a, &p.b, &p.c, &p.d}) *x /= factor;
}

void divide_by_powers_of_two(HPlane<Integer>& p) {
  std::size_t shift = std::numeric_limits<std::size_t>::max();
  for (const Integer* x : {&p.a, &p.b, &p.c, &p.d})
    if (*x != 0) shift = std::min(shift, trailing_zeros(*x));
  if (shift == 0) return;
  for (Integer* x : {&p.a, &p.b, &p.c, &p.d}) *x >>= shift;
}

/// x / 2^scale, where |x| < 2^scale.
DoubleDouble scaled(const Integer& x, std::size_t scale) {
  constexpr std::size_t kept = 120;
  const std::size_t lost = scale > kept ? scale - kept : 0;
  const Integer top = x >> lost;  // rounded down
  const double high = top.to_double();
  const Integer rest = top - Integer(high);
  const double low = rest.to_double();
  const int shift = static_cast<int>(lost) - static_cast<int>(scale);
  const double value = high + low;
  const double error = (lost != 0 ? 1.0 : 0.0) + std::abs(low) * Bounded::rounding;
  return {std::ldexp(value, shift), std::ldexp(low - (value - high), shift), std::ldexp(error, shift)};
}

template <class Real>
Real determinant(const RealPoint<Real>& p, const RealPoint<Real>& q, const RealPoint<Real>& r) {
  return dot<Real>(p, cross<Real>(q, r));
}

Integer minor(const Integer& a, const Integer& b, const Integer& c, const Integer& d) { return a * d - b * c; }

RealPoint<DoubleDouble> approximate_meet(const SourcePlane& p, const SourcePlane& q, const SourcePlane& r) {
  const auto c0 = cross<DoubleDouble>(q.normal(), r.normal()), c1 = cross<DoubleDouble>(r.normal(), p.normal()),
             c2 = cross<DoubleDouble>(p.normal(), q.normal());
  const DoubleDouble w = dot<DoubleDouble>(p.normal(), c0);
  const DoubleDouble d1 = dot<DoubleDouble>(q.normal(), q.at() - p.at()),
                     d2 = dot<DoubleDouble>(r.normal(), r.at() - p.at());
  RealPoint<DoubleDouble> x;
  for (std::size_t i = 0; i < 3; ++i) x[i] = p.at()[i] + (d1 * c1[i] + d2 * c2[i]) / w;
  return x;
}

}  // namespace

SourcePlane::SourcePlane(const HPlane<Integer>& plane, int unit, const RealPoint<DoubleDouble>& at)
    : exact_(plane), at_(at) {
  const auto shift = static_cast<unsigned>(std::abs(unit));
  if (unit > 0) exact_.d <<= shift;
  if (unit < 0)
    for (Integer* x : {&exact_.a, &exact_.b, &exact_.c}) *x <<= shift;
  divide_by_powers_of_two(exact_);
  divide_by_common_factor(exact_);
  const std::size_t scale = std::max({bit_length(exact_.a), bit_length(exact_.b), bit_length(exact_.c)});
  normal_ = {scaled(exact_.a, scale), scaled(exact_.b, scale), scaled(exact_.c, scale)};
  for (std::size_t i = 0; i < 3; ++i) {
    bounded_at_[i] = at_[i].bounded();
    bounded_normal_[i] = normal_[i].bounded();
  }
}

SourcePlane SourcePlane::reversed() const {
  SourcePlane r = *this;
  for (Integer* x : {&r.exact_.a, &r.exact_.b, &r.exact_.c, &r.exact_.d}) *x = -*x;
  for (std::size_t i = 0; i < 3; ++i) {
    r.normal_[i] = -r.normal_[i];
    r.bounded_normal_[i] = -r.bounded_normal_[i];
  }
  return r;
}

bool are_parallel(const SourcePlane& p, const SourcePlane& q) {
  for (const Bounded& x : cross<Bounded>(p.bounded_normal(), q.bounded_normal()))
    if (const auto sign = x.sign(); sign && *sign != Sign::zero) return false;
  const auto &f = p.exact(), &g = q.exact();
  return minor(f.b, f.c, g.b, g.c) == 0 && minor(f.c, f.a, g.c, g.a) == 0 && minor(f.a, f.b, g.a, g.b) == 0;
}

bool have_same_direction(const SourcePlane& p, const SourcePlane& q) {
  const auto &f = p.exact(), &g = q.exact();
  return f.a * g.a + f.b * g.b + f.c * g.c > 0;
}

bool are_independent(const SourcePlane& p, const SourcePlane& q, const SourcePlane& r) {
  const auto sign = determinant<Bounded>(p.bounded_normal(), q.bounded_normal(), r.bounded_normal()).sign();
  if (sign) return *sign != Sign::zero;
  const auto &f = p.exact(), &g = q.exact(), &h = r.exact();
  return f.a * minor(g.b, g.c, h.b, h.c) + f.b * minor(g.c, g.a, h.c, h.a) + f.c * minor(g.a, g.b, h.a, h.b) != 0;
}

HPoint<Integer> MeetOfPlanes::exact() const {
  const auto long_plane = [&](std::size_t i) {
    const HPlane<Integer>& p = planes[i]->exact();
    return HPlane<LongInt>{LongInt(p.a), LongInt(p.b), LongInt(p.c), LongInt(p.d)};
  };
  auto p = in_integers(meet(long_plane(0), long_plane(1), long_plane(2)));
  return p ? *std::move(p) : meet(planes[0]->exact(), planes[1]->exact(), planes[2]->exact());
}

MeetOfPlanes meet_of(const SourcePlane& p, const SourcePlane& q, const SourcePlane& r) {
  MeetOfPlanes meet{{&p, &q, &r}, approximate_meet(p, q, r)};
  const auto is_known = [](const DoubleDouble& x) {
    return std::isfinite(x.value) && x.error <= std::abs(x.value) * 0x1p-80 && x.rounds_to_value();
  };
  if (std::all_of(meet.at.begin(), meet.at.end(), is_known)) return meet;
  const HPoint<Integer> exact = meet.exact();
  for (std::size_t i = 0; i < 3; ++i) meet.at[i] = nearest_double_double(Rational(exact[static_cast<int>(i)], exact.w));
  return meet;
}

std::optional<std::array<double, 3>> exact_doubles(const MeetOfPlanes& meet) {
  for (const DoubleDouble& x : meet.at)
    if (std::abs(x.low) > x.error) return std::nullopt;
  const HPoint<Integer> exact = meet.exact();
  std::array<double, 3> r{};
  for (std::size_t i = 0; i < 3; ++i) {
    r[i] = meet.at[i].value;
    if (Rational(exact[static_cast<int>(i)], exact.w) != to_rational(r[i])) return std::nullopt;
  }
  return r;
}

}  // namespace strata
