#pragma once
#include <fmt/format.h>

#include <cstdio>
#include <utility>

/// Writes to standard error. What cannot be written there, as when nobody reads it any more, is lost: that is no reason
/// to end, nor can it be told.
template <class... Values>
void tell(fmt::format_string<Values...> text, Values&&... values) {
  std::fputs(fmt::format(text, std::forward<Values>(values)...).c_str(), stderr);
}
