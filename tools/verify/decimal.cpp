#include "verify/decimal.h"

#include <fmt/format.h>

#include <cstdlib>

#include "strata/rational.h"

namespace verify {
namespace {

using strata::Integer;
using strata::Rational;

constexpr int digit_count = 15;
constexpr long largest_exponent = 999'999;  // of the first digit: what is read can be written and read again

Rational power_of_ten(long exponent) {
  const Integer power = pow(Integer(10), static_cast<unsigned>(std::labs(exponent)));
  return exponent >= 0 ? Rational(power) : Rational(Integer(1), power);
}

/// The exponent e with 10^e <= q < 10^(e + 1), for q > 0.
long decimal_exponent(const Rational& q) {
  const long bits = static_cast<long>(bit_length(numerator(q))) - static_cast<long>(bit_length(denominator(q)));
  long exponent = bits * 30103 / 100000;
  while (q < power_of_ten(exponent)) --exponent;
  while (q >= power_of_ten(exponent + 1)) ++exponent;
  return exponent;
}

std::optional<Rational> parse_decimal(std::string_view text) {
  const std::size_t e = text.find_first_of("eE");
  long exponent = 0;
  if (e != text.npos) {
    const std::string_view digits = text.substr(e + 1);
    const auto value = strata::parse_integer(digits);
    if (!value || digits.size() > 8) return {};
    exponent = static_cast<long>(value->to_int64());
    text = text.substr(0, e);
  }
  std::string mantissa(text);
  if (const std::size_t point = mantissa.find('.'); point != mantissa.npos) {
    exponent -= static_cast<long>(mantissa.size() - point - 1);
    mantissa.erase(point, 1);
    if (text.find_first_of("+-", point) != text.npos) return {};
  }
  const auto digits = strata::parse_integer(mantissa);
  if (!digits) return {};
  const std::size_t first = mantissa.find_first_of("123456789");
  if (first == mantissa.npos) return Rational(0);
  const long leading = exponent + static_cast<long>(mantissa.size() - first) - 1;
  if (std::labs(leading) >= largest_exponent) return {};
  return Rational(*digits) * power_of_ten(exponent);
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
  if (const auto quotient = strata::parse_quotient(text)) return quotient;
  return parse_decimal(text);
}

}  // namespace verify
