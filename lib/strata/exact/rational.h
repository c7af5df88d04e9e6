#pragma once
#include <array>
#include <boost/multiprecision/gmp.hpp>

namespace strata {

/// Unbounded integer and rational (GMP). Rationals are always in lowest terms with positive denominator.
using Integer = boost::multiprecision::mpz_int;
using Rational = boost::multiprecision::mpq_rational;

/// A point with rational coordinates.
using RationalPoint = std::array<Rational, 3>;

/// The double nearest to q; ties go to the even mantissa, subnormals included.
/// Values that round beyond the largest finite double give an infinity. O(size of q).
[[nodiscard]] double to_nearest_double(const Rational& q);

/// The float nearest to q, by the same rules.
[[nodiscard]] float to_nearest_float(const Rational& q);

/// The exact value of a finite double.
[[nodiscard]] Rational to_rational(double x);

}  // namespace strata
