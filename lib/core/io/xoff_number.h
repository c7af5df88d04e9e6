#pragma once
#include <optional>
#include <string>

#include "core/io/text_cursor.h"
#include "strata/rational.h"

namespace strata::io {

/// A coordinate of an XOFF file: the nearest double, and the number itself if it is no double.
struct ExactCoordinate {
  double nearest = 0;
  std::optional<Rational> exact;
};

/// Reads an integer or a quotient of integers, of any length, or another decimal number, which means its nearest
/// double. Throws Malformed, also for numbers that round beyond the doubles. O(n log^2 n) or so for n digits.
[[nodiscard]] ExactCoordinate read_coordinate(TextCursor& text);

/// The coordinate in the form in which it reads back the same: the shortest digits of `nearest` if this is the number,
/// otherwise an integer or a quotient in lowest terms.
void append_coordinate(std::string& text, const Rational& exact, double nearest);

/// The shortest digits that read back the same.
void append_coordinate(std::string& text, double x);

}  // namespace strata::io
