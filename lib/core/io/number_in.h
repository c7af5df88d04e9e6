#pragma once
#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

#include "core/system/decimal.h"

namespace strata::io {

/// The number that a word is, in decimal notation; `nan` and `inf` are numbers. Nothing for other words, and for
/// numbers beyond the range of T.
template <class T>
[[nodiscard]] std::optional<T> number_in(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  T number{};
  const auto [end, error] = system::from_chars(word.data(), word.data() + word.size(), number);
  if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
  return number;
}

}  // namespace strata::io
