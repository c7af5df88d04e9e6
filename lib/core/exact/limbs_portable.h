#pragma once
/// Magnitudes as arrays of 64-bit limbs, the lowest first, in plain C++. What GMP's low-level functions do where GMP
/// may not be used; core/exact/limbs.h says which are in use. All are quadratic at most; no memory is allocated.
/// Source: Knuth, The Art of Computer Programming 2, 4.3.1 and 4.5.2; Moller and Granlund 2011 for quotients.
#include <cstdint>

namespace strata::limbs {

using Limb = std::uint64_t;

/// high * 2^64 + low
struct TwoLimbs {
  Limb high = 0, low = 0;
};

namespace portable {

/// a * b from products of halves.
[[nodiscard]] constexpr TwoLimbs product_of_halves(Limb a, Limb b) {
  constexpr Limb low_half = 0xffffffffU;
  const Limb a0 = a & low_half, a1 = a >> 32, b0 = b & low_half, b1 = b >> 32;
  const Limb low = a0 * b0, cross = a1 * b0 + (low >> 32);
  const Limb middle = a0 * b1 + (cross & low_half);
  return {a1 * b1 + (cross >> 32) + (middle >> 32), middle << 32 | (low & low_half)};
}

/// n / d where n.high < d and the highest bit of d is set, by halves of d.
[[nodiscard]] Limb quotient_by_halves(TwoLimbs n, Limb d);

#ifdef __SIZEOF_INT128__
[[nodiscard]] constexpr TwoLimbs product(Limb a, Limb b) {
  const unsigned __int128 p = static_cast<unsigned __int128>(a) * b;
  return {static_cast<Limb>(p >> 64), static_cast<Limb>(p)};
}
[[nodiscard]] constexpr Limb quotient(TwoLimbs n, Limb d) {
  return static_cast<Limb>((static_cast<unsigned __int128>(n.high) << 64 | n.low) / d);
}
#else
[[nodiscard]] constexpr TwoLimbs product(Limb a, Limb b) { return product_of_halves(a, b); }
[[nodiscard]] inline Limb quotient(TwoLimbs n, Limb d) { return quotient_by_halves(n, d); }
#endif

// The functions of core/exact/limbs.h.
Limb add(Limb* r, const Limb* a, int n, const Limb* b, int m);
void subtract(Limb* r, const Limb* a, int n, const Limb* b, int m);
void multiply(Limb* r, const Limb* a, int n, const Limb* b, int m);
Limb shift_left(Limb* r, const Limb* a, int n, int bits);
void shift_right(Limb* r, const Limb* a, int n, int bits);
[[nodiscard]] int compare(const Limb* a, const Limb* b, int n);
void divide(Limb* quotient, Limb* remainder, const Limb* a, int n, const Limb* b, int m);
[[nodiscard]] int gcd(Limb* r, Limb* a, int n, Limb* b, int m);

}  // namespace portable
}  // namespace strata::limbs
