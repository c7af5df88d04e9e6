#include "core/exact/limbs.h"

#include <array>
#include <catch2/catch.hpp>
#include <vector>

#include "core/exact/big_integer.h"
#include "support/random.h"

using namespace strata;

namespace {

using limbs::Limb;
using limbs::TwoLimbs;
using test::Random;
using Limbs = std::vector<Limb>;

/// Zeros, ones, all ones, top bits and random limbs: carries and borrows run through them.
Limb random_limb(Random& random) {
  const Limb ones = ~Limb{0};
  const Limb limbs[] = {0, ones, 1, Limb{1} << 63, ones - 1, random.next(), random.next(), random.next() >> 32};
  return limbs[random.below(8)];
}

/// With a highest limb that is not zero.
Limbs random_limbs(Random& random, int size) {
  Limbs r(static_cast<std::size_t>(size));
  for (Limb& limb : r) limb = random_limb(random);
  while (r.back() == 0) r.back() = random_limb(random);
  return r;
}

Integer value(const Limbs& x) { return integer_of_limbs(x, false); }
Integer value(const Limbs& x, int size) { return integer_of_limbs({x.data(), static_cast<std::size_t>(size)}, false); }
int size(const Limbs& x) { return static_cast<int>(x.size()); }

/// The functions in use, and those in plain C++ where others are in use.
struct InUse {
  static constexpr auto add = limbs::add;
  static constexpr auto subtract = limbs::subtract;
  static constexpr auto multiply = limbs::multiply;
  static constexpr auto divide = limbs::divide;
  static constexpr auto gcd = limbs::gcd;
  static constexpr auto shift_left = limbs::shift_left;
  static constexpr auto shift_right = limbs::shift_right;
  static constexpr auto compare = limbs::compare;
};
struct Portable {
  static constexpr auto add = limbs::portable::add;
  static constexpr auto subtract = limbs::portable::subtract;
  static constexpr auto multiply = limbs::portable::multiply;
  static constexpr auto divide = limbs::portable::divide;
  static constexpr auto gcd = limbs::portable::gcd;
  static constexpr auto shift_left = limbs::portable::shift_left;
  static constexpr auto shift_right = limbs::portable::shift_right;
  static constexpr auto compare = limbs::portable::compare;
};

template <class Set>
void check_sums(const Limbs& a, const Limbs& b) {
  Limbs r(a.size() + 1);
  r.back() = Set::add(r.data(), a.data(), size(a), b.data(), size(b));
  REQUIRE(value(r) - value(a) == value(b));
  Limbs back(r.size());
  Set::subtract(back.data(), r.data(), size(r), b.data(), size(b));
  REQUIRE(value(back) == value(a));
  REQUIRE(back.back() == 0);
  Set::subtract(r.data(), r.data(), size(r), a.data(), size(a));
  REQUIRE(value(r) == value(b));
}

template <class Set>
void check_shifts(const Limbs& a, int bits) {
  Limbs r(a.size() + 1);
  r.back() = Set::shift_left(r.data(), a.data(), size(a), bits);
  REQUIRE(value(r) == value(a) * pow(Integer(2), static_cast<unsigned>(bits)));
  Set::shift_right(r.data(), r.data(), size(r), bits);
  REQUIRE(value(r) == value(a));
  Set::shift_right(r.data(), a.data(), size(a), bits);
  REQUIRE(value(r, size(a)) == value(a) / pow(Integer(2), static_cast<unsigned>(bits)));
}

/// The product is tested by its remainders modulo three primes, quotients by the product.
template <class Set>
void check_product_and_quotient(const Limbs& a, const Limbs& b) {
  Limbs p(a.size() + b.size());
  Set::multiply(p.data(), a.data(), size(a), b.data(), size(b));
  for (const std::uint64_t prime : std::array<std::uint64_t, 3>{0xffffffffffffffc5U, 0xfffffffbU, 1'000'003U}) {
    const Integer m = prime;
    REQUIRE(value(p) % m == ((value(a) % m) * (value(b) % m)) % m);
  }
  Limbs q(a.size() - b.size() + 1), rest(a.size());
  Set::divide(q.data(), rest.data(), a.data(), size(a), b.data(), size(b));
  REQUIRE(value(rest, size(b)) < value(b));
  REQUIRE(value(q) * value(b) + value(rest, size(b)) == value(a));
  Limbs same = a;
  Set::divide(q.data(), same.data(), same.data(), size(same), b.data(), size(b));
  REQUIRE(value(same, size(b)) == value(rest, size(b)));
}

template <class Set>
Integer found_gcd(Limbs a, Limbs b) {
  Limbs r(b.size());
  b.resize(a.size());
  const int of_b = size(r);
  const int n = Set::gcd(r.data(), a.data(), size(a), b.data(), of_b);
  REQUIRE((n > 0 && r[static_cast<std::size_t>(n) - 1] != 0));
  return value(r, n);
}

Integer euclid(Integer a, Integer b) {
  while (b != 0) a = std::exchange(b, a % b);
  return a;
}

}  // namespace

// Catches: a carry, a borrow or a limb of a shift that is lost, a digit of a quotient that is one off.
TEMPLATE_TEST_CASE("limbs obey the laws of arithmetic", "[exact][property]", InUse, Portable) {
  Random random(5);
  for (int i = 0; i < 20'000; ++i) {
    const int n = random.between(1, i % 100 == 0 ? 80 : 9), m = random.between(1, n);
    const Limbs a = random_limbs(random, n), b = random_limbs(random, m);
    check_sums<TestType>(a, b);
    check_shifts<TestType>(a, random.between(1, 63));
    check_product_and_quotient<TestType>(a, b);
    Limbs c = random_limbs(random, n);
    REQUIRE(TestType::compare(a.data(), a.data(), n) == 0);
    const int order = TestType::compare(a.data(), c.data(), n);
    REQUIRE((order > 0) == (value(a) > value(c)));
    REQUIRE((order < 0) == (value(a) < value(c)));
  }
}

// Divisors of which the two highest limbs begin the dividend: the digit guessed is the highest limb, or one too large.
TEMPLATE_TEST_CASE("quotients are right where their digits are guessed wrongly", "[exact][degenerate]", InUse,
                   Portable) {
  Random random(6);
  for (int i = 0; i < 20'000; ++i) {
    const int m = random.between(2, 6);
    const Limbs b = random_limbs(random, m);
    Integer a = (value(b) << static_cast<std::size_t>(64 * random.between(1, 4))) - 1 - random.below(3);
    if (random.once_in(2)) a -= integer_of_limbs(random_limbs(random, 1), false);
    const auto limbs = limbs_of(a);
    check_product_and_quotient<TestType>(Limbs(limbs.begin(), limbs.end()), b);
  }
}

// Catches: cofactors taken for longer than they hold, a swap or a sign of them missed, a divisor not the greatest.
TEMPLATE_TEST_CASE("common divisors are those of Euclid's algorithm", "[exact][property]", InUse, Portable) {
  Random random(7);
  for (int i = 0; i < 5'000; ++i) {
    const int longest = i % 50 == 0 ? 40 : 5;
    Integer a = value(random_limbs(random, random.between(1, longest)));
    Integer b = random.once_in(4) ? a + random.below(100) : value(random_limbs(random, random.between(1, longest)));
    const Integer factor = value(random_limbs(random, random.between(1, longest)));
    if (!random.once_in(3)) a *= factor, b *= factor;
    b >>= trailing_zeros(b);
    a >>= trailing_zeros(a);
    if (limbs_of(a).size() < limbs_of(b).size()) std::swap(a, b);
    const auto x = limbs_of(a), y = limbs_of(b);
    REQUIRE(found_gcd<TestType>(Limbs(x.begin(), x.end()), Limbs(y.begin(), y.end())) == euclid(a, b));
  }
}

TEMPLATE_TEST_CASE("common divisors of neighbours in Fibonacci's sequence are one", "[exact]", InUse, Portable) {
  Integer a = 1, b = 1;
  for (int i = 0; i < 2'000; ++i) {
    a = std::exchange(b, a + b);
    const bool is_odd = limb_or_zero(limbs_of(a), 0) % 2 == 1;
    if (i < 2 || !is_odd) continue;
    const auto x = limbs_of(b), y = limbs_of(a);
    REQUIRE(found_gcd<TestType>(Limbs(x.begin(), x.end()), Limbs(y.begin(), y.end())) == 1);
  }
}

// Catches: a carry between halves that is lost.
TEST_CASE("products and quotients by halves are those of the machine", "[exact][property]") {
  Random random(8);
  for (int i = 0; i < 50'000; ++i) {
    const Limb a = random_limb(random), b = random_limb(random), d = random_limb(random) | Limb{1} << 63;
    const TwoLimbs p = limbs::portable::product_of_halves(a, b), q = limbs::portable::product(a, b);
    REQUIRE((p.high == q.high && p.low == q.low));
    const TwoLimbs n{a % d, b};
    REQUIRE(limbs::portable::quotient_by_halves(n, d) == limbs::portable::quotient(n, d));
  }
}
