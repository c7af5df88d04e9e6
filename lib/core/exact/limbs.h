#pragma once
/// Arithmetic of magnitudes: arrays of 64-bit limbs, the lowest first. By GMP's low-level functions, or in plain C++
/// where Strata is built without GMP.
#include "core/exact/limbs_portable.h"
#ifndef STRATA_WITHOUT_GMP
#include <gmp.h>

#include <type_traits>
#endif

namespace strata::limbs {

// add(r, a, n, b, m): r = a + b in n limbs; returns the carry. n >= m >= 1; r may be a or b.
// subtract(r, a, n, b, m): r = a - b in n limbs, where a >= b. n >= m >= 1; r may be a or b.
// multiply(r, a, n, b, m): r = a * b in n + m limbs. n >= m >= 1; r is neither a nor b.
// shift_left(r, a, n, bits): r = a * 2^bits in n limbs for 1 <= bits <= 63; returns what is shifted out. r may be a.
// shift_right(r, a, n, bits): r = a / 2^bits, rounded down, in n limbs for 1 <= bits <= 63. r may be a.
// compare(a, b, n): negative, zero or positive as a - b is, both of n limbs.
// divide(quotient, remainder, a, n, b, m): of n - m + 1 and of m limbs. n >= m >= 1, the highest limb of b is not zero.
// The
//   remainder has room for n limbs and may be a; nothing else overlaps.
// gcd(r, a, n, b, m): writes the greatest common divisor to r, which has room for m limbs, and returns their number.
//   n >= m >= 1, b is odd, the highest limbs are not zero. a and b have room for n limbs and are destroyed.

#ifdef STRATA_WITHOUT_GMP
using portable::add, portable::subtract, portable::multiply, portable::shift_left, portable::shift_right,
    portable::compare, portable::divide, portable::gcd;
#else
static_assert(sizeof(mp_limb_t) == sizeof(Limb) && std::is_unsigned_v<mp_limb_t>);

namespace detail {
inline mp_limb_t* native(Limb* x) { return reinterpret_cast<mp_limb_t*>(x); }
inline const mp_limb_t* native(const Limb* x) { return reinterpret_cast<const mp_limb_t*>(x); }
}  // namespace detail

inline Limb add(Limb* r, const Limb* a, int n, const Limb* b, int m) {
  return mpn_add(detail::native(r), detail::native(a), n, detail::native(b), m);
}
inline void subtract(Limb* r, const Limb* a, int n, const Limb* b, int m) {
  mpn_sub(detail::native(r), detail::native(a), n, detail::native(b), m);
}
inline void multiply(Limb* r, const Limb* a, int n, const Limb* b, int m) {
  mpn_mul(detail::native(r), detail::native(a), n, detail::native(b), m);
}
inline Limb shift_left(Limb* r, const Limb* a, int n, int bits) {
  return mpn_lshift(detail::native(r), detail::native(a), n, static_cast<unsigned>(bits));
}
inline void shift_right(Limb* r, const Limb* a, int n, int bits) {
  mpn_rshift(detail::native(r), detail::native(a), n, static_cast<unsigned>(bits));
}
[[nodiscard]] inline int compare(const Limb* a, const Limb* b, int n) {
  return mpn_cmp(detail::native(a), detail::native(b), n);
}
inline void divide(Limb* quotient, Limb* remainder, const Limb* a, int n, const Limb* b, int m) {
  mpn_tdiv_qr(detail::native(quotient), detail::native(remainder), 0, detail::native(a), n, detail::native(b), m);
}
[[nodiscard]] inline int gcd(Limb* r, Limb* a, int n, Limb* b, int m) {
  return static_cast<int>(mpn_gcd(detail::native(r), detail::native(a), n, detail::native(b), m));
}
#endif

}  // namespace strata::limbs
