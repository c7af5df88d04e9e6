#include <algorithm>

#include "strata/rational.h"

namespace strata {
namespace {

bool is_digits(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

std::optional<Integer> parse_integer(std::string_view text) {
  const bool has_sign = text.starts_with('-') || text.starts_with('+');
  if (!is_digits(has_sign ? text.substr(1) : text)) return {};
  return Integer(text);
}

std::optional<Rational> parse_quotient(std::string_view text) {
  const std::size_t slash = text.find('/');
  auto above = parse_integer(text.substr(0, slash));
  if (!above) return {};
  if (slash == std::string_view::npos) return Rational(*above);
  const std::string_view below = text.substr(slash + 1);
  if (!is_digits(below) || below.find_first_not_of('0') == std::string_view::npos) return {};
  return Rational(*above, Integer(below));
}

}  // namespace strata
