#include "common/rational_text.h"

#include <algorithm>
#include <string>

using strata::Integer;
using strata::Rational;

namespace {

bool is_digits(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

std::optional<Integer> parse_integer(std::string_view text) {
  const std::string_view digits = text.starts_with('-') || text.starts_with('+') ? text.substr(1) : text;
  if (!is_digits(digits)) return {};
  return Integer(text);
}

std::optional<Rational> parse_quotient(std::string_view text) {
  const std::size_t slash = text.find('/');
  const auto above = parse_integer(text.substr(0, slash));
  if (!above) return {};
  if (slash == text.npos) return Rational(*above);
  const std::string_view below = text.substr(slash + 1);
  if (!is_digits(below) || Integer(below) == 0) return {};
  return Rational(*above, Integer(below));
}
