#include "core/exact/wide_int.h"

#include <boost/multiprecision/cpp_int.hpp>
#include <catch2/catch.hpp>

#include "support/random.h"

using namespace strata;

namespace {

using Reference = boost::multiprecision::cpp_int;
using test::Random;

constexpr std::uint64_t ones = ~std::uint64_t{0};

/// The integer that two's complement limbs stand for.
template <int Limbs>
Reference value_of(const WideInt<Limbs>& x) {
  Reference r = 0;
  for (int i = Limbs - 1; i >= 0; --i) r = (r << 64) | Reference(x.limbs()[static_cast<std::size_t>(i)]);
  if ((x.limbs()[Limbs - 1] >> 63) != 0) r -= Reference(1) << (64 * Limbs);
  return r;
}

/// x modulo 2^(64 Limbs), in the range of signed integers.
template <int Limbs>
Reference wrapped(Reference x) {
  const Reference modulus = Reference(1) << (64 * Limbs);
  x %= modulus;
  if (x < 0) x += modulus;
  return x >= (modulus >> 1) ? Reference(x - modulus) : x;
}

int sign_of_reference(const Reference& x) { return x.sign(); }

/// Limbs from 0, 1, all ones, the top bit and random words: carries and borrows run through all of them.
template <int Limbs>
WideInt<Limbs> random_wide(Random& random) {
  WideInt<Limbs> r;
  for (int i = 0; i < Limbs; ++i) {
    const std::uint64_t words[] = {0, 0, ones, ones, 1, std::uint64_t{1} << 63, ones - 1, random.next()};
    const std::uint64_t word = words[random.below(8)];
    r = r + WideInt<Limbs>::shifted(word, 64 * i, false);
  }
  return r;
}

template <int Limbs>
void check_one(const WideInt<Limbs>& a, const WideInt<Limbs>& b) {
  const Reference x = value_of(a), y = value_of(b);
  REQUIRE(value_of(a + b) == wrapped<Limbs>(x + y));
  REQUIRE(value_of(a - b) == wrapped<Limbs>(x - y));
  REQUIRE(value_of(a * b) == wrapped<Limbs>(x * y));
  REQUIRE(value_of(-a) == wrapped<Limbs>(-x));
  REQUIRE(to_int(a.sign()) == sign_of_reference(x));
  REQUIRE((a == b) == (x == y));
}

}  // namespace

// Catches: a carry or borrow dropped between limbs, a partial product left out, the sign read from a wrong limb.
TEMPLATE_TEST_CASE_SIG("wide integers agree with unbounded ones modulo their width", "[exact][property]",
                       ((int Limbs), Limbs), 1, 2, 3, 4, 8, 16) {
  Random random(20240 + Limbs);
  for (int i = 0; i < 3000; ++i) check_one(random_wide<Limbs>(random), random_wide<Limbs>(random));
}

TEMPLATE_TEST_CASE_SIG("a carry and a borrow run through every limb", "[exact]", ((int Limbs), Limbs), 1, 2, 4, 8, 16) {
  const WideInt<Limbs> minus_one(-1), one(1), zero(0);
  CHECK(minus_one + one == zero);
  CHECK(zero - one == minus_one);
  CHECK(minus_one * minus_one == one);
  CHECK(-one == minus_one);
  const auto lowest = WideInt<Limbs>::shifted(1, 64 * Limbs - 1, false);
  CHECK(lowest.sign() == Sign::negative);
  CHECK((lowest - one).sign() == Sign::positive);
  CHECK(-lowest == lowest);
}

TEMPLATE_TEST_CASE_SIG("small integers keep their value and sign", "[exact]", ((int Limbs), Limbs), 1, 2, 4, 8, 16) {
  for (const std::int64_t x : {std::int64_t{0}, std::int64_t{1}, std::int64_t{-1}, INT64_MAX, INT64_MIN}) {
    CHECK(value_of(WideInt<Limbs>(x)) == Reference(x));
    CHECK(to_int(WideInt<Limbs>(x).sign()) == sign_of_reference(Reference(x)));
  }
}

TEMPLATE_TEST_CASE_SIG("a shifted magnitude is the product with a power of two", "[exact][property]",
                       ((int Limbs), Limbs), 2, 3, 4, 8, 16) {
  Random random(7 * Limbs);
  for (int shift = 0; shift + 64 < 64 * Limbs; ++shift) {
    for (const std::uint64_t m : {std::uint64_t{1}, ones, random.next()}) {
      REQUIRE(value_of(WideInt<Limbs>::shifted(m, shift, false)) == Reference(m) << shift);
      REQUIRE(value_of(WideInt<Limbs>::shifted(m, shift, true)) == -(Reference(m) << shift));
    }
  }
}

// The product of the largest numbers that fit: every partial product carries.
TEMPLATE_TEST_CASE_SIG("products of full magnitudes are exact", "[exact]", ((int Limbs), Limbs), 2, 4, 8, 16) {
  const WideInt<Limbs> one(1);
  const auto half = WideInt<Limbs>::shifted(1, 32 * Limbs - 1, false) - one;  // 2^(bits/2 - 1) - 1
  check_one(half, half);
  check_one(-half, half);
  check_one(-half, -half);
  CHECK((half * half).sign() == Sign::positive);
  CHECK((-half * half).sign() == Sign::negative);
}
