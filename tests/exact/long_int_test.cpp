#include "core/exact/long_int.h"

#include <catch2/catch.hpp>

#include "core/exact/lattice.h"
#include "support/random.h"

using namespace strata;

namespace {

using test::Random;

/// Up to `limbs` limbs of zeros, ones, all ones, top bits and random words: carries and borrows run through them.
Integer random_integer(Random& random, int limbs) {
  Integer r = 0;
  for (int i = random.between(0, limbs); i > 0; --i) {
    const std::uint64_t ones = ~std::uint64_t{0};
    const std::uint64_t words[] = {0, 0, ones, ones, 1, std::uint64_t{1} << 63, ones - 1, random.next()};
    r = (r << 64) + words[random.below(8)];
  }
  return random.below(2) == 0 ? r : Integer(-r);
}

/// The same number: not lost, no leading zeros that would lengthen it, no negative zero.
void require_same(const LongInt& found, const Integer& expected) {
  REQUIRE_FALSE(found.is_lost());
  REQUIRE(to_int(found.sign()) == expected.sign());
  REQUIRE(Integer(found) == expected);
  REQUIRE((found - LongInt(expected)).sign() == Sign::zero);
  REQUIRE((found * LongInt(expected)).sign() == (expected == 0 ? Sign::zero : Sign::positive));
}

void check_pair(const Integer& x, const Integer& y, int shift) {
  const LongInt a(x), b(y);
  require_same(a, x);
  require_same(a + b, x + y);
  require_same(a - b, x - y);
  require_same(a * b, x * y);
  require_same(-a, -x);
  require_same(a << shift, Integer(x * (Integer(1) << static_cast<unsigned>(shift))));
  const Integer whole = abs(x) >> static_cast<unsigned>(shift);
  require_same(a >> shift, x < 0 ? Integer(-whole) : whole);
  require_same(gcd(a, b), gcd(x, y));
  if (y != 0) require_same(exact_quotient(a * b, b), x);
  if (x != 0) REQUIRE(a.trailing_zeros() == static_cast<int>(trailing_zeros(x)));
  LongInt c = a;
  c = b;
  require_same(c, y);
}

LongInt power_of_two(int exponent) { return LongInt::shifted(1, exponent, false); }

}  // namespace

// Catches: a carry, borrow or limb lost, a wrong sign of a difference, a zero that is negative, a divisor that is
// not the greatest.
TEST_CASE("long integers agree with unbounded ones", "[exact][property]") {
  Random random(77);
  for (int i = 0; i < 20'000; ++i) {
    const Integer x = random_integer(random, 12), y = random.below(4) == 0 ? x : random_integer(random, 12);
    check_pair(x, random.below(8) == 0 ? Integer(-y) : y, random.between(0, 300));
  }
}

TEST_CASE("long integers take small and shifted ones", "[exact]") {
  for (const std::int64_t x : {std::int64_t{0}, std::int64_t{1}, std::int64_t{-1},
                               std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max()})
    require_same(LongInt(x), Integer(x));
  for (const int shift : {0, 1, 63, 64, 65, 1000, 1900})
    require_same(LongInt::shifted(5, shift, true), Integer(-(Integer(5) << static_cast<unsigned>(shift))));
  require_same(LongInt::shifted(0, 100'000, true), 0);
  Lattice lattice;
  for (const double x : {1e-30, -3.0}) lattice.add(x);
  require_same(lattice.integer<LongInt>(-3.0), lattice.integer<Integer>(-3.0));
}

// Catches: writing beyond the limbs, a lost value that is taken for a number.
TEST_CASE("what does not fit is lost, and so is all that comes of it", "[exact][degenerate]") {
  const LongInt top = power_of_two(LongInt::bits - 65), half = power_of_two(LongInt::bits / 2);
  CHECK_FALSE(top.is_lost());
  const LongInt lost = half * half;
  CHECK(lost.is_lost());
  CHECK((top << 128).is_lost());
  CHECK(power_of_two(LongInt::bits).is_lost());
  CHECK(LongInt(Integer(1) << LongInt::bits).is_lost());
  LongInt copy = 1;
  copy = lost;
  for (const LongInt& x : {copy, -lost, lost + top, top - lost, lost * LongInt(0), LongInt(0) * lost, lost << 1}) {
    CHECK(x.is_lost());
    CHECK_THROWS_AS(x.sign(), LogicError);
    CHECK_THROWS_AS(Integer(x), LogicError);
  }
}

TEST_CASE("a carry out of the last limb is lost, one within it is not", "[exact][degenerate]") {
  const LongInt all_ones((Integer(1) << LongInt::bits) - 1);
  CHECK_FALSE(all_ones.is_lost());
  CHECK((all_ones + LongInt(1)).is_lost());
  CHECK((all_ones - LongInt(1)).sign() == Sign::positive);
  CHECK((all_ones - all_ones).sign() == Sign::zero);
}
