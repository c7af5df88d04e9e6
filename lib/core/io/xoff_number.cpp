#include "core/io/xoff_number.h"

#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>

#include "strata/rational.h"

namespace strata::io {
namespace {

ExactCoordinate rounded(Rational exact, const TextCursor& at) {
  const double nearest = to_nearest_double(exact);
  if (!std::isfinite(nearest)) at.fail_expected("a number for a coordinate within the range of doubles");
  if (to_rational(nearest) == exact) return {nearest, {}};
  return {nearest, std::move(exact)};
}

}  // namespace

ExactCoordinate read_coordinate(TextCursor& text) {
  constexpr const char* what = "a number for a coordinate";
  constexpr std::size_t few = 15;  // digits that a double holds
  text.skip_blanks();
  const TextCursor start = text;
  TextCursor behind = text;
  const std::string_view word = behind.word();
  const std::size_t slash = word.find('/');
  if (slash == std::string_view::npos && word.size() <= few) return {text.number(what), {}};
  if (auto value = parse_quotient(word)) {
    text = behind;
    return rounded(std::move(*value), start);
  }
  if (slash == std::string_view::npos) return {text.number(what), {}};
  const std::string_view below = word.substr(slash + 1);
  const bool is_zero = !below.empty() && below.find_first_not_of('0') == std::string_view::npos;
  start.fail_expected(is_zero && parse_integer(word.substr(0, slash)) ? "a denominator that is not zero" : what);
}

void append_coordinate(std::string& text, double x) {
  constexpr std::size_t longest = 32;
  char digits[longest];
  text.append(digits, std::to_chars(digits, digits + longest, x).ptr);
}

void append_coordinate(std::string& text, const Rational& exact, double nearest) {
  if (std::isfinite(nearest) && to_rational(nearest) == exact) return append_coordinate(text, nearest);
  text.append(exact.str());
}

}  // namespace strata::io
