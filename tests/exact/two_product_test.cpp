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
    const double q = p / b;
    REQUIRE(to_rational(q) * to_rational(b) + to_rational(quotient_error(p, b, q)) == to_rational(p));
  }
}

TEST_CASE("errors of products with factors at the end of the doubles", "[exact]") {
  const double huge = 0x1.fffffffffffffp1023, little = 0x1.0000000000001p-600;
  for (const double sign : {1.0, -1.0}) {
    const double p = huge * little * sign;
    CHECK(to_rational(p) + to_rational(product_error(sign * huge, little, p)) ==
          to_rational(sign * huge) * to_rational(little));
    CHECK(to_rational(p) + to_rational(product_error(little, sign * huge, p)) ==
          to_rational(sign * huge) * to_rational(little));
  }
  CHECK(!std::isfinite(product_error(huge, huge, huge * huge)));
  CHECK(product_error(0, huge, 0) == 0);
}
