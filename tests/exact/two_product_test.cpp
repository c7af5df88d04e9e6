#include "core/exact/two_product.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "strata/rational.h"

using namespace strata;

namespace {

/// Numbers of all lengths, of sizes from 2^-exponents to 2^exponents.
struct Numbers {
  std::mt19937_64 random{13};
  double operator()(int exponents) {
    const auto bits = static_cast<std::int64_t>(random()) >> (random() % 60);
    const double digits = static_cast<double>(bits) * 0x1p-63;
    return std::ldexp(digits == 0 ? 1 : digits, static_cast<int>(random() % (2 * exponents)) - exponents);
  }
};

}  // namespace

// Seen to fail: the product of the low halves left out; and with fma() of MinGW's library.

TEST_CASE("a product and its error are the exact product", "[exact][property]") {
  Numbers number;
  for (int n = 0; n < 20'000; ++n) {
    const double a = number(300), b = number(100), p = a * b;
    CAPTURE(a, b);
    const Rational exact = to_rational(a) * to_rational(b);
    const WithRest dekker = dekker_product(a, b);
    REQUIRE(dekker.value == p);
    REQUIRE(to_rational(p) + to_rational(dekker.rest) == exact);
    REQUIRE(product_error(a, b, p) == dekker.rest);
    REQUIRE(dekker_error(a, b, p) == dekker.rest);
    const double q = p / b;
    REQUIRE(to_rational(q) * to_rational(b) + to_rational(quotient_error(p, b, q)) == to_rational(p));
  }
}

TEST_CASE("errors of products at the end of the doubles", "[exact]") {
  const double most = 0x1.fffffffffffffp1023;
  Numbers number;
  const auto check = [](double a, double b) {
    for (const double sign : {1.0, -1.0}) {
      const double p = sign * a * b;
      CAPTURE(a, b, sign);
      const Rational exact = to_rational(sign * a) * to_rational(b);
      REQUIRE(to_rational(p) + to_rational(product_error(sign * a, b, p)) == exact);
      REQUIRE(to_rational(p) + to_rational(dekker_error(b, sign * a, p)) == exact);
    }
  };
  for (int n = 0; n < 1000; ++n) {
    const double a = std::abs(number(1)) + 0.5;
    check(most, std::ldexp(a, -600));
    check(most / 2, std::ldexp(a, -2));
    check(most, a / std::ldexp(a, 1));
    check(std::ldexp(a, 510), std::ldexp(a, 511));
  }
  check(most, 1);
  check(0, most);
  CHECK(!std::isfinite(product_error(most, most, most * most)));
  CHECK(!std::isfinite(dekker_error(most, 2, most * 2)));
}
