#include "core/exact/two_sum.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "strata/rational.h"

using namespace strata;

// Seen to fail: the rest of b left out.

TEST_CASE("a sum and its rest are the exact sum", "[exact][property]") {
  std::mt19937_64 random(11);
  const auto number = [&] {
    const double digits = static_cast<double>(static_cast<std::int64_t>(random())) * 0x1p-63;
    return std::ldexp(digits, static_cast<int>(random() % 240) - 120);
  };
  for (int n = 0; n < 20'000; ++n) {
    double a = number(), b = n % 3 == 0 ? -a * (1 + 0x1p-52 * static_cast<double>(random() % 5)) : number();
    CAPTURE(a, b);
    const Rational exact = to_rational(a) + to_rational(b);
    const WithRest s = two_sum(a, b);
    REQUIRE(s.value == a + b);
    REQUIRE(to_rational(s.value) + to_rational(s.rest) == exact);
    if (std::abs(a) < std::abs(b)) std::swap(a, b);
    const WithRest q = quick_two_sum(a, b);
    REQUIRE(q.value == s.value);
    REQUIRE(q.rest == s.rest);
  }
}

TEST_CASE("sums at the ends of the doubles", "[exact]") {
  CHECK(two_sum(0x1p-1074, 1).rest == 0x1p-1074);
  CHECK(two_sum(0, -0.0).rest == 0);
  CHECK(quick_two_sum(0, 3).rest == 0);
  CHECK(std::isnan(two_sum(1.7e308, 1.7e308).rest));
}
