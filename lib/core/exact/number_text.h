#pragma once
#include <array>
#include <charconv>
#include <cstddef>
#include <string>

namespace strata {

/// The longest number: "-2.2250738585072014e-308" has 24 characters.
inline constexpr std::size_t longest_number = 24;

/// The shortest digits that read back the same.
[[nodiscard]] inline std::string number_text(double x) {
  std::array<char, longest_number> text;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), x).ptr};
}

}  // namespace strata
