#include "core/system/decimal.h"

#if defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 200000

#include <locale.h>
#include <stdlib.h>
#if defined(__APPLE__)
#include <xlocale.h>
#endif

#include <cmath>
#include <initializer_list>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>

namespace strata::system {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The locale of the language C, which lives as long as the process.
locale_t plain_locale() {
  static const locale_t locale = ::newlocale(LC_ALL_MASK, "C", nullptr);
  return locale;
}

/// The end of the number that begins at `at`, without its sign; `at` where there is none. `has_value`: is a digit not
/// 0?
const char* end_of_number(const char* at, const char* last, bool& has_value) {
  const std::string_view text(at, static_cast<std::size_t>(last - at));
  for (const std::string_view name : {"infinity", "inf", "nan"}) {
    bool is_it = text.size() >= name.size();
    for (std::size_t k = 0; is_it && k < name.size(); ++k) is_it = (text[k] | 0x20) == name[k];
    has_value = true;
    if (is_it) return at + name.size();
  }
  has_value = false;
  bool has_digits = false, has_point = false;
  const char* end = at;
  for (; end != last && (is_digit(*end) || (*end == '.' && !has_point)); ++end) {
    has_point = has_point || *end == '.';
    has_digits = has_digits || is_digit(*end);
    has_value = has_value || (is_digit(*end) && *end != '0');
  }
  if (!has_digits) return at;
  if (end == last || (*end | 0x20) != 'e') return end;
  const char* exponent = end + 1;
  if (exponent != last && (*exponent == '-' || *exponent == '+')) ++exponent;
  if (exponent == last || !is_digit(*exponent)) return end;
  while (exponent != last && is_digit(*exponent)) ++exponent;
  return exponent;
}

template <class Number>
std::from_chars_result read(const char* first, const char* last, Number& value) {
  const char* const digits = first != last && *first == '-' ? first + 1 : first;
  bool has_value = false;
  const char* const end = end_of_number(digits, last, has_value);
  if (end == digits) return {first, std::errc::invalid_argument};
  const std::string word(first, end);
  Number number = 0;
  if constexpr (std::is_same_v<Number, float>) {
    number = ::strtof_l(word.c_str(), nullptr, plain_locale());
  } else {
    number = ::strtod_l(word.c_str(), nullptr, plain_locale());
  }
  const bool is_named = !is_digit(*digits) && *digits != '.';
  if (!is_named && (std::isinf(number) || (number == 0 && has_value))) return {end, std::errc::result_out_of_range};
  value = number;
  return {end, std::errc{}};
}

}  // namespace

std::from_chars_result from_chars(const char* first, const char* last, double& value) {
  return read(first, last, value);
}
std::from_chars_result from_chars(const char* first, const char* last, float& value) {
  return read(first, last, value);
}

}  // namespace strata::system

#endif
