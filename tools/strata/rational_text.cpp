#include "rational_text.h"

#include <algorithm>
#include <string>

using strata::Integer;
using strata::Rational;

namespace {

bool is_digits(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// Leading zeros do not make the number octal.
Integer value_of_digits(std::string_view digits) {
  Integer integer;
  mpz_set_str(integer.backend().data(), std::string(digits).c_str(), 10);
  return integer;
}

}  // namespace

std::optional<Integer> parse_integer(std::string_view text) {
  const bool is_negative = text.starts_with('-');
  if (is_negative || text.starts_with('+')) text.remove_prefix(1);
  if (!is_digits(text)) return {};
  const Integer size = value_of_digits(text);
  return is_negative ? Integer(-size) : size;
}

std::optional<Rational> parse_quotient(std::string_view text) {
  const std::size_t slash = text.find('/');
  const auto above = parse_integer(text.substr(0, slash));
  if (!above) return {};
  if (slash == text.npos) return Rational(*above);
  const std::string_view below = text.substr(slash + 1);
  if (!is_digits(below) || value_of_digits(below) == 0) return {};
  return Rational(*above, value_of_digits(below));
}
