#include "core/exact/big_integer.h"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/exact/cpp_fraction.h"
#include "support/random.h"

using namespace strata;

namespace {

using test::Random;

/// Of up to `bits` bits, with either sign; runs of zeros and ones are frequent.
Integer random_integer(Random& random, int bits) {
  Integer r = 0;
  const int size = random.between(0, bits);
  for (int done = 0; done < size;) {
    const int run = std::min(size - done, random.between(1, 64));
    const std::uint64_t word = random.once_in(2) ? random.next() : random.once_in(2) ? ~std::uint64_t{0} : 0;
    r = (r << static_cast<std::size_t>(run)) + (word >> (64 - run));
    done += run;
  }
  return random.once_in(2) ? r : Integer(-r);
}

/// Many small numbers, some of 10,000 bits.
int random_size(Random& random) {
  const std::array<int, 6> sizes{3, 64, 130, 300, 1'000, 10'000};
  return sizes[random.below(random.once_in(20) ? 6 : 5)];
}

Integer random_integer(Random& random) { return random_integer(random, random_size(random)); }

Integer random_divisor(Random& random) {
  for (;;)
    if (Integer d = random_integer(random); d != 0) return d;
}

Rational random_fraction(Random& random) {
  if (random.once_in(8)) return random_integer(random);
  if (random.once_in(4)) return {random_integer(random), Integer(1) << random.below(1'200)};
  return {random_integer(random), random_divisor(random)};
}

void require_lowest_terms(const Rational& x) {
  const Integer n = numerator(x), d = denominator(x);
  REQUIRE(d > 0);
  REQUIRE(n.sign() == x.sign());
  REQUIRE(gcd(n, d) == 1);
}

bool is_integer(const Rational& x) { return denominator(x) == 1; }

std::uint64_t modulo(const std::string& digits, std::uint64_t m) {
  std::uint64_t r = 0;
  for (const char c : digits)
    if (c != '-') r = (r * 10 + static_cast<std::uint64_t>(c - '0')) % m;
  return r;
}

}  // namespace

TEST_CASE("integers obey the laws of a ring", "[exact][property]") {
  Random random(11);
  for (int i = 0; i < 3'000; ++i) {
    const Integer a = random_integer(random), b = random_integer(random), c = random_integer(random);
    REQUIRE(a + b == b + a);
    REQUIRE((a + b) + c == a + (b + c));
    REQUIRE((a + b) - b == a);
    REQUIRE(a - b == -(b - a));
    REQUIRE(a * b == b * a);
    REQUIRE((a * b) * c == a * (b * c));
    REQUIRE(a * (b + c) == a * b + a * c);
    REQUIRE((a + b) * (a - b) == a * a - b * b);
    REQUIRE((a * b).sign() == a.sign() * b.sign());
    REQUIRE((a <=> b) == ((a - b).sign() <=> 0));
  }
}

// Catches: a remainder of the wrong sign, a digit of a quotient that is one off.
TEST_CASE("integers are divided as built-in ones are", "[exact][property]") {
  Random random(12);
  for (int i = 0; i < 3'000; ++i) {
    const Integer a = random_integer(random), b = random_divisor(random);
    const Integer q = a / b, r = a % b;
    REQUIRE(q * b + r == a);
    REQUIRE(abs(r) < abs(b));
    REQUIRE((r == 0 || r.sign() == a.sign()));
    REQUIRE(divide(a, b) == std::pair(q, r));
    REQUIRE(exact_quotient(a * b, b) == a);
    REQUIRE(exact_quotient(Integer(a << 77), Integer(1) << 77) == a);
    const std::size_t bits = random.below(200);
    REQUIRE((a << bits) == a * pow(Integer(2), static_cast<unsigned>(bits)));
    const Integer unit = pow(Integer(2), static_cast<unsigned>(bits)), down = a >> bits;
    REQUIRE((down * unit <= a && a < (down + 1) * unit));
  }
  CHECK_THROWS_AS(Integer(1) / Integer(0), std::overflow_error);
  CHECK_THROWS_AS(Integer(1) % Integer(0), std::overflow_error);
  CHECK_THROWS_AS(divide(Integer(1), Integer(0)), std::overflow_error);
  CHECK_THROWS_AS(exact_quotient(Integer(1), Integer(0)), std::overflow_error);
}

TEST_CASE("common divisors divide, and what is left has none", "[exact][property]") {
  Random random(13);
  for (int i = 0; i < 2'000; ++i) {
    const Integer k = random_divisor(random), a = random_integer(random) * k, b = random_divisor(random) * k;
    const Integer g = gcd(a, b);
    REQUIRE(g > 0);
    REQUIRE(a % g == 0);
    REQUIRE(b % g == 0);
    REQUIRE(g % k == 0);
    REQUIRE(gcd(a / g, b / g) == 1);
    REQUIRE(lcm(a, b) * g == abs(a * b));
  }
  CHECK(gcd(Integer(0), Integer(-6)) == 6);
  CHECK(gcd(Integer(-6), Integer(0)) == 6);
  CHECK(gcd(Integer(0), Integer(0)) == 0);
}

TEST_CASE("roots and powers are those of their definitions", "[exact][property]") {
  Random random(14);
  for (int i = 0; i < 500; ++i) {
    const Integer a = abs(random_integer(random, 2'000)), root = sqrt(a);
    REQUIRE((root * root <= a && a < (root + 1) * (root + 1)));
    const Integer b = random_integer(random, 100);
    REQUIRE(pow(b, 5) == b * b * b * b * b);
    REQUIRE(pow(b, 0) == 1);
  }
  CHECK_THROWS_AS(sqrt(Integer(-1)), std::domain_error);
}

TEST_CASE("integers survive their text, their limbs and built-in integers", "[exact][property]") {
  Random random(15);
  for (int i = 0; i < 1'000; ++i) {
    const Integer a = random_integer(random);
    const std::string text = a.str();
    REQUIRE(Integer(text) == a);
    constexpr std::uint32_t prime = 4'294'967'291U;
    REQUIRE(Integer(modulo(text, prime)) == abs(a) % prime);
    REQUIRE(Integer("+000" + abs(a).str()) == abs(a));
    REQUIRE(integer_of_limbs(limbs_of(a), a < 0) == a);
    REQUIRE((a == 0) == limbs_of(a).empty());
    REQUIRE((a == 0 || limbs_of(a).back() != 0));
    const auto small = static_cast<std::int64_t>(random.next());
    REQUIRE(Integer(small).to_int64() == small);
    REQUIRE((a <=> small) == (a <=> Integer(small)));
    REQUIRE((a <=> random.next()) != std::strong_ordering::equal);
  }
  const std::vector<std::uint64_t> zeros(5);
  CHECK(integer_of_limbs(zeros, true) == 0);
  CHECK(integer_of_limbs({}, true).sign() == 0);
  CHECK((-Integer(0)).str() == "0");
  CHECK(Integer("-0") == 0);
  for (const char* text : {"", "-", "+-1", "1 ", "0x10", "1e3", "--1"})
    CHECK_THROWS_AS(Integer(text), std::invalid_argument);
  using Limits = std::numeric_limits<std::int64_t>;
  CHECK(Integer(Limits::min()).to_int64() == Limits::min());
  CHECK_THROWS_AS((Integer(Limits::max()) + 1).to_int64(), std::overflow_error);
  CHECK_THROWS_AS((Integer(Limits::min()) - 1).to_int64(), std::overflow_error);
}

// Catches: rounding twice, ties that go up, bits below the half that are overlooked.
TEST_CASE("integers are rounded to the nearest double", "[exact][property]") {
  Random random(16);
  for (int i = 0; i < 20'000; ++i) {
    const Integer a = random_integer(random, random.once_in(2) ? 130 : 1'100);
    REQUIRE(a.to_double() == to_nearest_double(Rational(a)));
    const double x = std::ldexp(static_cast<double>(random.next() >> 11), random.between(0, 900));
    REQUIRE(Integer(x).to_double() == x);
    REQUIRE(Rational(Integer(x)) == to_rational(x));
    REQUIRE(Integer(-x) == -Integer(x));
  }
  const Integer one = 1, even = one << 53;
  CHECK((even + 1).to_double() == 0x1p53);
  CHECK((even + 3).to_double() == 0x1p53 + 4);
  CHECK(((even + 1) << 200).to_double() == 0x1p253);
  CHECK((((even + 1) << 200) + 1).to_double() == std::nextafter(0x1p253, HUGE_VAL));
  CHECK((-(((even + 1) << 200) + 1)).to_double() == -std::nextafter(0x1p253, HUGE_VAL));
  const Integer largest = (one << 1024) - (one << 971), half = one << 970;
  CHECK(largest.to_double() == std::numeric_limits<double>::max());
  CHECK((largest + half - 1).to_double() == std::numeric_limits<double>::max());
  CHECK(std::isinf((largest + half).to_double()));
  CHECK((-(one << 5'000)).to_double() == -HUGE_VAL);
  CHECK(Integer(-2.9) == -2);
  CHECK_THROWS_AS(Integer(HUGE_VAL), std::invalid_argument);
}

TEST_CASE("integers are rounded to 64 bits of a long double", "[exact]") {
  if (std::numeric_limits<long double>::digits != 64) return;
  const Integer even = Integer(1) << 64;
  CHECK(to_nearest_long_double(even - 1) == 0x1p64L - 1);
  CHECK(to_nearest_long_double(even + 1) == 0x1p64L);
  CHECK(to_nearest_long_double(even + 3) == 0x1p64L + 4);
  CHECK(to_nearest_long_double((even << 1) - 1) == 0x1p65L);
  CHECK(to_nearest_long_double(-(even + 3)) == -(0x1p64L + 4));
  CHECK(to_nearest_long_double(0) == 0);
}

TEST_CASE("fractions obey the laws of a field, in lowest terms", "[exact][property]") {
  Random random(17);
  for (int i = 0; i < 1'500; ++i) {
    const Rational a = random_fraction(random), b = random_fraction(random);
    const Integer n = numerator(a), d = denominator(a), m = numerator(b), e = denominator(b);
    for (const Rational& x : {a, a + b, a - b, a * b, -a, abs(a)}) require_lowest_terms(x);
    REQUIRE(a + b == Rational(n * e + m * d, d * e));
    REQUIRE(a - b == Rational(n * e - m * d, d * e));
    REQUIRE(a * b == Rational(n * m, d * e));
    REQUIRE(a - a == 0);
    REQUIRE(is_integer(a - a));
    REQUIRE((a + b) - b == a);
    if (b != 0) {
      require_lowest_terms(a / b);
      REQUIRE(a / b == Rational(n * e, d * m));
      REQUIRE(a / b * b == a);
    }
    Rational c = a;
    c += c;
    REQUIRE(c == a * 2);
    c -= c;
    REQUIRE(c == 0);
    c = b;
    c *= c;
    REQUIRE(c == b * b);
  }
  CHECK_THROWS_AS(Rational(1) / Rational(0), std::overflow_error);
  CHECK_THROWS_AS(Rational(Integer(1), Integer(0)), std::overflow_error);
}

TEST_CASE("fractions are reduced however they are given", "[exact][property]") {
  Random random(18);
  for (int i = 0; i < 1'500; ++i) {
    const Rational x = random_fraction(random);
    const Integer k = random_divisor(random);
    const Rational same(numerator(x) * k, denominator(x) * k);
    require_lowest_terms(same);
    REQUIRE(same == x);
    REQUIRE(same.str() == x.str());
    REQUIRE(Rational(x.str()) == x);
    REQUIRE(Rational((numerator(x) * k).str() + "/" + abs(denominator(x) * k).str()) == (k > 0 ? x : -x));
  }
  CHECK(Rational(Integer(6), Integer(-4)).str() == "-3/2");
  CHECK(Rational(Integer(0), Integer(-4)).str() == "0");
  CHECK(denominator(Rational(Integer(0), Integer(-4))) == 1);
  CHECK(Rational("-7").str() == "-7");
  CHECK(Rational("010/4").str() == "5/2");
  CHECK_THROWS_AS(Rational("1/0"), std::overflow_error);
  for (const char* text : {"", "/", "1/", "/2", "1/2/3", "1.5", "1/ 2"})
    CHECK_THROWS_AS(Rational(text), std::invalid_argument);
}

TEST_CASE("fractions are ordered as their differences are", "[exact][property]") {
  Random random(19);
  for (int i = 0; i < 2'000; ++i) {
    const Rational a = random_fraction(random);
    const Rational b =
        random.once_in(3) ? a + Rational(random_integer(random, 3), random_divisor(random)) : random_fraction(random);
    REQUIRE((a <=> b) == ((a - b).sign() <=> 0));
    REQUIRE((a == b) == ((a - b).sign() == 0));
    const int k = random.between(-5, 5);
    REQUIRE((a <=> k) == (a <=> Rational(k)));
    REQUIRE((a == k) == (a == Rational(k)));
    REQUIRE((Rational(k) <=> k) == std::strong_ordering::equal);
  }
}

TEST_CASE("doubles are fractions over powers of two", "[exact][property]") {
  Random random(20);
  const double least = std::numeric_limits<double>::denorm_min();
  for (int i = 0; i < 5'000; ++i) {
    const double x = std::ldexp(random.unit() - 0.5, random.between(-1'074, 1'023));
    const Rational q(x);
    require_lowest_terms(q);
    const std::size_t power = bit_length(denominator(q)) - 1;
    REQUIRE(denominator(q) == Integer(1) << power);
    REQUIRE(std::ldexp(numerator(q).to_double(), -static_cast<int>(power)) == x);
    REQUIRE(to_nearest_double(q) == x);
  }
  CHECK(Rational(-0.0) == 0);
  CHECK(Rational(least) == Rational(Integer(1), Integer(1) << 1'074));
  CHECK(to_nearest_double(Rational(least) / 2) == 0);
  CHECK(to_nearest_double(Rational(least) / 2 + Rational(least) / 1'000) == least);
  CHECK(to_nearest_double(Rational(least) * Rational(3, 2)) == 2 * least);
  CHECK_THROWS_AS(Rational(HUGE_VAL), std::invalid_argument);
}

TEST_CASE("a long chain of fractions comes back to where it began", "[exact][property]") {
  Random random(21);
  Rational sum = 0, product = 1;
  std::vector<Rational> terms;
  for (int i = 0; i < 200; ++i) {
    terms.emplace_back(Integer(random.below(1'000'000) + 1), Integer(random.below(1'000'000) + 1));
    sum += terms.back();
    product *= terms.back();
  }
  require_lowest_terms(sum);
  require_lowest_terms(product);
  for (const Rational& x : terms) {
    sum -= x;
    product /= x;
  }
  CHECK(sum == 0);
  CHECK(product == 1);
}

// Catches: storage that is aligned less than the number inside it; a move that leaves something broken.
TEST_CASE("numbers stand in arrays and vectors, and survive moves", "[exact]") {
  struct Odd {
    char c = 0;
    Integer x = 7;
    char d = 0;
    Rational y = Rational(1, 3);
  };
  std::vector<Odd> odd(33);
  std::vector<Integer> integers;
  for (int i = 0; i < 100; ++i) integers.push_back(pow(Integer(3), static_cast<unsigned>(7 * i)));
  const std::array<Rational, 3> point{Rational(1, 2), Rational(2, 3), Rational(3, 4)};
  for (const Odd& o : odd) {
    CHECK(reinterpret_cast<std::uintptr_t>(&o.x) % alignof(detail::BigInteger) == 0);
    CHECK(reinterpret_cast<std::uintptr_t>(&o.y) % alignof(detail::BigRational) == 0);
  }
  for (std::size_t i = 0; i < integers.size(); ++i) {
    CHECK(reinterpret_cast<std::uintptr_t>(&integers[i]) % alignof(detail::BigInteger) == 0);
    CHECK(integers[i] == pow(Integer(3), static_cast<unsigned>(7 * i)));
  }
  CHECK(std::accumulate(point.begin(), point.end(), Rational(0)) == Rational(23, 12));
  Integer a = pow(Integer(10), 300), b = std::move(a);
  a = 5;  // NOLINT(bugprone-use-after-move): a value may be given to what was moved from
  CHECK(b == pow(Integer(10), 300));
  std::swap(a, b);
  CHECK(b == 5);
  CHECK(a.str() == "1" + std::string(300, '0'));
  const Rational q(a, Integer(7));
  Rational r = q;
  const Rational& self = r;
  r = self;
  CHECK(r == q);
  CHECK(-std::move(r) == Rational(-a, Integer(7)));
}

// Where numbers are GMP's, this compares it with the other back end.
TEST_CASE("cpp_int's fractions have the text of those in use", "[exact][property]") {
  Random random(22);
  const auto copy = [](const Rational& x) {
    return detail::CppFraction(detail::CppInteger(numerator(x).str()), detail::CppInteger(denominator(x).str()));
  };
  for (int i = 0; i < 800; ++i) {
    const Rational a = random_fraction(random), b = random_fraction(random);
    const detail::CppFraction c = copy(a), d = copy(b);
    REQUIRE(c.str() == a.str());
    REQUIRE((c + d).str() == (a + b).str());
    REQUIRE((c - d).str() == (a - b).str());
    REQUIRE((c * d).str() == (a * b).str());
    if (b != 0) REQUIRE((c / d).str() == (a / b).str());
    REQUIRE((c.compare(d) <=> 0) == (a <=> b));
    const double x = to_nearest_double(a);
    if (std::isfinite(x)) REQUIRE(detail::CppFraction(x).str() == to_rational(x).str());
  }
}
