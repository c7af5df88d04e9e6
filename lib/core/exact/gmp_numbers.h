#pragma once
/// GMP's integers and fractions as back ends of Integer and Rational. What a back end gives: core/exact/big_integer.h.
#include <algorithm>
#include <boost/multiprecision/gmp.hpp>
#include <cstdint>
#include <span>

namespace strata::detail {

using GmpInteger = boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;
using GmpFraction = boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off>;
static_assert(sizeof(mp_limb_t) == sizeof(std::uint64_t));

[[nodiscard]] inline std::span<const std::uint64_t> magnitude(mpz_srcptr z) {
  return {reinterpret_cast<const std::uint64_t*>(mpz_limbs_read(z)), mpz_size(z)};
}
[[nodiscard]] inline std::span<const std::uint64_t> magnitude(const GmpInteger& x) {
  return magnitude(x.backend().data());
}
inline void assign(GmpInteger& x, std::span<const std::uint64_t> magnitude, bool is_negative) {
  const mpz_ptr z = x.backend().data();
  const auto size = static_cast<mp_size_t>(magnitude.size());
  std::copy(magnitude.begin(), magnitude.end(), mpz_limbs_write(z, std::max<mp_size_t>(size, 1)));
  mpz_limbs_finish(z, is_negative ? -size : size);
}
inline void negate(GmpInteger& x) { x.backend().negate(); }
inline void divide(const GmpInteger& a, const GmpInteger& b, GmpInteger& quotient, GmpInteger& remainder) {
  divide_qr(a, b, quotient, remainder);
}
[[nodiscard]] inline GmpInteger quotient(const GmpInteger& a, const GmpInteger& b) { return a / b; }
[[nodiscard]] inline GmpInteger remainder(const GmpInteger& a, const GmpInteger& b) { return a % b; }
[[nodiscard]] inline GmpInteger exact_quotient(const GmpInteger& a, const GmpInteger& b) {
  GmpInteger r;
  mpz_divexact(r.backend().data(), a.backend().data(), b.backend().data());
  return r;
}
[[nodiscard]] inline GmpInteger common_divisor(const GmpInteger& a, const GmpInteger& b) { return gcd(a, b); }

inline void negate(GmpFraction& x) { x.backend().negate(); }
[[nodiscard]] inline GmpInteger numerator_of(const GmpFraction& x) { return numerator(x); }
[[nodiscard]] inline GmpInteger denominator_of(const GmpFraction& x) { return denominator(x); }
[[nodiscard]] inline std::span<const std::uint64_t> numerator_magnitude(const GmpFraction& x) {
  return magnitude(mpq_numref(x.backend().data()));
}
[[nodiscard]] inline std::span<const std::uint64_t> denominator_magnitude(const GmpFraction& x) {
  return magnitude(mpq_denref(x.backend().data()));
}

}  // namespace strata::detail
