#pragma once
/// The numbers inside Integer and Rational: GMP's, or Boost.Multiprecision's cpp_int where Strata is built without GMP
/// (STRATA_WITHOUT_GMP). This header and core/exact/limbs.h are the only places that know which.
///
/// A back end gives `BigInteger` and `BigRational`, values with
///
///   construction from 0, std::int64_t, std::uint64_t, an integral double, decimal digits; from (BigInteger,
///   BigInteger), double
///   + - * += -= *=, for fractions / and /=, for integers <<= and >>= (rounded down); ==; pow, sqrt, lcm of integers
///   compare(other), compare(std::int64_t), for integers compare(std::uint64_t); sign(); str()
///
/// and these functions, where fractions are in lowest terms with a positive denominator and divisors are not zero:
///
///   magnitude(x)                      limbs of |x|, the lowest first, without leading zeros; none for 0
///   assign(x, limbs, is_negative)     the integer of these limbs, which may have leading zeros
///   negate(x)                         in place
///   quotient, remainder, divide       truncated towards zero
///   exact_quotient(a, b)              where b divides a
///   common_divisor(a, b)              not negative
///   numerator_of, denominator_of, numerator_magnitude, denominator_magnitude
#ifdef STRATA_WITHOUT_GMP
#include "core/exact/cpp_fraction.h"
#else
#include "core/exact/gmp_numbers.h"
#endif
#include <algorithm>
#include <bit>
#include <cstdint>
#include <new>
#include <span>
#include <utility>

#include "strata/rational.h"

namespace strata::detail {

#ifdef STRATA_WITHOUT_GMP
using BigInteger = CppInteger;
using BigRational = CppFraction;
#else
using BigInteger = GmpInteger;
using BigRational = GmpFraction;
#endif
static_assert(sizeof(BigInteger) <= integer_bytes && sizeof(BigRational) <= rational_bytes);
static_assert(alignof(BigInteger) <= number_alignment && alignof(BigRational) <= number_alignment);

struct Native {
  static BigInteger& of(Integer& x) { return *std::launder(reinterpret_cast<BigInteger*>(x.storage_)); }
  static const BigInteger& of(const Integer& x) {
    return *std::launder(reinterpret_cast<const BigInteger*>(x.storage_));
  }
  static BigRational& of(Rational& x) { return *std::launder(reinterpret_cast<BigRational*>(x.storage_)); }
  static const BigRational& of(const Rational& x) {
    return *std::launder(reinterpret_cast<const BigRational*>(x.storage_));
  }

  template <class... Arguments>
  static void construct(Integer& x, Arguments&&... arguments) {
    new (x.storage_) BigInteger(std::forward<Arguments>(arguments)...);
  }
  template <class... Arguments>
  static void construct(Rational& x, Arguments&&... arguments) {
    new (x.storage_) BigRational(std::forward<Arguments>(arguments)...);
  }
  static Integer integer(BigInteger x) {
    Integer r{Integer::Uninitialised{}};
    construct(r, std::move(x));
    return r;
  }
};

}  // namespace strata::detail

namespace strata {

/// The number inside.
template <class Number>
[[nodiscard]] decltype(auto) native(Number& x) {
  return detail::Native::of(x);
}

/// True when the denominator is a power of two, so that the value may be a double. O(1) for most others.
[[nodiscard]] inline bool is_dyadic(const Rational& x) {
  const auto limbs = detail::denominator_magnitude(native(x));
  return std::has_single_bit(limbs.back()) &&
         std::all_of(limbs.begin(), limbs.end() - 1, [](std::uint64_t limb) { return limb == 0; });
}

/// The magnitude's words of 64 bits, the lowest first; none for 0.
[[nodiscard]] inline std::span<const std::uint64_t> limbs_of(const Integer& x) { return detail::magnitude(native(x)); }

/// The words of numerator and denominator, without a copy.
[[nodiscard]] inline std::span<const std::uint64_t> numerator_limbs(const Rational& x) {
  return detail::numerator_magnitude(native(x));
}
[[nodiscard]] inline std::span<const std::uint64_t> denominator_limbs(const Rational& x) {
  return detail::denominator_magnitude(native(x));
}

/// The word at a place, 0 beyond the highest.
[[nodiscard]] inline std::uint64_t limb_or_zero(std::span<const std::uint64_t> limbs, std::size_t i) {
  return i < limbs.size() ? limbs[i] : 0;
}

/// The integer of these words, the lowest first; leading zeros are allowed.
[[nodiscard]] Integer integer_of_limbs(std::span<const std::uint64_t> magnitude, bool is_negative);

/// a / b where b divides a. Throws std::overflow_error for b = 0.
[[nodiscard]] Integer exact_quotient(const Integer& a, const Integer& b);

/// The long double nearest to x, ties to even; where it has more than 64 digits, the nearest number of 64.
[[nodiscard]] long double to_nearest_long_double(const Integer& x);

}  // namespace strata
