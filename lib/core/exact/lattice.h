#pragma once
#include <bit>
#include <cstdint>
#include <cstdlib>

#include "core/exact/long_int.h"
#include "core/exact/wide_int.h"
#include "strata/rational.h"

namespace strata {

/// Sign of an exact integer of any width.
template <int Limbs>
[[nodiscard]] constexpr Sign sign_of_integer(const WideInt<Limbs>& x) {
  return x.sign();
}
[[nodiscard]] inline Sign sign_of_integer(const Integer& x) { return static_cast<Sign>(x.sign()); }

template <int Limbs>
[[nodiscard]] Integer to_integer(const WideInt<Limbs>& x) {
  const bool is_negative = x.sign() == Sign::negative;
  const auto limbs = (is_negative ? -x : x).limbs();
  return integer_of_limbs(limbs, is_negative);
}

/// A finite double as sign * magnitude * 2^exponent with an odd magnitude (0 for zero).
struct DoubleParts {
  std::uint64_t magnitude = 0;
  int exponent = 0;
  bool negative = false;

  explicit constexpr DoubleParts(double x) {
    const auto pattern = std::bit_cast<std::uint64_t>(x);
    const std::uint64_t fraction = pattern & ((std::uint64_t{1} << 52) - 1);
    const int biased = static_cast<int>((pattern >> 52) & 0x7ff);
    if (fraction == 0 && biased == 0) return;
    negative = (pattern >> 63) != 0;
    magnitude = biased == 0 ? fraction : fraction | (std::uint64_t{1} << 52);
    const int zeros = std::countr_zero(magnitude);
    magnitude >>= zeros;
    exponent = (biased == 0 ? 1 : biased) - 1075 + zeros;
  }
};

/// The coarsest lattice 2^unit * Z that holds a set of doubles, and the bits their integers need on it.
/// Finite doubles are integers times a power of two, so every set of them lies on one.
class Lattice {
 public:
  void add(double x) {
    const DoubleParts parts(x);
    if (parts.magnitude == 0) return;
    const int top = parts.exponent + static_cast<int>(std::bit_width(parts.magnitude));
    if (empty_) {
      unit_ = parts.exponent;
      top_ = top;
      empty_ = false;
      return;
    }
    if (parts.exponent < unit_) unit_ = parts.exponent;
    if (top > top_) top_ = top;
  }
  /// Exponent of the unit.
  [[nodiscard]] int unit() const { return unit_; }
  /// b such that every |integer| < 2^b.
  [[nodiscard]] int bits() const { return empty_ ? 1 : top_ - unit_; }

  /// x / 2^unit as an integer. Requires that x was added and, for WideInt, bits() < 64 * Limbs.
  template <class Int>
  [[nodiscard]] Int integer(double x) const {
    const DoubleParts parts(x);
    if (parts.magnitude == 0) return Int(0);
    return shifted(parts.magnitude, parts.exponent - unit_, parts.negative, static_cast<const Int*>(nullptr));
  }

 private:
  template <int Limbs>
  static WideInt<Limbs> shifted(std::uint64_t m, int shift, bool negative, const WideInt<Limbs>*) {
    return WideInt<Limbs>::shifted(m, shift, negative);
  }
  static LongInt shifted(std::uint64_t m, int shift, bool negative, const LongInt*) {
    return LongInt::shifted(m, shift, negative);
  }
  static Integer shifted(std::uint64_t m, int shift, bool negative, const Integer*) {
    Integer r = m;
    r <<= static_cast<std::size_t>(shift);
    return negative ? Integer(-r) : r;
  }

  int unit_ = 0;
  int top_ = 1;
  bool empty_ = true;
};

}  // namespace strata
