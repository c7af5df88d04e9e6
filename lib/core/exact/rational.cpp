#include "strata/rational.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <ostream>
#include <span>
#include <stdexcept>
#include <string>

#include "core/exact/big_integer.h"

namespace strata {
namespace {

using detail::BigInteger;
using detail::Native;

void require_finite(double x) {
  if (!std::isfinite(x)) throw std::invalid_argument("a number that is not finite has no exact value");
}

bool is_integer_text(std::string_view text) {
  if (!text.empty() && (text[0] == '-' || text[0] == '+')) text.remove_prefix(1);
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

/// Of digits that may have leading zeros, which Boost would take for octal numbers.
BigInteger integer_of_text(std::string_view text) {
  if (!is_integer_text(text)) throw std::invalid_argument("not an integer: '" + std::string(text) + "'");
  const bool is_negative = text[0] == '-';
  text.remove_prefix(std::min(text.find_first_not_of("+-0"), text.size()));
  if (text.empty()) return 0;
  BigInteger x{std::string(text)};
  return is_negative ? -x : x;
}

void require_divisor(bool is_zero) {
  if (is_zero) throw std::overflow_error("division by zero");
}

}  // namespace

// Integer

Integer::Integer() noexcept { Native::construct(*this); }
void Integer::make(std::int64_t x) { Native::construct(*this, x); }
void Integer::make(std::uint64_t x) { Native::construct(*this, x); }
Integer::Integer(double x) {
  require_finite(x);
  Native::construct(*this, std::trunc(x));
}
Integer::Integer(std::string_view digits) { Native::construct(*this, integer_of_text(digits)); }
Integer::Integer(const Integer& other) { Native::construct(*this, native(other)); }
Integer::Integer(Integer&& other) noexcept { Native::construct(*this, std::move(native(other))); }
Integer& Integer::operator=(
    const Integer& other) {  // NOLINT(bugprone-unhandled-self-assignment): the number inside does
  native(*this) = native(other);
  return *this;
}
Integer& Integer::operator=(Integer&& other) noexcept {
  native(*this) = std::move(native(other));
  return *this;
}
Integer::~Integer() { std::destroy_at(&native(*this)); }

Integer& Integer::operator+=(const Integer& b) {
  native(*this) += native(b);
  return *this;
}
Integer& Integer::operator-=(const Integer& b) {
  native(*this) -= native(b);
  return *this;
}
Integer& Integer::operator*=(const Integer& b) {
  native(*this) *= native(b);
  return *this;
}
Integer& Integer::operator/=(const Integer& b) {
  require_divisor(b.is_zero());
  native(*this) = detail::quotient(native(*this), native(b));
  return *this;
}
Integer& Integer::operator%=(const Integer& b) {
  require_divisor(b.is_zero());
  native(*this) = detail::remainder(native(*this), native(b));
  return *this;
}
Integer& Integer::operator<<=(std::size_t bits) {
  native(*this) <<= bits;
  return *this;
}
Integer& Integer::operator>>=(std::size_t bits) {
  native(*this) >>= bits;
  return *this;
}
Integer Integer::operator-() const& { return Native::integer(-native(*this)); }
Integer Integer::operator-() && {
  detail::negate(native(*this));
  return std::move(*this);
}

int Integer::sign() const noexcept { return native(*this).sign(); }
std::strong_ordering Integer::compare(const Integer& b) const noexcept {
  return native(*this).compare(native(b)) <=> 0;
}
std::strong_ordering Integer::compare(std::int64_t b) const noexcept {
  return b == 0 ? sign() <=> 0 : native(*this).compare(b) <=> 0;
}
std::strong_ordering Integer::compare(std::uint64_t b) const noexcept {
  return b == 0 ? sign() <=> 0 : native(*this).compare(b) <=> 0;
}
std::string Integer::str() const { return native(*this).str(); }
std::int64_t Integer::to_int64() const {
  if (compare(std::numeric_limits<std::int64_t>::min()) < 0 || compare(std::numeric_limits<std::int64_t>::max()) > 0)
    throw std::overflow_error("an integer that does not fit into 64 bits: " + str());
  return native(*this).convert_to<std::int64_t>();
}

Integer operator+(const Integer& a, const Integer& b) { return Native::integer(native(a) + native(b)); }
Integer operator-(const Integer& a, const Integer& b) { return Native::integer(native(a) - native(b)); }
Integer operator*(const Integer& a, const Integer& b) { return Native::integer(native(a) * native(b)); }
Integer operator/(const Integer& a, const Integer& b) {
  require_divisor(b.is_zero());
  return Native::integer(detail::quotient(native(a), native(b)));
}
Integer operator%(const Integer& a, const Integer& b) {
  require_divisor(b.is_zero());
  return Native::integer(detail::remainder(native(a), native(b)));
}

Integer abs(const Integer& x) { return x.sign() < 0 ? -x : x; }
Integer gcd(const Integer& a, const Integer& b) {
  return Native::integer(detail::common_divisor(native(a), native(b)));
}
Integer lcm(const Integer& a, const Integer& b) { return Native::integer(lcm(native(a), native(b))); }
Integer pow(const Integer& base, unsigned exponent) { return Native::integer(pow(native(base), exponent)); }
Integer sqrt(const Integer& x) {
  if (x.sign() < 0) throw std::domain_error("the square root of a negative integer");
  return Native::integer(sqrt(native(x)));
}
std::pair<Integer, Integer> divide(const Integer& a, const Integer& b) {
  require_divisor(b.is_zero());
  std::pair<Integer, Integer> r;
  detail::divide(native(a), native(b), native(r.first), native(r.second));
  return r;
}
std::size_t bit_length(const Integer& x) noexcept {
  const auto limbs = limbs_of(x);
  return limbs.empty() ? 0 : 64 * (limbs.size() - 1) + static_cast<std::size_t>(std::bit_width(limbs.back()));
}
std::size_t trailing_zeros(const Integer& x) noexcept {
  const auto limbs = limbs_of(x);
  for (std::size_t i = 0; i < limbs.size(); ++i)
    if (limbs[i] != 0) return 64 * i + static_cast<std::size_t>(std::countr_zero(limbs[i]));
  return 0;
}
std::ostream& operator<<(std::ostream& out, const Integer& x) { return out << x.str(); }

Integer integer_of_limbs(std::span<const std::uint64_t> magnitude, bool is_negative) {
  Integer r;
  detail::assign(native(r), magnitude, is_negative);
  return r;
}

Integer exact_quotient(const Integer& a, const Integer& b) {
  require_divisor(b.is_zero());
  return Native::integer(detail::exact_quotient(native(a), native(b)));
}

// Rational

Rational::Rational() { Native::construct(*this); }
Rational::Rational(const Integer& x) { Native::construct(*this, native(x)); }
Rational::Rational(double x) {
  require_finite(x);
  Native::construct(*this, x);
}
Rational::Rational(const Integer& numerator, const Integer& denominator) {
  require_divisor(denominator.is_zero());
  Native::construct(*this, native(numerator), native(denominator));
}
Rational::Rational(std::string_view text) {
  const std::size_t slash = text.find('/');
  const BigInteger n = integer_of_text(text.substr(0, slash));
  if (slash == std::string_view::npos) {
    Native::construct(*this, n);
    return;
  }
  const BigInteger d = integer_of_text(text.substr(slash + 1));
  require_divisor(d == 0);
  Native::construct(*this, n, d);
}
Rational::Rational(const Rational& other) { Native::construct(*this, native(other)); }
Rational::Rational(Rational&& other) noexcept { Native::construct(*this, std::move(native(other))); }
Rational& Rational::operator=(const Rational& other) {  // NOLINT(bugprone-unhandled-self-assignment)
  native(*this) = native(other);
  return *this;
}
Rational& Rational::operator=(Rational&& other) noexcept {
  native(*this) = std::move(native(other));
  return *this;
}
Rational::~Rational() { std::destroy_at(&native(*this)); }

Rational& Rational::operator+=(const Rational& b) {
  native(*this) += native(b);
  return *this;
}
Rational& Rational::operator-=(const Rational& b) {
  native(*this) -= native(b);
  return *this;
}
Rational& Rational::operator*=(const Rational& b) {
  native(*this) *= native(b);
  return *this;
}
Rational& Rational::operator/=(const Rational& b) {
  require_divisor(b.is_zero());
  native(*this) /= native(b);
  return *this;
}
Rational Rational::operator-() const& {
  Rational r = *this;
  detail::negate(native(r));
  return r;
}
Rational Rational::operator-() && {
  detail::negate(native(*this));
  return std::move(*this);
}

int Rational::sign() const noexcept { return native(*this).sign(); }
std::strong_ordering Rational::compare(const Rational& b) const { return native(*this).compare(native(b)) <=> 0; }
std::strong_ordering Rational::compare(std::int64_t b) const {
  return b == 0 ? sign() <=> 0 : native(*this).compare(b) <=> 0;
}
std::string Rational::str() const { return native(*this).str(); }

Rational operator+(const Rational& a, const Rational& b) {
  Rational r;
  native(r) = native(a) + native(b);
  return r;
}
Rational operator-(const Rational& a, const Rational& b) {
  Rational r;
  native(r) = native(a) - native(b);
  return r;
}
Rational operator*(const Rational& a, const Rational& b) {
  Rational r;
  native(r) = native(a) * native(b);
  return r;
}
Rational operator/(const Rational& a, const Rational& b) {
  require_divisor(b.is_zero());
  Rational r;
  native(r) = native(a) / native(b);
  return r;
}
bool operator==(const Rational& a, const Rational& b) { return native(a) == native(b); }

Rational abs(const Rational& x) { return x.sign() < 0 ? -x : x; }
Integer numerator(const Rational& x) { return Native::integer(detail::numerator_of(native(x))); }
Integer denominator(const Rational& x) { return Native::integer(detail::denominator_of(native(x))); }
std::ostream& operator<<(std::ostream& out, const Rational& x) { return out << x.str(); }

// Rounding

namespace {

/// The 64 bits of a number from this one on.
std::uint64_t bits_from(std::span<const std::uint64_t> limbs, std::size_t lowest) {
  const std::uint64_t low = limb_or_zero(limbs, lowest / 64) >> lowest % 64;
  return lowest % 64 == 0 ? low : low | limb_or_zero(limbs, lowest / 64 + 1) << (64 - lowest % 64);
}

/// The number of at most 64 significant bits, and of those of a Float, that is nearest to x; ties to even.
template <class Float>
Float nearest_to_integer(const Integer& x) {
  constexpr std::size_t digits = std::min(std::numeric_limits<Float>::digits, 64);
  const std::span<const std::uint64_t> limbs = limbs_of(x);
  const std::size_t size = bit_length(x);
  Float r = 0;
  if (size <= digits) {
    r = static_cast<Float>(limb_or_zero(limbs, 0));
  } else if (size > static_cast<std::size_t>(std::numeric_limits<Float>::max_exponent)) {
    r = std::numeric_limits<Float>::infinity();
  } else {
    const std::size_t lowest = size - digits, half = lowest - 1;
    const std::uint64_t significand = bits_from(limbs, lowest) & (~std::uint64_t{0} >> (64 - digits));
    const bool is_half_set = (limbs[half / 64] >> half % 64 & 1) != 0;
    const bool is_up = is_half_set && ((significand & 1) != 0 || trailing_zeros(x) < half);
    r = std::ldexp(static_cast<Float>(significand) + static_cast<Float>(is_up), static_cast<int>(lowest));
  }
  return x.sign() < 0 ? -r : r;
}

/// floor(log2(n / d)) for positive n and d.
long floor_log2(const Integer& n, const Integer& d) {
  const long estimate = static_cast<long>(bit_length(n)) - static_cast<long>(bit_length(d));  // right or one too large
  const bool reached =
      estimate >= 0 ? n >= (d << static_cast<std::size_t>(estimate)) : (n << static_cast<std::size_t>(-estimate)) >= d;
  return reached ? estimate : estimate - 1;
}

/// The integer nearest to n / d / 2^scale for positive n and d; ties to even. It has at most 64 bits.
std::uint64_t nearest_multiple(Integer n, Integer d, long scale) {
  if (scale >= 0) {
    d <<= static_cast<std::size_t>(scale);
  } else {
    n <<= static_cast<std::size_t>(-scale);
  }
  auto [quotient, remainder] = divide(n, d);
  const std::uint64_t whole = quotient.is_zero() ? 0 : limbs_of(quotient)[0];
  const std::strong_ordering half = (remainder <<= 1) <=> d;
  return half > 0 || (half == 0 && (whole & 1) != 0) ? whole + 1 : whole;
}

std::uint64_t low_limb(const Integer& x) { return x.is_zero() ? 0 : limbs_of(x)[0]; }

/// The Float nearest to q. The significand is rounded once, at the last bit that the exponent of q permits. All later
/// steps are exact or overflow to infinity. Values that round to zero give +0.
template <class Float>
Float to_nearest(const Rational& q) {
  using Limits = std::numeric_limits<Float>;
  const int sign = q.sign();
  if (sign == 0) return 0;
  const Integer n = abs(numerator(q));
  const Integer d = denominator(q);
  if (bit_length(n) <= Limits::digits && bit_length(d) <= Limits::digits) {  // one IEEE division, far from subnormals
    const Float quotient = static_cast<Float>(low_limb(n)) / static_cast<Float>(low_limb(d));
    return sign < 0 ? -quotient : quotient;
  }
  const long exponent = floor_log2(n, d);
  if (exponent >= Limits::max_exponent) return sign < 0 ? -Limits::infinity() : Limits::infinity();
  const long lowest_bit = Limits::min_exponent - Limits::digits;  // of the subnormals
  if (exponent < lowest_bit - 1) return 0;
  const long last_bit = std::max(exponent - Limits::digits + 1, lowest_bit);
  const auto significand = static_cast<Float>(nearest_multiple(n, d, last_bit));
  const Float magnitude = std::ldexp(significand, static_cast<int>(last_bit));
  return sign < 0 && magnitude != 0 ? -magnitude : magnitude;
}

/// The first 64 bits of a positive integer, the highest one set, and the power of two of the last of them.
std::pair<std::uint64_t, long> leading_bits(std::span<const std::uint64_t> magnitude) {
  const std::uint64_t top = magnitude.back();
  const int zeros = std::countl_zero(top);
  const long last = 64 * (static_cast<long>(magnitude.size()) - 1) - zeros;
  if (zeros == 0) return {top, last};
  const std::uint64_t next = magnitude.size() > 1 ? magnitude[magnitude.size() - 2] : 0;
  return {top << zeros | next >> (64 - zeros), last};
}

/// The double nearest to q from the first 64 bits of numerator and denominator, if these decide.
///
/// With n = (N + a) 2^i and d = (D + b) 2^j, 0 <= a, b < 1 and N, D in [2^63, 2^64), let Q = floor(2^63 N / D), which
/// has 63 or 64 bits. 2^63 (N + a) / (D + b) lies in (Q - 2, Q + 3): N / D < 2 and 2^63 <= D. So what is more than 3
/// units of Q away from the middle between two doubles is rounded as Q is.
std::optional<double> nearest_by_leading_bits(const Rational& q) {
  const auto [n, i] = leading_bits(detail::numerator_magnitude(native(q)));
  const auto [d, j] = leading_bits(detail::denominator_magnitude(native(q)));
  const auto quotient = static_cast<std::uint64_t>((static_cast<unsigned __int128>(n) << 63) / d);
  const int dropped = static_cast<int>(std::bit_width(quotient)) - std::numeric_limits<double>::digits;
  const std::uint64_t half = std::uint64_t{1} << (dropped - 1), rest = quotient & (2 * half - 1);
  if (rest + 4 > half && rest < half + 4) return std::nullopt;
  const long exponent = i - j - 63 + dropped;
  if (exponent < -1000 || exponent > 900) return std::nullopt;  // subnormal or infinite, perhaps
  const double magnitude =
      std::ldexp(static_cast<double>((quotient >> dropped) + (rest > half ? 1 : 0)), static_cast<int>(exponent));
  return q.sign() < 0 ? -magnitude : magnitude;
}

}  // namespace

double Integer::to_double() const { return nearest_to_integer<double>(*this); }

long double to_nearest_long_double(const Integer& x) { return nearest_to_integer<long double>(x); }

double to_nearest_double(const Rational& q) {
  if (q.sign() == 0) return 0;
  if (const auto nearest = nearest_by_leading_bits(q)) return *nearest;
  return to_nearest<double>(q);
}

float to_nearest_float(const Rational& q) { return to_nearest<float>(q); }

}  // namespace strata
