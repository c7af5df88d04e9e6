#include "verify/decimal.h"

#include <fmt/format.h>

#include <cctype>
#include <cstdlib>

namespace verify {
namespace {

using strata::Integer;
using strata::Rational;

constexpr int digit_count = 15;
constexpr long largest_exponent = 999'999;  // of the first digit: what is read can be written and read again

Rational power_of_ten(long exponent) {
  const Integer power = boost::multiprecision::pow(Integer(10), static_cast<unsigned>(std::labs(exponent)));
  return exponent >= 0 ? Rational(power) : Rational(Integer(1), power);
}

/// The exponent e with 10^e <= q < 10^(e + 1), for q > 0.
long decimal_exponent(const Rational& q) {
  const long bits = static_cast<long>(msb(numerator(q))) - static_cast<long>(msb(denominator(q)));
  long exponent = bits * 30103 / 100000;
  while (q < power_of_ten(exponent)) --exponent;
  while (q >= power_of_ten(exponent + 1)) ++exponent;
  return exponent;
}

bool is_integer(std::string_view text) {
  if (!text.empty() && (text[0] == '-' || text[0] == '+')) text.remove_prefix(1);
  if (text.empty()) return false;
  for (const char c : text)
    if (std::isdigit(static_cast<unsigned char>(c)) == 0) return false;
  return true;
}

/// Without a sign "+", which GMP does not read.
Integer integer_of(std::string_view text) {
  if (text[0] == '+') text.remove_prefix(1);
  const bool negative = text[0] == '-';
  if (negative) text.remove_prefix(1);
  const std::size_t first = text.find_first_not_of('0');  // a leading 0 would mean octal
  const Integer magnitude = first == text.npos ? Integer(0) : Integer(std::string(text.substr(first)));
  return negative ? Integer(-magnitude) : magnitude;
}

std::optional<Rational> parse_decimal(std::string_view text) {
  const std::size_t e = text.find_first_of("eE");
  long exponent = 0;
  if (e != text.npos) {
    const std::string_view digits = text.substr(e + 1);
    if (!is_integer(digits) || digits.size() > 8) return {};
    exponent = std::strtol(std::string(digits).c_str(), nullptr, 10);
    text = text.substr(0, e);
  }
  std::string mantissa(text);
  if (const std::size_t point = mantissa.find('.'); point != mantissa.npos) {
    exponent -= static_cast<long>(mantissa.size() - point - 1);
    mantissa.erase(point, 1);
    if (text.find_first_of("+-", point) != text.npos) return {};
  }
  if (!is_integer(mantissa)) return {};
  const std::size_t first = mantissa.find_first_of("123456789");
  if (first == mantissa.npos) return Rational(0);
  const long leading = exponent + static_cast<long>(mantissa.size() - first) - 1;
  if (std::labs(leading) >= largest_exponent) return {};
  return Rational(integer_of(mantissa)) * power_of_ten(exponent);
}

}  // namespace

std::string decimal(const Rational& q) {
  if (q == 0) return "0";
  const Rational magnitude = abs(q);
  long exponent = decimal_exponent(magnitude);
  const Rational scaled = magnitude * power_of_ten(digit_count - 1 - exponent) + Rational(1, 2);
  std::string digits = Integer(numerator(scaled) / denominator(scaled)).str();
  if (digits.size() > digit_count) ++exponent;
  digits.resize(digits.find_last_not_of('0') + 1);
  const std::string sign = q < 0 ? "-" : "";
  if (exponent < -5 || exponent >= digit_count) {
    const std::string rest = digits.substr(1);
    return fmt::format("{}{}{}{}e{}", sign, digits[0], rest.empty() ? "" : ".", rest, exponent);
  }
  if (exponent < 0)
    return fmt::format("{}0.{}{}", sign, std::string(static_cast<std::size_t>(-exponent - 1), '0'), digits);
  const auto whole = static_cast<std::size_t>(exponent) + 1;
  if (digits.size() <= whole) return fmt::format("{}{}{}", sign, digits, std::string(whole - digits.size(), '0'));
  return fmt::format("{}{}.{}", sign, digits.substr(0, whole), digits.substr(whole));
}

std::optional<Rational> parse_rational(std::string_view text) {
  const std::size_t slash = text.find('/');
  if (slash == text.npos) return parse_decimal(text);
  const std::string_view above = text.substr(0, slash), below = text.substr(slash + 1);
  if (!is_integer(above) || !is_integer(below) || integer_of(below) <= 0) return {};
  return Rational(integer_of(above), integer_of(below));
}

}  // namespace verify
