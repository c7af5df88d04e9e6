#include "strata/rational.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>

using namespace strata;

namespace {

template <class Float>
Float nearest(const Rational& q) {
  if constexpr (sizeof(Float) == sizeof(double)) {
    return to_nearest_double(q);
  } else {
    return to_nearest_float(q);
  }
}

template <class Float>
bool is_even(Float x) {
  std::conditional_t<sizeof(Float) == 8, std::uint64_t, std::uint32_t> bits = 0;
  std::memcpy(&bits, &x, sizeof x);
  return (bits & 1U) == 0;
}

Rational power_of_two(int e) { return e >= 0 ? Rational(Integer(1) << e) : Rational(Integer(1), Integer(1) << -e); }

/// The value that stands for x in comparisons: an infinity is the first number beyond the range.
template <class Float>
Rational extended_value(Float x) {
  if (std::isfinite(x)) return to_rational(static_cast<double>(x));
  const Rational beyond = power_of_two(std::numeric_limits<Float>::max_exponent);
  return x > 0 ? beyond : Rational(-beyond);
}

/// No neighbour of the answer is nearer, and none is as near with an even mantissa where the answer has an odd one.
template <class Float>
bool is_nearest(const Rational& q) {
  const Float x = nearest<Float>(q);
  const Rational error = abs(Rational(extended_value(x) - q));
  if (std::isinf(x) && abs(q) > power_of_two(std::numeric_limits<Float>::max_exponent)) return (x > 0) == (q > 0);
  for (const Float toward : {-std::numeric_limits<Float>::infinity(), std::numeric_limits<Float>::infinity()}) {
    const Float neighbour = std::nextafter(x, toward);
    if (neighbour == x) continue;
    const Rational other = abs(Rational(extended_value(neighbour) - q));
    if (other < error || (other == error && !is_even(x))) return false;
  }
  return true;
}

template <class Float>
Float random_float(std::mt19937_64& random) {
  using Bits = std::conditional_t<sizeof(Float) == 8, std::uint64_t, std::uint32_t>;
  for (;;) {
    const Bits bits = static_cast<Bits>(random());
    Float x = 0;
    std::memcpy(&x, &bits, sizeof x);
    if (std::isfinite(x)) return x;
  }
}

template <class Float>
void check_around(Float x, std::mt19937_64& random) {
  const Rational value = to_rational(static_cast<double>(x));
  const Float up = std::nextafter(x, std::numeric_limits<Float>::infinity());
  const Rational above = extended_value(up);
  const Rational middle = (value + above) / 2;
  const Rational little = (above - value) / Integer(1 + random() % 1'000'000'007);
  CHECK(nearest<Float>(value) == x);
  for (const Rational& q : {middle, Rational(middle + little), Rational(middle - little), Rational(value + little)}) {
    CHECK(is_nearest<Float>(q));
  }
}

}  // namespace

TEMPLATE_TEST_CASE("rounding a rational picks the nearest of the neighbours", "[exact]", double, float) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 3000; ++i) check_around(random_float<TestType>(random), random);
}

TEMPLATE_TEST_CASE("rounding is right among subnormals and at both ends of the range", "[exact]", double, float) {
  using Limits = std::numeric_limits<TestType>;
  std::mt19937_64 random(8);
  TestType x = 0;
  for (int i = 0; i < 20; ++i, x = std::nextafter(x, Limits::infinity())) check_around(x, random);
  for (const TestType edge : {Limits::min(), std::nextafter(Limits::min(), TestType(0)), Limits::max(), -Limits::max(),
                              Limits::denorm_min(), TestType(-Limits::denorm_min())}) {
    check_around(edge, random);
  }
  for (int i = 0; i < 500; ++i)
    check_around(static_cast<TestType>(random_float<TestType>(random) * Limits::min()), random);
}

TEMPLATE_TEST_CASE("values beyond the largest finite number by half a unit become infinite", "[exact]", double, float) {
  using Limits = std::numeric_limits<TestType>;
  const Rational largest = to_rational(static_cast<double>(Limits::max()));
  const Rational half_unit = power_of_two(Limits::max_exponent - Limits::digits - 1);
  CHECK(std::isinf(nearest<TestType>(largest + half_unit)));  // a tie: infinity counts as even
  CHECK(nearest<TestType>(largest + half_unit - Rational(1, 3)) == Limits::max());
  CHECK(nearest<TestType>(-(largest + half_unit)) == -Limits::infinity());
  CHECK(nearest<TestType>(power_of_two(100'000)) == Limits::infinity());
  CHECK(nearest<TestType>(-power_of_two(-100'000)) == 0);
  CHECK_FALSE(std::signbit(nearest<TestType>(-power_of_two(-100'000))));
}

TEMPLATE_TEST_CASE("quotients of random integers of any size are rounded to nearest", "[exact]", double, float) {
  std::mt19937_64 random(9);
  for (int i = 0; i < 3000; ++i) {
    Integer n = random();
    Integer d = random() | 1U;
    for (std::uint64_t words = random() % 4; words > 0; --words) n = (n << 64) + random();
    for (std::uint64_t words = random() % 4; words > 0; --words) d = (d << 64) + random();
    CHECK(is_nearest<TestType>(Rational(n, d)));
    CHECK(is_nearest<TestType>(Rational(-(n >> (random() % 60)), d)));
    CHECK(is_nearest<TestType>(Rational(Integer(random() % 5000), Integer(1 + random() % 5000))));
  }
}

TEST_CASE("a double and its rational are the same number", "[exact]") {
  std::mt19937_64 random(10);
  for (int i = 0; i < 3000; ++i) {
    const double x = random_float<double>(random);
    CHECK(to_nearest_double(to_rational(x)) == x);
  }
  CHECK(to_rational(-0.0) == 0);
  CHECK(to_rational(0.375) == Rational(3, 8));
  CHECK(to_rational(std::numeric_limits<double>::denorm_min()) == power_of_two(-1074));
  CHECK(to_rational(-std::numeric_limits<double>::max()) == -(power_of_two(1024) - power_of_two(971)));
}

TEST_CASE("the nearest double of fractions near the middle between two", "[exact]") {
  std::mt19937_64 random(7);
  for (int i = 0; i < 20000; ++i) {
    const int bits = static_cast<int>(random() % 12);
    Integer n = Integer(random() >> bits) << (random() % 200), d = Integer((random() >> (random() % 60)) | 1)
                                                                   << (random() % 200);
    const double x = std::ldexp(static_cast<double>(random() >> 11), static_cast<int>(random() % 100) - 50);
    const Rational middle = (Rational(x) + Rational(std::nextafter(x, INFINITY))) / 2;
    Rational q(n, d);
    if (i % 3 == 1) q = middle;
    if (i % 3 == 2) q = middle + Rational(i % 2 == 0 ? 1 : -1, Integer(random() | 1) << (random() % 150));
    if (random() % 2 == 0) q = -q;
    REQUIRE(is_nearest<double>(q));
  }
}
