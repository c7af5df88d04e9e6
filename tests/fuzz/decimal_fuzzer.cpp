// Numbers as text, in cases and expectations.
#include <algorithm>
#include <cstdlib>
#include <optional>
#include <string>

#include "fuzz.h"
#include "verify/decimal.h"

namespace strata::fuzz {
namespace {

/// Takes digits from the front; how many.
std::size_t take_digits(std::string_view& text) {
  const std::size_t count = std::min(text.find_first_not_of("0123456789"), text.size());
  text.remove_prefix(count);
  return count;
}

bool take_any(std::string_view& text, std::string_view characters) {
  if (text.empty() || characters.find(text[0]) == characters.npos) return false;
  text.remove_prefix(1);
  return true;
}

/// [+-] digits [. digits] [e [+-] digits], digits on one side of the point at least; or [+-] digits / [+] digits.
bool is_number(std::string_view text) {
  (void)take_any(text, "+-");
  const std::size_t whole = take_digits(text);
  if (whole > 0 && take_any(text, "/")) {
    (void)take_any(text, "+");
    return take_digits(text) > 0 && text.empty();
  }
  const std::size_t rest = take_any(text, ".") ? take_digits(text) : 0;
  if (take_any(text, "eE")) {
    (void)take_any(text, "+-");
    if (take_digits(text) == 0) return false;
  }
  return whole + rest > 0 && text.empty();
}

/// Relative errors of 15 digits are up to 5e-15.
void check_digits(const Rational& value) {
  const std::string digits = verify::decimal(value);
  const std::optional<Rational> again = verify::parse_rational(digits);
  require(again.has_value(), "what is written can be read");
  require(abs(*again - value) * 200'000'000'000'000 <= abs(value), "15 digits are right");
  require(verify::decimal(*again) == digits, "what was written is written again");
}

void check(std::string_view text) {
  const std::optional<Rational> value = verify::parse_rational(text);
  if (!value) return;
  require(is_number(text), "what is read is a number");
  if (text.find('/') == text.npos)
    require(to_nearest_double(*value) == std::strtod(std::string(text).c_str(), nullptr),
            "the value is what the C library says");
  check_digits(*value);
}

}  // namespace
}  // namespace strata::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return strata::fuzz::run(data, size, strata::fuzz::check);
}
