#include "core/exact/scaled_root.h"

#include <catch2/catch.hpp>
#include <random>

using namespace strata;

// Seen to fail: a shift of k where 2 k is asked for.

TEST_CASE("a scaled root is the integer part of the root", "[exact][property]") {
  std::mt19937_64 random(13);
  for (int n = 0; n < 2000; ++n) {
    const Rational q(Integer(random() >> random() % 60), Integer(1 + (random() >> random() % 60)));
    const long k = static_cast<long>(random() % 200) - 60;
    const Integer power = Integer(1) << static_cast<std::size_t>(2 * std::abs(k));
    const Rational scaled = k >= 0 ? q * Rational(power) : q / Rational(power);
    const Integer root = scaled_root(q, k);
    CAPTURE(q.str(), k);
    REQUIRE(Rational(root * root) <= scaled);
    REQUIRE(scaled < Rational((root + 1) * (root + 1)));
  }
  CHECK(scaled_root(Rational(0), 100) == Integer(0));
  CHECK(scaled_root(Rational(9, Integer(4)), 1) == Integer(3));
}

TEST_CASE("a size bounds its number", "[exact][property]") {
  std::mt19937_64 random(17);
  for (int n = 0; n < 1000; ++n) {
    const Rational q(Integer(1 + (random() >> random() % 60)), Integer(1 + (random() >> random() % 60)));
    const long size = binary_size(q);
    const auto power = [](long e) {
      const Integer p = Integer(1) << static_cast<std::size_t>(std::abs(e));
      return e >= 0 ? Rational(p) : Rational(Integer(1), p);
    };
    REQUIRE(power(size - 1) < q);
    REQUIRE(q < power(size + 1));
  }
}
