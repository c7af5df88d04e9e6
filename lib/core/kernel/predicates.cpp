#include "core/kernel/predicates.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <initializer_list>
#include <optional>

#include "core/exact/double_double.h"
#include "core/kernel/approximation.h"
#include "core/kernel/counters.h"
#include "core/kernel/exact_evaluation.h"
#include "core/kernel/exact_steps.h"
#include "core/kernel/filtered_plane.h"
#include "core/kernel/filters.h"
#include "core/kernel/structural_zeros.h"

namespace strata {
namespace {

/// Sign of an integer of any size; `ask(null)` evaluates it in a type: LongInt where the value fits, Integer otherwise.
template <class Ask>
Sign sign_of_any_size(Tier tier, const Ask& ask) {
  const LongInt value = ask(static_cast<const LongInt*>(nullptr));
  count(value.is_lost() ? Tier::unbounded : tier);
  return value.is_lost() ? sign_of_integer(Integer(ask(static_cast<const Integer*>(nullptr)))) : value.sign();
}

/// Sign of an integer; `ask(null)` evaluates it in the smallest type with `bits` bits.
template <class Ask>
Sign sign_in_bits(int bits, const Ask& ask) {
  const auto sign = [&]<class Int>(Tier tier, const Int* type) {
    count(tier);
    return sign_of_integer(Int(ask(type)));
  };
  if (bits <= 128) return sign(Tier::bits_128, static_cast<const WideInt<2>*>(nullptr));
  if (bits <= 256) return sign(Tier::bits_256, static_cast<const WideInt<4>*>(nullptr));
  return sign_of_any_size(bits <= 512 ? Tier::bits_512 : bits <= 1024 ? Tier::bits_1024 : Tier::bits_4096, ask);
}

/// Bits for a value of `width` bits and its sign, from integers of a lattice, which are shifted in limbs.
int bits_for(int width, const Lattice& lattice) { return std::max(width + 1, lattice.bits() + 65); }

/// Evaluates a sign in exact integers that are wide enough. `width(b)` is the number of bits on a lattice of b bits;
/// one more holds the sign.
template <class Width, class Question>
Sign decide(const InputComplex& input, std::initializer_list<const Point*> points, const Width& width,
            const Question& question) {
  const Ground ground(input, {points.begin(), points.size()});
  const Lattice& lattice = ground.lattice();
  const auto ask = [&]<class Int>(const Int*) { return Int(question(ExactEvaluation<Int>(input, lattice))); };
  if (ground.rational()) return sign_of_any_size(Tier::bits_4096, ask);
  return sign_in_bits(bits_for(width(lattice.bits()), lattice), ask);
}

std::optional<Sign> filtered(const Bounded& value) {
  const auto s = value.sign();
  if (s) count(Tier::filter);
  return s;
}

std::optional<Sign> filtered(const DoubleDouble& value) {
  const auto s = value.bounded().sign();
  if (s && *s != Sign::zero) {
    count(Tier::double_double);
    return s;
  }
  return std::nullopt;
}

template <class Real>
Real side_of(const ApproximatePlane<Real>& plane, const RealPoint<Real>& p) {
  return dot<Real>(plane.normal, p - plane.at);
}

Point input_point(const InputComplex& input, std::uint32_t v) { return make_point(input, SymbolicPoint::input(v)); }

/// FilteredPlane, and structural zeros of doubles.
std::optional<Sign> filtered_orient3d(const InputComplex::Coordinates& a, const InputComplex::Coordinates& b,
                                      const InputComplex::Coordinates& c, const InputComplex::Coordinates& d) {
  if (const int side = FilteredPlane(a, b, c).side(d); side != 0) return side > 0 ? Sign::positive : Sign::negative;
  if (show_common_plane(a, b, c, d)) return Sign::zero;
  return std::nullopt;
}

/// orient3d_in_exact_steps, counted.
std::optional<Sign> stepwise_orient3d(const InputComplex::Coordinates& a, const InputComplex::Coordinates& b,
                                      const InputComplex::Coordinates& c, const InputComplex::Coordinates& d) {
  const auto sign = orient3d_in_exact_steps(a, b, c, d);
  if (sign) count(Tier::steps);
  return sign;
}

/// filtered_orientation, and structural zeros of doubles.
std::optional<Sign> orientation_in_doubles(const PlanePoint& p, const PlanePoint& q, const PlanePoint& r) {
  if (const int orientation = filtered_orientation(p, q, r); orientation != 0) return static_cast<Sign>(orientation);
  if (show_common_line(p, q, r)) return Sign::zero;
  return std::nullopt;
}

/// orientation_by_differences, counted.
std::optional<Sign> differing(const PlanePoint& p, const PlanePoint& q, const PlanePoint& r) {
  const auto sign = orientation_by_differences(p, q, r);
  if (sign) count(Tier::double_double);
  return sign;
}

/// Each product has a relative error of at most 3u + 3u^2, each difference of u; the sum of n of them adds n u. The
/// constant is twice that and leaves room for rounding the magnitude. Products that underflow are off by 2^-1075, which
/// is far below the bound where magnitudes reach 2^-900.
std::optional<Sign> filtered_area(std::span<const PlanePoint> polygon) {
  const auto [x, y] = polygon[0];
  double value = 0, magnitude = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const auto &p = polygon[i], &q = polygon[i + 1];
    const double left = (p[0] - x) * (q[1] - y), right = (p[1] - y) * (q[0] - x);
    value += left - right;
    magnitude += std::abs(left) + std::abs(right);
  }
  const double bound = (static_cast<double>(polygon.size()) + 8) * 0x1p-52 * magnitude;
  if (magnitude > 0x1p-900 && value > bound) return Sign::positive;
  if (magnitude > 0x1p-900 && -value > bound) return Sign::negative;
  return std::nullopt;
}

InputComplex::Coordinates values(const Point& p) { return {p.at[0].value, p.at[1].value, p.at[2].value}; }

bool is_exact_in(Projection axes, const Point& p) {
  return p.at[static_cast<std::size_t>(axes.u)].error == 0 && p.at[static_cast<std::size_t>(axes.v)].error == 0;
}

PlanePoint seen(Projection axes, const Point& p) {
  return {p.at[static_cast<std::size_t>(axes.u)].value, p.at[static_cast<std::size_t>(axes.v)].value};
}

bool is_exact(const Point& p) { return p.at[0].error == 0 && p.at[1].error == 0 && p.at[2].error == 0; }

/// The tiers after doubles: double-doubles, then integers.
Sign refined_orient3d(const InputComplex& input, const Point& p, const Point& q, const Point& r, const Point& s) {
  if (show_common_plane(p.fine, q.fine, r.fine, s.fine)) {
    count(Tier::double_double);
    return Sign::zero;
  }
  if (const auto sign = filtered(orient3d_of(p.fine, q.fine, r.fine, s.fine))) return *sign;
  const auto width = [&](int b) {
    return width_of_value(width_of_plane(width_of(p.name, b), width_of(q.name, b), width_of(r.name, b)),
                          width_of(s.name, b));
  };
  return decide(input, {&p, &q, &r, &s}, width, [&](const auto& exact) {
    return value_at(plane_through(exact.point(p), exact.point(q), exact.point(r)), exact.point(s));
  });
}

}  // namespace

Sign orient3d(const InputComplex& input, const Point& p, const Point& q, const Point& r, const Point& s) {
  if (is_exact(p) && is_exact(q) && is_exact(r) && is_exact(s)) {
    const auto a = values(p), b = values(q), c = values(r), d = values(s);
    if (const auto sign = filtered_orient3d(a, b, c, d)) {
      count(Tier::filter);
      return *sign;
    }
    if (const auto sign = stepwise_orient3d(a, b, c, d)) return *sign;
  } else if (is_exact(p) && is_exact(q) && is_exact(r)) {
    if (const int side = FilteredPlane(values(p), values(q), values(r)).side_within(s.at); side != 0) {
      count(Tier::filter);
      return static_cast<Sign>(side);
    }
  } else if (const auto sign = filtered(orient3d_of(p.at, q.at, r.at, s.at))) {
    return *sign;
  }
  return refined_orient3d(input, p, q, r, s);
}

Sign orient3d(const InputComplex::Coordinates& a, const InputComplex::Coordinates& b,
              const InputComplex::Coordinates& c, const InputComplex::Coordinates& d) {
  if (const auto sign = filtered_orient3d(a, b, c, d)) {
    count(Tier::filter);
    return *sign;
  }
  if (const auto sign = stepwise_orient3d(a, b, c, d)) return *sign;
  return refined_orient3d(InputComplex(), Point::free(a), Point::free(b), Point::free(c), Point::free(d));
}

Sign orient3d(const InputComplex& input, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  const bool are_doubles = input.has_doubles({a, b, c}) && input.has_doubles(d);
  if (are_doubles) {
    if (const auto sign = filtered_orient3d(input.vertex(a), input.vertex(b), input.vertex(c), input.vertex(d))) {
      count(Tier::filter);
      return *sign;
    }
  }
  if (a == d || b == d || c == d || a == b || b == c || a == c) {
    count(Tier::names);
    return Sign::zero;
  }
  if (are_doubles)
    if (const auto sign = stepwise_orient3d(input.vertex(a), input.vertex(b), input.vertex(c), input.vertex(d)))
      return *sign;
  const Point p = input_point(input, a), q = input_point(input, b), r = input_point(input, c),
              s = input_point(input, d);
  return are_doubles ? refined_orient3d(input, p, q, r, s) : orient3d(input, p, q, r, s);
}

Sign normal_along(const InputComplex& input, const Point& p, const Point& q, const Point& r,
                  const InputComplex::Coordinates& direction) {
  const BoundedPoint d{direction[0], direction[1], direction[2]};
  if (const auto sign = filtered(dot<Bounded>(cross<Bounded>(q.at - p.at, r.at - p.at), d))) return *sign;
  const RealPoint<DoubleDouble> fine{direction[0], direction[1], direction[2]};
  if (const auto sign = filtered(dot<DoubleDouble>(cross<DoubleDouble>(q.fine - p.fine, r.fine - p.fine), fine)))
    return *sign;
  // The direction has a lattice of its own: its unit is a positive factor.
  Lattice own;
  for (const double x : direction) own.add(x);
  const auto width = [&](int b) {
    const int normal = width_of_plane(width_of(p.name, b), width_of(q.name, b), width_of(r.name, b)).abc;
    return std::max(normal + own.bits() + 2, own.bits() + 65);
  };
  return decide(input, {&p, &q, &r}, width, [&](const auto& exact) {
    const auto plane = plane_through(exact.point(p), exact.point(q), exact.point(r));
    using Int = std::decay_t<decltype(plane.a)>;
    const auto along = [&](double x) { return own.integer<Int>(x); };
    return Int(plane.a * along(direction[0]) + plane.b * along(direction[1]) + plane.c * along(direction[2]));
  });
}

std::optional<Sign> filtered_side_of_face(const InputComplex& input, std::uint32_t face, const Point& p) {
  const auto v = input.face(face);
  if (named_on_face(p.name, face, v)) {
    count(Tier::names);
    return Sign::zero;
  }
  if (!input.has_doubles(v)) {
    const auto sign = side_of(approximate_plane<Bounded>(input, face), p.at).sign();
    if (sign) count(Tier::filter);
    return sign;
  }
  const FilteredPlane plane(input.vertex(v[0]), input.vertex(v[1]), input.vertex(v[2]));
  const int side = plane.side_within(p.at);
  if (side == 0) return std::nullopt;
  count(Tier::filter);
  return static_cast<Sign>(side);
}

Sign side_of_face(const InputComplex& input, std::uint32_t face, const Point& p) {
  if (const auto sign = filtered_side_of_face(input, face, p)) return *sign;
  if (input.source_plane(face) != nullptr) {
    if (const auto sign = filtered(side_of(approximate_plane<DoubleDouble>(input, face), p.fine))) return *sign;
    const Point* const one[] = {&p};
    const Ground ground(input, one);
    return sign_of_any_size(Tier::bits_4096, [&]<class Int>(const Int*) {
      const ExactEvaluation<Int> exact(input, ground.lattice());
      return Int(value_at(exact.face(face), exact.point(p)));
    });
  }
  const auto v = input.face(face);
  return orient3d(input, input_point(input, v[0]), input_point(input, v[1]), input_point(input, v[2]), p);
}

std::optional<Sign> filtered_orient2d(Projection projection, const Point& p, const Point& q, const Point& r) {
  if (is_exact_in(projection, p) && is_exact_in(projection, q) && is_exact_in(projection, r)) {
    const auto s = orientation_in_doubles(seen(projection, p), seen(projection, q), seen(projection, r));
    if (s) count(Tier::filter);
    return s;
  }
  return filtered(orientation_of(p.at, q.at, r.at, projection.u, projection.v));
}

std::optional<Sign> refined_orient2d(Projection projection, const Point& p, const Point& q, const Point& r) {
  if (is_exact_in(projection, p) && is_exact_in(projection, q) && is_exact_in(projection, r))
    if (const auto sign = differing(seen(projection, p), seen(projection, q), seen(projection, r))) return sign;
  const auto fine = [&](const Point& x) {
    return std::array{x.fine[static_cast<std::size_t>(projection.u)], x.fine[static_cast<std::size_t>(projection.v)]};
  };
  if (show_common_line(fine(p), fine(q), fine(r))) {
    count(Tier::double_double);
    return Sign::zero;
  }
  return filtered(orientation_of(p.fine, q.fine, r.fine, projection.u, projection.v));
}

Sign exact_orient2d(const InputComplex& input, Projection projection, const Point& p, const Point& q, const Point& r) {
  // Where the relevant coordinates are doubles, the defining features of the point do not matter.
  const auto simplest = [&](const Point& x) {
    if (!is_exact_in(projection, x)) return x;
    InputComplex::Coordinates flat{};
    for (const int axis : {projection.u, projection.v})
      flat[static_cast<std::size_t>(axis)] = x.at[static_cast<std::size_t>(axis)].value;
    return Point::free(flat);
  };
  const Point a = simplest(p), b = simplest(q), c = simplest(r);
  const auto width = [&](int bits) {
    return width_of_orientation(width_of(a.name, bits), width_of(b.name, bits), width_of(c.name, bits));
  };
  return decide(input, {&a, &b, &c}, width, [&](const auto& exact) {
    return orientation(exact.point(a), exact.point(b), exact.point(c), projection.u, projection.v);
  });
}

Sign orient2d(const InputComplex& input, Projection projection, const Point& p, const Point& q, const Point& r) {
  if (const auto sign = filtered_orient2d(projection, p, q, r)) return *sign;
  if (const auto sign = refined_orient2d(projection, p, q, r)) return *sign;
  return exact_orient2d(input, projection, p, q, r);
}

Sign orient2d(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
  if (const auto sign = orientation_in_doubles(a, b, c)) {
    count(Tier::filter);
    return *sign;
  }
  if (const auto sign = differing(a, b, c)) return *sign;
  const auto point = [](const PlanePoint& p) { return Point::free({p[0], p[1], 0}); };
  return orient2d(InputComplex(), {.u = 0, .v = 1}, point(a), point(b), point(c));
}

Sign compare(const InputComplex& input, int axis, const Point& p, const Point& q) {
  const auto i = static_cast<std::size_t>(axis);
  if (const auto sign = filtered(p.at[i] - q.at[i])) return *sign;
  if (p.name == q.name && p.name.kind != SymbolicPoint::Kind::free) {
    count(Tier::names);
    return Sign::zero;
  }
  if (const auto sign = filtered(p.fine[i] - q.fine[i])) return *sign;
  const auto width = [&](int b) {
    const PointWidth wp = width_of(p.name, b), wq = width_of(q.name, b);
    return std::max(wp.xyz + wq.w, wq.xyz + wp.w) + 1;
  };
  return decide(input, {&p, &q}, width, [&](const auto& exact) {
    const auto hp = exact.point(p), hq = exact.point(q);
    using Int = std::decay_t<decltype(hp.x)>;
    return Int(weighed(hp[axis], hq) - weighed(hq[axis], hp));
  });
}

bool equal(const InputComplex& input, const Point& p, const Point& q) {
  if (p.name == q.name && p.name.kind != SymbolicPoint::Kind::free) return true;
  for (std::size_t i = 0; i < 3; ++i)
    if (p.at[i].lower() > q.at[i].upper() || q.at[i].lower() > p.at[i].upper()) return false;
  for (int axis = 0; axis < 3; ++axis)
    if (compare(input, axis, p, q) != Sign::zero) return false;
  return true;
}

Sign normal_component(const InputComplex& input, std::uint32_t face, int axis) {
  if (const SourcePlane* plane = input.source_plane(face)) {
    const auto& exact = plane->exact();
    return sign_of_integer(axis == 0 ? exact.a : axis == 1 ? exact.b : exact.c);
  }
  const auto f = input.face(face);
  const Projection across{(axis + 1) % 3, (axis + 2) % 3};
  if (input.has_doubles(f)) {
    const auto corner = [&](std::size_t i) {
      const auto& p = input.vertex(f[i]);
      return PlanePoint{p[static_cast<std::size_t>(across.u)], p[static_cast<std::size_t>(across.v)]};
    };
    if (const auto sign = orientation_in_doubles(corner(0), corner(1), corner(2))) {
      count(Tier::filter);
      return *sign;
    }
  }
  return orient2d(input, across, input_point(input, f[0]), input_point(input, f[1]), input_point(input, f[2]));
}

Sign same_orientation(const InputComplex& input, std::uint32_t f, std::uint32_t g) {
  for (int axis = 0; axis < 3; ++axis) {
    const Sign s = normal_component(input, f, axis);
    if (s != Sign::zero) return s * normal_component(input, g, axis);
  }
  return Sign::zero;
}

Projection projection_of(const InputComplex& input, std::uint32_t face) {
  const auto f = input.face(face);
  const FilteredPlane plane(input.vertex(f[0]), input.vertex(f[1]), input.vertex(f[2]));
  const int first = static_cast<int>(plane.widest_axis());
  for (int i = 0; i < 3; ++i) {
    const int axis = (first + i) % 3;
    const Sign s = normal_component(input, face, axis);
    if (s == Sign::zero) continue;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    return s == Sign::positive ? Projection{u, v} : Projection{v, u};
  }
  return {};
}

Sign area_sign(std::span<const PlanePoint> polygon) {
  if (polygon.size() < 3) return Sign::zero;
  if (const auto sign = filtered_area(polygon)) {
    count(Tier::filter);
    return *sign;
  }
  Lattice lattice;
  for (const auto& p : polygon)
    for (const double x : p) lattice.add(x);
  // The sum of n products of two differences, less than 2^(2b + 1) each.
  const int width = 2 * lattice.bits() + 1 + static_cast<int>(std::bit_width(polygon.size()));
  return sign_in_bits(bits_for(width, lattice), [&]<class Int>(const Int*) {
    Int sum = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const auto &p = polygon[i], &q = polygon[i + 1 < polygon.size() ? i + 1 : 0];
      const auto integer = [&](double x) { return lattice.integer<Int>(x); };
      sum = sum + Int(integer(p[0]) * integer(q[1]) - integer(p[1]) * integer(q[0]));
    }
    return sum;
  });
}

bool is_degenerate(const InputComplex& input, std::uint32_t face) {
  for (int axis = 0; axis < 3; ++axis)
    if (normal_component(input, face, axis) != Sign::zero) return false;
  return true;
}

}  // namespace strata
