#pragma once
/// The numbers inside Integer and Rational: GMP's, or Boost.Multiprecision's own (STRATA_WITHOUT_GMP). This and
/// core/exact/limbs.h are the only places that know which.
#include <new>
#ifdef STRATA_WITHOUT_GMP
#include <boost/multiprecision/cpp_int.hpp>
#else
#include <boost/multiprecision/gmp.hpp>
#endif
#include <cstdint>
#include <span>

#include "strata/rational.h"

namespace strata::detail {

struct Native {
#ifdef STRATA_WITHOUT_GMP
  using I = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;
  using Q =
      boost::multiprecision::number<boost::multiprecision::rational_adaptor<boost::multiprecision::cpp_int_backend<>>,
                                    boost::multiprecision::et_off>;
#else
  using I = boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;
  using Q = boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off>;
#endif
  static_assert(sizeof(I) == integer_bytes && sizeof(Q) == rational_bytes && alignof(Q) <= 8 && alignof(I) <= 8);

  static I& of(Integer& x) { return *std::launder(reinterpret_cast<I*>(x.storage_)); }
  static const I& of(const Integer& x) { return *std::launder(reinterpret_cast<const I*>(x.storage_)); }
  static Q& of(Rational& x) { return *std::launder(reinterpret_cast<Q*>(x.storage_)); }
  static const Q& of(const Rational& x) { return *std::launder(reinterpret_cast<const Q*>(x.storage_)); }

  template <class... Arguments>
  static void construct(Integer& x, Arguments&&... arguments) {
    new (x.storage_) I(std::forward<Arguments>(arguments)...);
  }
  template <class... Arguments>
  static void construct(Rational& x, Arguments&&... arguments) {
    new (x.storage_) Q(std::forward<Arguments>(arguments)...);
  }
  static Integer integer(I x) {
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

/// The magnitude's words of 64 bits, the lowest first; none for 0.
#ifdef STRATA_WITHOUT_GMP
static_assert(sizeof(boost::multiprecision::limb_type) == 8);
[[nodiscard]] inline std::span<const std::uint64_t> limbs_of(const Integer& x) {
  const auto& backend = native(x).backend();
  return {reinterpret_cast<const std::uint64_t*>(backend.limbs()), x.is_zero() ? 0 : backend.size()};
}
#else
static_assert(sizeof(mp_limb_t) == 8);
[[nodiscard]] inline std::span<const std::uint64_t> limbs_of(const Integer& x) {
  const mpz_srcptr z = native(x).backend().data();
  return {reinterpret_cast<const std::uint64_t*>(mpz_limbs_read(z)), mpz_size(z)};
}
#endif

/// The words of numerator and denominator, without a copy.
#ifdef STRATA_WITHOUT_GMP
namespace detail {
[[nodiscard]] inline std::span<const std::uint64_t> words(const boost::multiprecision::cpp_int_backend<>& x) {
  const bool is_zero = x.size() == 1 && *x.limbs() == 0;
  return {reinterpret_cast<const std::uint64_t*>(x.limbs()), is_zero ? 0 : x.size()};
}
}  // namespace detail
[[nodiscard]] inline std::span<const std::uint64_t> numerator_limbs(const Rational& x) {
  return detail::words(native(x).backend().data().numerator());
}
[[nodiscard]] inline std::span<const std::uint64_t> denominator_limbs(const Rational& x) {
  return detail::words(native(x).backend().data().denominator());
}
#else
namespace detail {
[[nodiscard]] inline std::span<const std::uint64_t> words(mpz_srcptr z) {
  return {reinterpret_cast<const std::uint64_t*>(mpz_limbs_read(z)), mpz_size(z)};
}
}  // namespace detail
[[nodiscard]] inline std::span<const std::uint64_t> numerator_limbs(const Rational& x) {
  return detail::words(mpq_numref(native(x).backend().data()));
}
[[nodiscard]] inline std::span<const std::uint64_t> denominator_limbs(const Rational& x) {
  return detail::words(mpq_denref(native(x).backend().data()));
}
#endif

/// The word at a place, 0 beyond the highest.
[[nodiscard]] inline std::uint64_t limb_or_zero(std::span<const std::uint64_t> limbs, std::size_t i) {
  return i < limbs.size() ? limbs[i] : 0;
}

/// The integer of these words, the lowest first; leading zeros are allowed.
[[nodiscard]] Integer integer_of_limbs(std::span<const std::uint64_t> magnitude, bool is_negative);

/// a / b where b divides a.
[[nodiscard]] Integer exact_quotient(const Integer& a, const Integer& b);

}  // namespace strata
