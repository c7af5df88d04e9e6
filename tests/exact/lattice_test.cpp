#include "core/exact/lattice.h"

#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "support/random.h"

using namespace strata;
using test::Random;

namespace {

constexpr double tiniest = std::numeric_limits<double>::denorm_min();
constexpr double largest = std::numeric_limits<double>::max();

/// Any finite double, subnormals included: uniform in its bits.
double any_double(Random& random) {
  for (;;) {
    const double x = std::bit_cast<double>(random.next());
    if (std::isfinite(x)) return x;
  }
}

double subnormal(Random& random) { return std::bit_cast<double>(random.next() & 0x800fffffffffffffU); }

/// A double whose exponent lies in a narrow band, so that a set of them needs few bits.
double near_one(Random& random) { return std::ldexp(random.between(-4096, 4096), random.between(-20, 20)); }

Rational power_of_two(int e) { return e >= 0 ? Rational(Integer(1) << e) : Rational(Integer(1), Integer(1) << -e); }

template <int Limbs>
Rational value_of(const WideInt<Limbs>& x) {
  const bool negative = x.sign() == Sign::negative;
  const WideInt<Limbs> m = negative ? -x : x;
  Integer r = 0;
  for (int i = Limbs - 1; i >= 0; --i) {
    r <<= 64;
    r += m.limbs()[static_cast<std::size_t>(i)];
  }
  return Rational(negative ? Integer(-r) : r);
}
Rational value_of(const Integer& x) { return Rational(x); }

template <class Int>
void check_integers(const Lattice& lattice, const std::vector<double>& numbers) {
  for (const double x : numbers)
    REQUIRE(value_of(lattice.integer<Int>(x)) * power_of_two(lattice.unit()) == to_rational(x));
}

void check_lattice(const std::vector<double>& numbers) {
  Lattice lattice;
  for (const double x : numbers) lattice.add(x);
  const Rational limit = power_of_two(lattice.bits());
  for (const double x : numbers) REQUIRE(abs(Rational(lattice.integer<Integer>(x))) < limit);
  check_integers<Integer>(lattice, numbers);
  if (lattice.bits() < 128) check_integers<WideInt<2>>(lattice, numbers);
  if (lattice.bits() < 256) check_integers<WideInt<4>>(lattice, numbers);
  if (lattice.bits() < 512) check_integers<WideInt<8>>(lattice, numbers);
  if (lattice.bits() < 1024) check_integers<WideInt<16>>(lattice, numbers);
}

}  // namespace

TEST_CASE("a double is its sign, odd magnitude and power of two", "[exact][property]") {
  Random random(1);
  for (int i = 0; i < 20000; ++i) {
    const double x = i % 4 == 0 ? subnormal(random) : any_double(random);
    CAPTURE(x);
    const DoubleParts parts(x);
    if (x == 0) {
      REQUIRE(parts.magnitude == 0);
      continue;
    }
    REQUIRE(parts.magnitude % 2 == 1);
    REQUIRE(parts.magnitude < (std::uint64_t{1} << 53));
    const Rational magnitude = Rational(Integer(parts.magnitude)) * power_of_two(parts.exponent);
    REQUIRE((parts.negative ? Rational(-magnitude) : magnitude) == to_rational(x));
  }
}

TEST_CASE("the ends of the range have their parts", "[exact]") {
  CHECK(DoubleParts(0.0).magnitude == 0);
  CHECK(DoubleParts(-0.0).magnitude == 0);
  CHECK_FALSE(DoubleParts(-0.0).negative);
  CHECK(DoubleParts(tiniest).exponent == -1074);
  CHECK(DoubleParts(-tiniest).negative);
  CHECK(DoubleParts(0x1p-1022).exponent == -1022);
  CHECK(DoubleParts(largest).exponent == 971);
  CHECK(DoubleParts(largest).magnitude == (std::uint64_t{1} << 53) - 1);
}

// Catches: the hidden bit given to subnormals, an exponent off by one, a unit that is not the smallest.
TEST_CASE("lattice integers times the unit give the doubles back", "[exact][property]") {
  Random random(2);
  for (int i = 0; i < 1500; ++i) {
    CAPTURE(i);
    std::vector<double> numbers;
    for (int k = random.between(1, 9); k > 0; --k) {
      switch (i % 4) {
        case 0:
          numbers.push_back(any_double(random));
          break;
        case 1:
          numbers.push_back(subnormal(random));
          break;
        case 2:
          numbers.push_back(near_one(random));
          break;
        case 3:
          numbers.push_back(random.once_in(2) ? near_one(random) * 0x1p-1040 : near_one(random));
          break;
      }
    }
    check_lattice(numbers);
  }
}

TEST_CASE("the extremes share a lattice", "[exact]") {
  check_lattice({tiniest, -largest});
  check_lattice({0.0, -0.0});
  check_lattice({1e-300, 1e300, -1e-300});
  check_lattice({0x1p127, 1.0});
  Lattice all;
  all.add(tiniest);
  all.add(-largest);
  CHECK(all.unit() == -1074);
  CHECK(all.bits() == 2098);
}

TEST_CASE("the bits of a lattice are the fewest that hold its integers", "[exact]") {
  Lattice lattice;
  CHECK(lattice.bits() == 1);
  lattice.add(0);
  CHECK(lattice.bits() == 1);
  lattice.add(-8);
  CHECK(lattice.bits() == 1);
  CHECK(lattice.unit() == 3);
  lattice.add(7);
  CHECK(lattice.unit() == 0);
  CHECK(lattice.bits() == 4);
  lattice.add(0.25);
  CHECK(lattice.bits() == 6);
}
