#pragma once
#include <array>
#include <cstdint>

#include "core/exact/sign.h"

namespace strata {

/// Signed integer of 64 * Limbs bits in two's complement; arithmetic modulo 2^(64 * Limbs). The caller chooses a size
/// for which no sign wraps: core/kernel/theory.md gives the width of every predicate.
template <int Limbs>
class WideInt {
 public:
  using Limb = std::uint64_t;
  static constexpr int bits = 64 * Limbs;

  constexpr WideInt() = default;
  constexpr WideInt(std::int64_t x) {  // NOLINT: small integers are wide ones
    limb_[0] = static_cast<Limb>(x);
    for (int i = 1; i < Limbs; ++i) limb_[i] = x < 0 ? ~Limb{0} : 0;
  }

  /// magnitude * 2^shift, negated if `negative`. Requires shift + 64 < bits.
  static constexpr WideInt shifted(std::uint64_t magnitude, int shift, bool negative) {
    WideInt r;
    const int word = shift / 64, bit = shift % 64;
    r.limb_[word] = magnitude << bit;
    if (bit != 0 && word + 1 < Limbs) r.limb_[word + 1] = magnitude >> (64 - bit);
    return negative ? -r : r;
  }

  friend constexpr WideInt operator+(const WideInt& a, const WideInt& b) {
    WideInt r;
    unsigned char carry = 0;
    for (int i = 0; i < Limbs; ++i) {
      const unsigned __int128 s = static_cast<unsigned __int128>(a.limb_[i]) + b.limb_[i] + carry;
      r.limb_[i] = static_cast<Limb>(s);
      carry = static_cast<unsigned char>(s >> 64);
    }
    return r;
  }
  friend constexpr WideInt operator-(const WideInt& a, const WideInt& b) {
    WideInt r;
    unsigned char borrow = 0;
    for (int i = 0; i < Limbs; ++i) {
      const unsigned __int128 d = static_cast<unsigned __int128>(a.limb_[i]) - b.limb_[i] - borrow;
      r.limb_[i] = static_cast<Limb>(d);
      borrow = static_cast<unsigned char>((d >> 64) & 1);
    }
    return r;
  }
  constexpr WideInt operator-() const { return WideInt{} - *this; }

  /// Schoolbook product of the low limbs: the same for signed and unsigned operands.
  friend constexpr WideInt operator*(const WideInt& a, const WideInt& b) {
    WideInt r;
    for (int i = 0; i < Limbs; ++i) {
      Limb carry = 0;
      for (int j = 0; i + j < Limbs; ++j) {
        const unsigned __int128 p = static_cast<unsigned __int128>(a.limb_[i]) * b.limb_[j] + r.limb_[i + j] + carry;
        r.limb_[i + j] = static_cast<Limb>(p);
        carry = static_cast<Limb>(p >> 64);
      }
    }
    return r;
  }

  [[nodiscard]] constexpr Sign sign() const {
    if (static_cast<std::int64_t>(limb_[Limbs - 1]) < 0) return Sign::negative;
    for (const Limb l : limb_)
      if (l != 0) return Sign::positive;
    return Sign::zero;
  }
  friend constexpr bool operator==(const WideInt&, const WideInt&) = default;
  [[nodiscard]] constexpr const std::array<Limb, Limbs>& limbs() const { return limb_; }

 private:
  std::array<Limb, Limbs> limb_{};
};

}  // namespace strata
