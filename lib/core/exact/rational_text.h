#pragma once
#include <optional>
#include <string_view>

#include "strata/rational.h"

namespace strata {

/// The value of decimal digits, with a sign or without; nothing for other texts. Any length. O(n^1.6) for n digits.
[[nodiscard]] std::optional<Integer> parse_integer(std::string_view text);

/// The value of "7", "-7" or "-7/6": an integer, or its quotient by digits that are not all 0; nothing for other texts.
[[nodiscard]] std::optional<Rational> parse_quotient(std::string_view text);

}  // namespace strata
