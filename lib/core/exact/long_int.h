#pragma once
#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include "core/exact/big_integer.h"
#include "core/exact/failure.h"
#include "core/exact/limbs.h"
#include "core/exact/sign.h"
#include "core/exact/wide_int.h"
#include "strata/rational.h"

namespace strata {

/// Signed integer of up to 4096 bits, held in place: its length is that of its value, and nothing is allocated.
/// A result that does not fit is *lost*: so is everything that is computed from it, and it has no sign. Whoever asks
/// for a value asks `is_lost` before, and turns to Integer. Products and sums are those of core/exact/limbs.h.
class LongInt {
 public:
  static constexpr int limb_capacity = 64;
  static constexpr int bits = 64 * limb_capacity;

  LongInt() = default;
  LongInt(std::int64_t x) : is_negative_(x < 0) {  // NOLINT: small integers are long ones
    limb_[0] = is_negative_ ? -static_cast<std::uint64_t>(x) : static_cast<std::uint64_t>(x);
    size_ = x != 0 ? 1 : 0;
  }
  explicit LongInt(const Integer& x) : is_negative_(x.sign() < 0) {
    const std::span<const std::uint64_t> limbs = limbs_of(x);
    if (limbs.size() > limb_capacity)
      lose();
    else
      take(limbs.data(), static_cast<int>(limbs.size()));
  }
  template <int Limbs>
  explicit LongInt(const WideInt<Limbs>& x) : is_negative_(x.sign() == Sign::negative) {
    const auto limbs = (is_negative_ ? -x : x).limbs();
    take(limbs.data(), Limbs);
    trim();
  }
  LongInt(const LongInt& other) : size_(other.size_), is_negative_(other.is_negative_) {
    if (!is_lost()) std::copy_n(other.limb_, size_, limb_);
  }
  LongInt& operator=(const LongInt& other) {
    if (this == &other) return *this;
    size_ = other.size_;
    is_negative_ = other.is_negative_;
    if (!is_lost()) std::copy_n(other.limb_, size_, limb_);
    return *this;
  }
  ~LongInt() = default;

  /// magnitude * 2^shift, negated if asked.
  static LongInt shifted(std::uint64_t magnitude, int shift, bool negative) {
    LongInt r;
    r.limb_[0] = magnitude;
    r.size_ = magnitude != 0 ? 1 : 0;
    r.is_negative_ = negative && magnitude != 0;
    return r << shift;
  }

  [[nodiscard]] bool is_lost() const { return size_ < 0; }
  /// Throws LogicError where the value is lost.
  [[nodiscard]] Sign sign() const {
    if (size_ == 0) return Sign::zero;
    require_value();
    return is_negative_ ? Sign::negative : Sign::positive;
  }
  /// Throws LogicError where the value is lost.
  explicit operator Integer() const {
    require_value();
    return integer_of_limbs({limb_, static_cast<std::size_t>(size_)}, is_negative_);
  }

  LongInt operator-() const {
    LongInt r = *this;
    r.is_negative_ = size_ > 0 && !is_negative_;
    return r;
  }
  friend LongInt operator+(const LongInt& a, const LongInt& b) { return sum(a, b, b.is_negative_); }
  friend LongInt operator-(const LongInt& a, const LongInt& b) { return sum(a, b, !b.is_negative_); }
  friend LongInt operator*(const LongInt& a, const LongInt& b) {
    if (a.size_ < b.size_) return b * a;
    LongInt r;
    if (a.is_lost() || b.is_lost() || a.size_ + b.size_ > limb_capacity) return r.lose();
    if (b.size_ == 0) return r;
    limbs::multiply(r.limb_, a.limb_, a.size_, b.limb_, b.size_);
    r.size_ = a.size_ + b.size_;
    r.is_negative_ = a.is_negative_ != b.is_negative_;
    return r.trim();
  }
  /// times 2^shift, shift >= 0
  friend LongInt operator<<(const LongInt& a, int shift) {
    LongInt r;
    const int whole = shift / 64, rest = shift % 64;
    if (a.is_lost() || (a.size_ != 0 && a.size_ + whole + 1 > limb_capacity)) return r.lose();
    if (a.size_ == 0) return r;
    std::fill_n(r.limb_, whole, 0);
    r.limb_[whole + a.size_] = 0;
    if (rest == 0)
      std::copy_n(a.limb_, a.size_, r.limb_ + whole);
    else
      r.limb_[whole + a.size_] = limbs::shift_left(r.limb_ + whole, a.limb_, a.size_, rest);
    r.size_ = whole + a.size_ + 1;
    r.is_negative_ = a.is_negative_;
    return r.trim();
  }
  /// The magnitude divided by 2^shift, rounded down.
  friend LongInt operator>>(const LongInt& a, int shift) {
    LongInt r;
    const int whole = shift / 64, rest = shift % 64;
    if (a.is_lost()) return r.lose();
    if (a.size_ <= whole) return r;
    if (rest == 0)
      std::copy_n(a.limb_ + whole, a.size_ - whole, r.limb_);
    else
      limbs::shift_right(r.limb_, a.limb_ + whole, a.size_ - whole, rest);
    r.size_ = a.size_ - whole;
    r.is_negative_ = a.is_negative_;
    return r.trim();
  }

  /// The number of times that 2 divides it, which is not zero. Throws LogicError where the value is lost.
  [[nodiscard]] int trailing_zeros() const {
    require_value();
    int zeros = 0;
    while (limb_[zeros] == 0) ++zeros;
    return 64 * zeros + std::countr_zero(limb_[zeros]);
  }
  /// The greatest common divisor, not negative; that of zero and a number is the number's magnitude. Throws LogicError
  /// where a value is lost.
  friend LongInt gcd(const LongInt& a, const LongInt& b) {
    if (a.sign() == Sign::zero || b.sign() == Sign::zero) {
      LongInt r = a.size_ == 0 ? b : a;
      r.is_negative_ = false;
      return r;
    }
    const int of_a = a.trailing_zeros(), of_b = b.trailing_zeros();
    LongInt x = a >> of_a, y = b >> of_b, r;
    if (x.size_ < y.size_) std::swap(x, y);
    r.size_ = limbs::gcd(r.limb_, x.limb_, x.size_, y.limb_, y.size_);
    return r << std::min(of_a, of_b);
  }
  /// Requires that b divides a. Throws LogicError where a value is lost.
  friend LongInt exact_quotient(const LongInt& a, const LongInt& b) {
    a.require_value();
    b.require_value();
    LongInt quotient;
    if (a.size_ == 0) return quotient;
    limbs::Limb rest[limb_capacity];  // NOLINT
    limbs::divide(quotient.limb_, rest, a.limb_, a.size_, b.limb_, b.size_);
    quotient.size_ = a.size_ - b.size_ + 1;
    quotient.is_negative_ = a.is_negative_ != b.is_negative_;
    return quotient.trim();
  }

 private:
  void require_value() const {
    if (is_lost()) throw LogicError("an integer was asked for that is longer than it may be");
  }
  LongInt& lose() {
    size_ = -1;
    is_negative_ = false;
    return *this;
  }
  /// Drops leading zeros; zero is not negative.
  LongInt& trim() {
    while (size_ > 0 && limb_[size_ - 1] == 0) --size_;
    is_negative_ = is_negative_ && size_ > 0;
    return *this;
  }
  void take(const limbs::Limb* limbs, int size) {
    std::copy_n(limbs, size, limb_);
    size_ = size;
  }
  [[nodiscard]] bool is_smaller_than(const LongInt& other) const {
    return size_ != other.size_ ? size_ < other.size_ : size_ > 0 && limbs::compare(limb_, other.limb_, size_) < 0;
  }

  /// a + b with b's sign as told.
  static LongInt sum(const LongInt& a, const LongInt& b, bool b_is_negative) {
    LongInt r;
    if (a.is_lost() || b.is_lost()) return r.lose();
    const bool is_swapped = a.is_smaller_than(b);
    const LongInt &longer = is_swapped ? b : a, &shorter = is_swapped ? a : b;
    r.is_negative_ = is_swapped ? b_is_negative : a.is_negative_;
    r.size_ = longer.size_;
    if (shorter.size_ == 0) {
      std::copy_n(longer.limb_, longer.size_, r.limb_);
      r.is_negative_ = r.is_negative_ && r.size_ > 0;
      return r;
    }
    if (a.is_negative_ != b_is_negative) {
      limbs::subtract(r.limb_, longer.limb_, longer.size_, shorter.limb_, shorter.size_);
      return r.trim();
    }
    const limbs::Limb carry = limbs::add(r.limb_, longer.limb_, longer.size_, shorter.limb_, shorter.size_);
    if (carry == 0) return r;
    if (r.size_ == limb_capacity) return r.lose();
    r.limb_[r.size_++] = carry;
    return r;
  }

  int size_ = 0;  ///< limbs of the magnitude, the highest of them not zero; -1 when lost
  bool is_negative_ = false;
  limbs::Limb limb_[limb_capacity];  // NOLINT: those beyond the size hold nothing
};

[[nodiscard]] inline Sign sign_of_integer(const LongInt& x) { return x.sign(); }

}  // namespace strata
