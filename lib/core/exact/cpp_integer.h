#pragma once
/// Boost.Multiprecision's own integers as back end of Integer: signed magnitudes of any length. Sums, products, roots
/// and text are Boost's; quotients and common divisors are those of core/exact/limbs_portable.h, which take a half and
/// a sixth of the time for long integers. What a back end gives: core/exact/big_integer.h.
#include <boost/multiprecision/cpp_int.hpp>
#include <cstddef>
#include <cstdint>
#include <span>

namespace strata::detail {

using CppInteger =
    boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;
static_assert(sizeof(boost::multiprecision::limb_type) == sizeof(std::uint64_t));

[[nodiscard]] inline std::span<const std::uint64_t> magnitude(const CppInteger& x) {
  const auto& backend = x.backend();
  const auto* limbs = reinterpret_cast<const std::uint64_t*>(backend.limbs());
  const std::size_t size = backend.size();
  return {limbs, size == 1 && *limbs == 0 ? 0 : size};
}
void assign(CppInteger& x, std::span<const std::uint64_t> magnitude, bool is_negative);
inline void negate(CppInteger& x) { x.backend().negate(); }
void divide(const CppInteger& a, const CppInteger& b, CppInteger& quotient, CppInteger& remainder);
[[nodiscard]] CppInteger quotient(const CppInteger& a, const CppInteger& b);
[[nodiscard]] CppInteger remainder(const CppInteger& a, const CppInteger& b);
[[nodiscard]] CppInteger exact_quotient(const CppInteger& a, const CppInteger& b);
[[nodiscard]] CppInteger common_divisor(const CppInteger& a, const CppInteger& b);

/// How often 2 divides x, which is not zero.
[[nodiscard]] std::size_t trailing_zeros(const CppInteger& x);
[[nodiscard]] bool is_power_of_two(const CppInteger& x);
/// x becomes x / 2^bits, of which it is a multiple.
void shift_down(CppInteger& x, std::size_t bits);

}  // namespace strata::detail
