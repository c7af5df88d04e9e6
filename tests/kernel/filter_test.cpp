#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "core/kernel/filtered_orientation.h"
#include "core/kernel/predicates.h"
#include "kernel/reference.h"
#include "kernel/tiers.h"
#include "support/random.h"

using namespace strata;
using namespace strata::test;

namespace {

using Coordinates = InputComplex::Coordinates;

RationalPoint exact(const Coordinates& p) { return {to_rational(p[0]), to_rational(p[1]), to_rational(p[2])}; }

/// Four vertices, asked as numbers and as points.
struct Four {
  explicit Four(std::vector<Coordinates> p) : points(std::move(p)) { input.add(points, {}); }

  [[nodiscard]] Sign expected() const {
    return RationalPlane{exact(points[0]), exact(points[1]), exact(points[2])}.side(exact(points[3]));
  }
  [[nodiscard]] Sign of_vertices() const { return orient3d(input, 0U, 1U, 2U, 3U); }
  [[nodiscard]] Sign of_points() const {
    const auto p = [&](std::uint32_t v) { return make_point(input, SymbolicPoint::input(v)); };
    return orient3d(input, p(0), p(1), p(2), p(3));
  }

  std::vector<Coordinates> points;
  InputComplex input;
};

void check(const Four& four) {
  const Sign expected = four.expected();
  REQUIRE(four.of_vertices() == expected);
  REQUIRE(four.of_points() == expected);
}

bool decided_by_filter(const Four& four) {
  TierProbe probe;
  (void)four.of_vertices();
  return probe.take()[static_cast<std::size_t>(Tier::filter)] == 1;
}

double some(Random& random, int low, int high) {
  return (random.once_in(2) ? -1 : 1) * std::ldexp(1 + random.unit(), random.between(low, high));
}

}  // namespace

// value = (uy vz - uz vy) wx = gap, magnitude = 2 to the last bits, so the bound is 14 * 2^-53.
// Catches: the constant 7 halved (8 > 7) or made useless.
TEST_CASE("the filter of orient3d gives up within its bound and decides beyond", "[kernel]") {
  const auto four = [](double gap) { return Four({{0, 0, 0}, {0, 1, 1}, {0, 1 - gap, 1}, {1, 0, 0}}); };
  check(four(0x1p-50));
  check(four(-0x1p-50));
  check(four(0x1p-49));
  check(four(-0x1p-49));
  if (!counts_tiers) return;
  CHECK_FALSE(decided_by_filter(four(0x1p-50)));
  CHECK_FALSE(decided_by_filter(four(-0x1p-50)));
  CHECK(decided_by_filter(four(0x1p-49)));
  CHECK(decided_by_filter(four(-0x1p-49)));
}

// value = gap, magnitude = 2, so the bound is 6 * 2^-53. Catches: the constant 3 halved (4 > 3).
TEST_CASE("the filter of orient2d gives up within its bound and decides beyond", "[kernel]") {
  const auto decided = [](double gap) {
    const InputComplex input;
    const Point p = Point::free({0, 0, 0}), q = Point::free({1, 1 - gap, 0}), r = Point::free({1, 1, 0});
    CHECK(orient2d(input, {0, 1}, p, q, r) == sign_of(gap));
    return filtered_orient2d({0, 1}, p, q, r).has_value();
  };
  CHECK_FALSE(decided(0x1p-51));
  CHECK_FALSE(decided(-0x1p-51));
  CHECK(decided(0x1p-50));
  CHECK(decided(-0x1p-50));
}

// uy vz = -2^-1100 vanishes; times wx = 2^1000 it is worth -2^-100, far more than the 2^-140 that is left.
// Catches: an underflow term that is not multiplied by the third factors.
TEST_CASE("products that vanish count when the third factor is huge", "[kernel]") {
  const Four four({{0, 0, 0}, {0x1p-70, 0x1p-550, 0}, {0, 0x1p-70, -0x1p-550}, {0x1p1000, 0, 1}});
  REQUIRE(four.expected() == Sign::negative);
  check(four);
  const Four mirrored({{0, 0, 0}, {-0x1p-70, 0x1p-550, 0}, {0, 0x1p-70, 0x1p-550}, {0x1p1000, 0, 1}});
  REQUIRE(mirrored.expected() == Sign::positive);
  check(mirrored);
}

TEST_CASE("underflow beside huge factors never misleads", "[kernel][property]") {
  Random random(3);
  for (int i = 0; i < 4000; ++i) {
    CAPTURE(i);
    const int low = random.between(-560, -500);
    const auto tiny = [&] { return random.once_in(4) ? 0.0 : some(random, low - 30, low + 30); };
    const auto mixed = [&] { return random.once_in(3) ? some(random, 900, 1022) : some(random, -1000, 100); };
    check(Four({{0, 0, 0}, {tiny(), tiny(), tiny()}, {tiny(), tiny(), tiny()}, {mixed(), mixed(), mixed()}}));
  }
}

// d is the rounded place of a point in the plane: the determinant is all rounding error.
TEST_CASE("points rounded onto a plane are put on their true side", "[kernel][property][degenerate]") {
  Random random(4);
  for (int i = 0; i < 20000; ++i) {
    CAPTURE(i);
    const auto any = [&] { return Coordinates{some(random, -3, 3), some(random, -3, 3), some(random, -3, 3)}; };
    const Coordinates a = any(), b = any(), c = any();
    const double s = random.unit(), t = random.unit();
    Coordinates d;
    for (std::size_t k = 0; k < 3; ++k) d[k] = a[k] + s * (b[k] - a[k]) + t * (c[k] - a[k]);
    check(Four({a, b, c, d}));
  }
}

TEST_CASE("differences that overflow are decided exactly", "[kernel]") {
  constexpr double most = 1.7e308;
  const Four four({{-most, -most, -most}, {most, -most, -most}, {-most, most, -most}, {most, most, most}});
  REQUIRE(four.expected() == Sign::positive);
  check(four);
  check(Four({{-most, -most, 0}, {most, -most, 0}, {-most, most, 0}, {most, most, 0}}));
  check(Four({{-most, -most, 0}, {most, -most, 0}, {-most, most, 0}, {most, most, -0x1p-1074}}));
}

// Catches: rests compared the wrong way round, products that vanished or overflowed taken for equal, differences taken
// for exact that are rounded.
TEST_CASE("turns by differences are exact or not given", "[kernel][property]") {
  Random random(11);
  int given = 0, zeros = 0;
  for (int i = 0; i < 40'000; ++i) {
    CAPTURE(i);
    const int scale = random.pick(std::array{0, 0, 0, -300, 300, -470, -530, 505, 960}), bits = random.between(2, 53);
    const auto coordinate = [&] {
      const double whole = std::floor((random.unit() - .5) * std::ldexp(1, bits));
      return std::ldexp(whole, scale + (random.once_in(8) ? random.between(-60, 60) : 0));
    };
    PlanePoint p{coordinate(), coordinate()}, q{coordinate(), coordinate()}, r{coordinate(), coordinate()};
    if (random.once_in(2)) {  // nearly or exactly on a line
      const double t = random.between(-3, 3);
      for (std::size_t k = 0; k < 2; ++k) r[k] = p[k] + t * (q[k] - p[k]);
      if (random.once_in(2)) r[0] = std::nextafter(r[0], HUGE_VAL);
    }
    if (!std::isfinite(p[0] + p[1] + q[0] + q[1] + r[0] + r[1])) continue;
    const auto sign = orientation_by_differences(p, q, r);
    if (!sign) continue;
    const auto of = [](double x) { return to_rational(x); };
    const Rational left = (of(q[0]) - of(p[0])) * (of(r[1]) - of(p[1]));
    const Rational right = (of(q[1]) - of(p[1])) * (of(r[0]) - of(p[0]));
    REQUIRE(*sign == sign_of(Rational(left - right)));
    ++given;
    zeros += static_cast<int>(*sign == Sign::zero);
  }
  CHECK(given > 10'000);
  CHECK(zeros > 1'000);
}

TEST_CASE("turns by differences refuse what rounding hides", "[kernel]") {
  const double up = std::nextafter(1.0, 2.0);
  CHECK(orientation_by_differences({0, 0}, {3, up}, {3, 1}) == Sign::negative);
  CHECK(orientation_by_differences({0, 0}, {up, up}, {1, 1}) == Sign::zero);
  CHECK_FALSE(orientation_by_differences({-4, -4}, {1, 1}, {1, up}));                           // rounded differences
  CHECK_FALSE(orientation_by_differences({0, 0}, {0x1p-600, 0x1p-600}, {0x1p-600, 0x1p-600}));  // vanished products
  CHECK_FALSE(orientation_by_differences({0, 0}, {0x1p600, 0x1p600}, {0x1p600, 0x1p600}));
  CHECK_FALSE(orientation_by_differences({-0x1.8p1023, 0}, {0x1.8p1023, 1}, {0, 1}));
}
