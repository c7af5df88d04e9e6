#include "core/io/xoff_number.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>

namespace strata::io {
namespace {

bool is_digits(std::string_view word) {
  return !word.empty() && std::all_of(word.begin(), word.end(), [](char c) { return c >= '0' && c <= '9'; });
}

std::string_view without_sign(std::string_view word) {
  return !word.empty() && (word[0] == '-' || word[0] == '+') ? word.substr(1) : word;
}

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
  const std::string_view numerator = word.substr(0, slash);
  const bool is_integer = is_digits(without_sign(numerator));
  if (slash == std::string_view::npos && (!is_integer || word.size() <= few)) return {text.number(what), {}};
  text = behind;
  if (slash == std::string_view::npos) return rounded(Rational(Integer(word)), start);
  const std::string_view denominator = word.substr(slash + 1);
  if (!is_integer || !is_digits(denominator)) start.fail_expected(what);
  if (denominator.find_first_not_of('0') == std::string_view::npos)
    start.fail_expected("a denominator that is not zero");
  return rounded(Rational(Integer(numerator), Integer(denominator)), start);
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
