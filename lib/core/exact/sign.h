#pragma once

namespace strata {

/// The sign of an exact value. Every geometric decision is one.
enum class Sign : signed char { negative = -1, zero = 0, positive = 1 };

[[nodiscard]] constexpr int to_int(Sign s) noexcept { return static_cast<int>(s); }
[[nodiscard]] constexpr Sign operator-(Sign s) noexcept { return static_cast<Sign>(-to_int(s)); }
[[nodiscard]] constexpr Sign operator*(Sign a, Sign b) noexcept { return static_cast<Sign>(to_int(a) * to_int(b)); }

/// Sign of a number whose comparison with zero is exact.
template <class Number>
[[nodiscard]] constexpr Sign sign_of(const Number& x) {
  return x > 0 ? Sign::positive : x < 0 ? Sign::negative : Sign::zero;
}

}  // namespace strata
