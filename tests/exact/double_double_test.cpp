#include "core/exact/double_double.h"

#include <bit>
#include <catch2/catch.hpp>
#include <vector>

#include "strata/rational.h"
#include "support/random.h"

using namespace strata;
using test::Random;

namespace {

/// A double-double sum beside the exact value it stands for, and how many operations lie in its tree.
struct Twin {
  DoubleDouble sum;
  Rational exact;
  int steps = 0;
};

void check(const Twin& x) {
  CAPTURE(x.sum.value, x.sum.low, x.sum.error, x.steps);
  if (!std::isfinite(x.sum.value) || !std::isfinite(x.sum.error) || !std::isfinite(x.sum.low)) {
    REQUIRE_FALSE(x.sum.rounds_to_value());
    REQUIRE_FALSE(x.sum.bounded().sign().has_value());
    return;
  }
  const Rational slack = to_rational(Bounded::slack);
  const Rational off = abs(Rational(x.exact - to_rational(x.sum.value) - to_rational(x.sum.low)));
  REQUIRE(off <= to_rational(x.sum.error) * slack);
  if (x.sum.rounds_to_value()) REQUIRE(to_nearest_double(x.exact) == x.sum.value);
  const Bounded b = x.sum.bounded();
  REQUIRE(abs(Rational(x.exact - to_rational(b.value))) <= to_rational(b.error) * slack);
  if (std::isfinite(b.lower())) REQUIRE(to_rational(b.lower()) <= x.exact);
  if (std::isfinite(b.upper())) REQUIRE(x.exact <= to_rational(b.upper()));
}

double number(Random& random, int family) {
  const double m = (random.once_in(2) ? -1 : 1) * (1 + random.unit());
  switch (family) {
    case 0:
      return random.between(-3, 3);
    case 1:
      return m;
    case 2:
      return std::nextafter(1.0, random.once_in(2) ? 2.0 : 0.0);
    case 3:
      return std::ldexp(m, random.between(-60, 60));
    case 4:
      return std::ldexp(m, random.between(-1074, -990));
    case 5:
      return std::ldexp(m, random.between(-530, -430));
    case 6:
      return std::ldexp(m, random.between(480, 530));
    default:
      return std::ldexp(m, random.between(960, 1023));
  }
}

Twin combined(const Twin& a, const Twin& b, int operation) {
  const int steps = a.steps + b.steps + 1;
  switch (operation) {
    case 0:
      return {a.sum + b.sum, a.exact + b.exact, steps};
    case 1:
      return {a.sum - b.sum, a.exact - b.exact, steps};
    case 2:
      return {a.sum * b.sum, a.exact * b.exact, steps};
    default:
      return {a.sum / b.sum, a.exact / b.exact, steps};
  }
}

void check_chain(std::uint64_t seed) {
  Random random(seed);
  const int family = random.between(0, 7);
  std::vector<Twin> pool;
  for (int i = 0; i < 5; ++i) {
    const double x = number(random, random.once_in(3) ? random.between(0, 7) : family);
    pool.push_back({DoubleDouble(x), to_rational(x), 0});
  }
  for (int i = 0; i < 24; ++i) {
    const Twin a = random.pick(pool), b = random.pick(pool);
    const int operation = random.between(0, 3);
    if (a.steps + b.steps > 40) continue;
    if (operation == 3 && b.exact == 0) {
      REQUIRE_FALSE((a.sum / b.sum).rounds_to_value());
      continue;
    }
    pool.push_back(combined(a, b, operation));
    check(pool.back());
  }
}

}  // namespace

// Catches: an error not carried, a correction term lost, a remainder that underflows before the division.
TEST_CASE("the exact value of every expression lies within its twofold bound", "[exact][property]") {
  for (std::uint64_t seed = 0; seed < 15000; ++seed) {
    CAPTURE(seed);
    check_chain(seed);
  }
}

TEST_CASE("a quotient of tiny numbers keeps what its remainder loses", "[exact]") {
  Random random(6);
  for (int i = 0; i < 3000; ++i) {
    const double a = number(random, 4), b = number(random, 4);
    check(combined({DoubleDouble(a), to_rational(a), 0}, {DoubleDouble(b), to_rational(b), 0}, 3));
  }
}

TEST_CASE("the bound of a rounded sum leaves room for its ends", "[exact]") {
  const Rational exact = 1 - to_rational(0x1p-80);
  const DoubleDouble x(1, -0x1p-80, 0);
  CHECK(to_rational(x.bounded().lower()) <= exact);
  CHECK(x.rounds_to_value());
}
