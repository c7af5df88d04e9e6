#include "extensions/planar/places.h"

#include <optional>

#include "core/exact/big_integer.h"
#include "core/exact/double_double.h"
#include "core/kernel/nearest.h"
#include "extensions/planar/exact_forms.h"

namespace strata::planar {
namespace {

template <class Real>
using Pair = std::array<Real, 2>;

Bounded given_coordinate(const Places& places, std::uint32_t p, std::size_t axis, const Bounded*) {
  return bounded(places, p, axis);
}
/// How far between p and q the point is: 0 at p, 1 at q.
DoubleDouble part_of_way(const PointBetween& b) {
  return (DoubleDouble(b.at) - DoubleDouble(b.from)) / (DoubleDouble(b.to) - DoubleDouble(b.from));
}
DoubleDouble coordinate(const PointBetween& b, const DoubleDouble& part, std::size_t axis) {
  const double p = b.p[axis], q = b.q[axis];
  return p == q ? DoubleDouble(p) : DoubleDouble(p) + part * (DoubleDouble(q) - DoubleDouble(p));
}

DoubleDouble given_coordinate(const Places& places, std::uint32_t p, std::size_t axis, const DoubleDouble*) {
  if (places.is_double(p)) return places.place[p][axis];
  const RationalPlace& place = places.rational(p);
  if (const PointBetween* b = place.between()) return coordinate(*b, part_of_way(*b), axis);
  return nearest_double_double((*place.given())[axis]);
}

template <class Real>
Pair<Real> given_pair(const Places& places, std::uint32_t p) {
  const Real* kind = nullptr;
  return {given_coordinate(places, p, 0, kind), given_coordinate(places, p, 1, kind)};
}

/// A coordinate that both points of a line have in common; all of its points have it.
std::optional<double> common_coordinate(const Places& places, const Line& l, std::size_t axis) {
  if (!places.is_double(l.from) || !places.is_double(l.to)) return std::nullopt;
  const double x = places.place[l.from][axis];
  if (x != places.place[l.to][axis]) return std::nullopt;
  return x;
}

/// The intersection of two lines as a point of the first one, in numbers with bounds: start + way.
template <class Real>
struct MeetOnLine {
  Pair<Real> start, way;
};

template <class Real>
MeetOnLine<Real> on_first_line(const Places& places, const Meet& meet) {
  const Line l = places.lines[meet.first], m = places.lines[meet.second];
  const Pair<Real> a = given_pair<Real>(places, l.from), b = given_pair<Real>(places, l.to);
  const Pair<Real> c = given_pair<Real>(places, m.from), d = given_pair<Real>(places, m.to);
  const Real ux = b[0] - a[0], uy = b[1] - a[1], vx = d[0] - c[0], vy = d[1] - c[1];
  const Real t = ((c[0] - a[0]) * vy - (c[1] - a[1]) * vx) / (ux * vy - uy * vx);
  return {a, {t * ux, t * uy}};
}

/// The sum, which may have more digits than its terms.
template <class Sum, class Real>
Pair<Sum> sum_of(const Places& places, const Meet& meet, const MeetOnLine<Real>& on_line) {
  Pair<Sum> p;
  for (std::size_t i = 0; i < 2; ++i) {
    p[i] = Sum(on_line.start[i]) + Sum(on_line.way[i]);
    for (const std::uint32_t line : {meet.first, meet.second})
      if (const auto x = common_coordinate(places, places.lines[line], i)) p[i] = Sum(*x);
  }
  return p;
}

template <class Real>
Pair<Real> meet_of(const Places& places, const Meet& meet) {
  return sum_of<Real>(places, meet, on_first_line<Real>(places, meet));
}

RationalPlacement exact_meet(const Places& places, const Meet& meet) {
  const Lattice unused;
  const Reader<Rational> reader(places, unused);
  const auto l = reader.line(meet.first), m = reader.line(meet.second);
  const Integer w = l.a * m.b - m.a * l.b;
  return {Rational(l.b * m.c - m.b * l.c, w), Rational(l.c * m.a - m.c * l.a, w)};
}

/// A rational as its nearest double with a bound on the rounding error. Beyond all doubles: the largest double, with an
/// infinite bound.
Bounded bounded_rational(const Rational& x) {
  const double value = to_nearest_double(x);
  if (!std::isfinite(value)) return {std::copysign(0x1.fffffffffffffp1023, value), HUGE_VAL};
  if (is_dyadic(x) && to_rational(value) == x) return value;
  return {value, std::abs(value) * Bounded::rounding + Bounded::underflow};
}

Pair<Bounded> bounded_pair(const RationalPlacement& p) { return {bounded_rational(p[0]), bounded_rational(p[1])}; }

/// The same for the point of a segment, whose rationals are computed where double-doubles do not tell the nearest
/// double, or where the coordinate may be a double.
Pair<Bounded> bounded_pair(const PointBetween& between) {
  const DoubleDouble part = part_of_way(between);
  Pair<Bounded> pair;
  for (std::size_t i = 0; i < 2; ++i) {
    const DoubleDouble x = coordinate(between, part, i);
    const bool is_settled = x.error == 0 || (x.rounds_to_value() && std::abs(x.low) > x.error * Bounded::slack);
    if (!is_settled) return bounded_pair(RationalPlace(between).exact());
    pair[i] =
        x.error == 0 ? Bounded(x.value) : Bounded(x.value, std::abs(x.value) * Bounded::rounding + Bounded::underflow);
  }
  return pair;
}

Pair<Bounded> bounded_pair(const RationalPlace& place) {
  if (const PointBetween* b = place.between()) return bounded_pair(*b);
  return bounded_pair(*place.given());
}

/// True when the bounds of a meet are small relative to its lines' points. False for infinite values.
bool is_sharp(const Places& places, const Meet& meet, const Pair<Bounded>& p) {
  for (std::size_t i = 0; i < 2; ++i) {
    const Line l = places.lines[meet.first];
    const double scale = std::abs(p[i].value) + std::abs(places.place[l.to][i] - places.place[l.from][i]);
    if (!(std::isfinite(p[i].value) && p[i].error <= scale * 0x1p-40)) return false;
  }
  return true;
}

}  // namespace

RationalPlacement RationalPlace::exact() const {
  if (const RationalPlacement* p = given()) return *p;
  const PointBetween& b = *between();
  Lattice lattice;
  for (const double x : {b.p[0], b.p[1], b.q[0], b.q[1], b.from, b.to, b.at}) lattice.add(x);
  const auto integer = [&](double x) { return lattice.integer<Integer>(x); };
  const Integer at = integer(b.at), before = at - integer(b.from), after = integer(b.to) - at, whole = before + after;
  const auto coordinate = [&](std::size_t i) -> Rational {
    if (b.p[i] == b.q[i]) return b.p[i];
    Integer sum = integer(b.p[i]) * after + integer(b.q[i]) * before;
    const int unit = lattice.unit();
    if (unit >= 0) return {std::move(sum) << static_cast<std::size_t>(unit), whole};
    return {sum, whole << static_cast<std::size_t>(-unit)};
  };
  return {coordinate(0), coordinate(1)};
}

std::uint32_t Places::add(const PlanePoint& p) {
  place.push_back(p);
  return size() - 1;
}

std::uint32_t Places::add(RationalPlace p) {
  const auto [x, y] = bounded_pair(p);
  place.push_back({x.value, y.value});
  error.push_back({x.error, y.error});
  rationals.push_back(std::move(p));
  return size() - 1;
}

std::uint32_t Places::add(const Meet& m) {
  Pair<Bounded> p = meet_of<Bounded>(*this, m);
  if (!is_sharp(*this, m, p)) {
    const Pair<DoubleDouble> q = meet_of<DoubleDouble>(*this, m);
    p = {q[0].bounded(), q[1].bounded()};
    if (!is_sharp(*this, m, p)) {
      const RationalPlacement exact = exact_meet(*this, m);
      p = bounded_pair(exact);
    }
  }
  place.push_back({p[0].value, p[1].value});
  error.push_back({p[0].error, p[1].error});
  meets.push_back(m);
  return size() - 1;
}

void Places::drop_meets(std::uint32_t count) {
  const std::uint32_t dropped = size() - count;
  place.resize(count);
  error.resize(error.size() - dropped);
  meets.resize(meets.size() - dropped);
}

RationalPlacement exact_position(const Places& places, std::uint32_t point) {
  if (places.is_meet(point)) return exact_meet(places, places.meet(point));
  if (!places.is_double(point)) return places.rational(point).exact();
  return {to_rational(places.place[point][0]), to_rational(places.place[point][1])};
}

PlanePoint nearest_place(const Places& places, std::uint32_t point) {
  if (places.is_double(point)) return places.place[point];
  const PlanePoint& error = places.error[point - places.doubles()];
  if (error[0] == 0 && error[1] == 0) return places.place[point];
  if (places.is_meet(point)) {
    const Meet& m = places.meet(point);
    const auto settles = [](const Pair<DoubleDouble>& p) { return p[0].rounds_to_value() && p[1].rounds_to_value(); };
    // On a segment that is short beside its distance from zero, doubles tell where; the sum needs more of them.
    Pair<DoubleDouble> p = sum_of<DoubleDouble>(places, m, on_first_line<Bounded>(places, m));
    if (!settles(p)) p = meet_of<DoubleDouble>(places, m);
    if (settles(p)) return {p[0].value, p[1].value};
  }
  const RationalPlacement p = exact_position(places, point);
  return {to_nearest_double(p[0]), to_nearest_double(p[1])};
}

}  // namespace strata::planar
