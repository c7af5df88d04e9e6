#include "core/exact/bounded.h"

#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "strata/rational.h"
#include "support/random.h"

using namespace strata;
using test::Random;

namespace {

/// A running error beside the exact value it stands for, and how many operations lie in its tree.
struct Twin {
  Bounded bounded;
  Rational exact;
  int steps = 0;
};

Twin leaf(double x) { return {Bounded(x), to_rational(x), 0}; }

bool is_finite(const Bounded& x) { return std::isfinite(x.value) && std::isfinite(x.error); }

void check(const Twin& x) {
  CAPTURE(x.bounded.value, x.bounded.error, x.steps);
  const auto sign = x.bounded.sign();
  if (sign) REQUIRE(*sign == sign_of(x.exact));
  if (!is_finite(x.bounded)) {
    REQUIRE_FALSE(sign.has_value());
    return;
  }
  const Rational bound = to_rational(x.bounded.error) * to_rational(Bounded::slack);
  REQUIRE(abs(Rational(x.exact - to_rational(x.bounded.value))) <= bound);
  if (std::isfinite(x.bounded.lower())) REQUIRE(to_rational(x.bounded.lower()) <= x.exact);
  if (std::isfinite(x.bounded.upper())) REQUIRE(x.exact <= to_rational(x.bounded.upper()));
}

double any_double(Random& random) {
  for (;;) {
    const double x = std::bit_cast<double>(random.next());
    if (std::isfinite(x)) return x;
  }
}

/// Numbers of one family: where a rounding, an underflow or an overflow waits.
double number(Random& random, int family) {
  const double m = 1 + random.unit(), s = random.once_in(2) ? -1 : 1;
  switch (family) {
    case 0:
      return random.between(-3, 3);
    case 1:
      return s * m;
    case 2:
      return s * std::nextafter(1.0, random.once_in(2) ? 2.0 : 0.0);
    case 3:
      return s * m * std::ldexp(1.0, random.between(-60, 60));
    case 4:
      return s * std::ldexp(m, random.between(-1074, -990));
    case 5:
      return s * std::ldexp(m, random.between(-530, -480));
    case 6:
      return s * std::ldexp(m, random.between(480, 530));
    case 7:
      return s * std::ldexp(m, random.between(990, 1023));
    case 8:
      return std::ldexp(random.between(-9, 9), -1074);
    case 9:
      return s * (random.once_in(2) ? 1e-300 : 1e300);
    default:
      return any_double(random);
  }
}
constexpr int families = 11;

Twin combined(const Twin& a, const Twin& b, int operation) {
  const int steps = a.steps + b.steps + 1;
  switch (operation) {
    case 0:
      return {a.bounded + b.bounded, a.exact + b.exact, steps};
    case 1:
      return {a.bounded - b.bounded, a.exact - b.exact, steps};
    case 2:
      return {a.bounded * b.bounded, a.exact * b.exact, steps};
    case 3:
      return {a.bounded / b.bounded, a.exact / b.exact, steps};
    default:
      return {-a.bounded, -a.exact, a.steps};
  }
}

/// Random expressions over a growing pool. A division by what is exactly zero must stay undecided.
void check_chain(std::uint64_t seed) {
  Random random(seed);
  const int family = random.between(0, families - 1);
  std::vector<Twin> pool;
  for (int i = 0; i < 5; ++i)
    pool.push_back(leaf(number(random, random.once_in(3) ? random.between(0, families - 1) : family)));
  for (int i = 0; i < 24; ++i) {
    const Twin a = random.pick(pool), b = random.pick(pool);
    const int operation = random.between(0, 4);
    if (a.steps + b.steps > 40) continue;
    if (operation == 3 && b.exact == 0) {
      REQUIRE_FALSE((a.bounded / b.bounded).sign().has_value());
      continue;
    }
    pool.push_back(combined(a, b, operation));
    check(pool.back());
  }
}

}  // namespace

// Catches: a rounding constant halved twice, an operand's error not carried, the underflow term left out.
TEST_CASE("the exact value of every expression lies within its bound", "[exact][property]") {
  for (std::uint64_t seed = 0; seed < 12000; ++seed) {
    CAPTURE(seed);
    check_chain(seed);
  }
}

TEST_CASE("long sums and long products stay within their bounds", "[exact][property]") {
  Random random(5);
  Twin sum = leaf(0), product = leaf(1);
  for (int i = 0; i < 3000; ++i) {
    sum = combined(sum, leaf(number(random, 3)), random.between(0, 1));
    if (i < 400) product = combined(product, leaf(1 + random.unit() * 0.001), 2);
  }
  check(sum);
  check(product);
}

// The carried error |q| * error(b) is smaller than every subnormal, yet divided by b it is larger than all else.
TEST_CASE("a quotient by a small inexact number keeps the divisor's error", "[exact]") {
  const Twin large = leaf(0x1.8p-958), third = leaf(0x1.0000000000001p-1011);
  const Twin near = combined(large, third, 0);
  const Twin divisor = combined(near, leaf(0x1.8p-958 - 0x1p-1000), 1);
  check(divisor);
  for (const double a : {0x1p-1074, -0x1p-1074, 0x1p-1060, 0x1p-1022}) {
    const Twin quotient = combined(leaf(a), divisor, 3);
    REQUIRE(is_finite(quotient.bounded));
    check(quotient);
  }
}

TEST_CASE("products that underflow are undecided, not zero", "[exact]") {
  const Bounded tiny(1e-200), huge(1e300);
  const Bounded lost = tiny * tiny;
  CHECK(lost.value == 0);
  CHECK_FALSE(lost.sign().has_value());
  CHECK_FALSE((lost * huge).sign().has_value());
  CHECK_FALSE((lost * huge * huge - Bounded(1e-300)).sign().has_value());
}

TEST_CASE("overflow is undecided", "[exact]") {
  const Bounded huge(1.7e308);
  CHECK_FALSE((huge + huge).sign().has_value());
  CHECK_FALSE((huge * huge).sign().has_value());
  CHECK_FALSE((huge + huge - (huge + huge)).sign().has_value());
  CHECK_FALSE(((huge + huge) * Bounded(0)).sign().has_value());
  CHECK_FALSE((Bounded(1) / (huge + huge)).sign().has_value());
}

TEST_CASE("differences of doubles are always decided", "[exact][property]") {
  Random random(9);
  for (int i = 0; i < 20000; ++i) {
    const int family = random.between(0, families - 1);
    const double a = number(random, family), b = random.once_in(4) ? a : number(random, family);
    const auto sign = (Bounded(a) - Bounded(b)).sign();
    if (std::isinf(a - b)) continue;
    REQUIRE(sign.has_value());
    REQUIRE(*sign == sign_of(Rational(to_rational(a) - to_rational(b))));
  }
}

TEST_CASE("only exact zeros are zero", "[exact]") {
  CHECK(Bounded(0).sign() == Sign::zero);
  CHECK(Bounded(-0.0).sign() == Sign::zero);
  CHECK((Bounded(3) - Bounded(3)).sign() == Sign::zero);
  CHECK_FALSE((Bounded(0, 0x1p-1074)).sign().has_value());
  CHECK((Bounded(0x1p-1074)).sign() == Sign::positive);
}
