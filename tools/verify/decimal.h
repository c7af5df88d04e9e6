#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "strata/rational.h"

namespace verify {

/// The 15 significant decimal digits nearest to q (ties away from zero), with an exponent where that is shorter to
/// read: "0", "6", "2.44948974278318", "1.5e-600". Any range: not by way of a double.
[[nodiscard]] std::string decimal(const strata::Rational& q);

/// The value of "7", "-7/6", "2.5" or "1.5e-600"; nothing for other texts, and for decimals of 10^999999 or beyond, or
/// as small.
[[nodiscard]] std::optional<strata::Rational> parse_rational(std::string_view text);

}  // namespace verify
