#pragma once
#include <charconv>
#include <concepts>
#include <version>

namespace strata::system {

#if defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 200000

/// std::from_chars for floating-point numbers, which libc++ has from version 20 on: decimal notation, "inf" and "nan".
/// The nearest number, whatever the locale.
std::from_chars_result from_chars(const char* first, const char* last, double& value);
std::from_chars_result from_chars(const char* first, const char* last, float& value);

template <std::integral Integer>
std::from_chars_result from_chars(const char* first, const char* last, Integer& value) {
  return std::from_chars(first, last, value);
}

#else

using std::from_chars;

#endif

}  // namespace strata::system
