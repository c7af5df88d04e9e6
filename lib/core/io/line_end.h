#pragma once
#include <cstdint>
#include <cstring>

namespace strata::io {

/// The first LF or CR in a text, or its end. Eight characters at a time.
inline const char* find_line_end(const char* at, const char* end) {
  constexpr std::uint64_t ones = 0x0101010101010101, tops = 0x8080808080808080;
  // The top bit of a byte of the result is set when that byte of x is zero; bytes above the lowest zero may be set by
  // mistake.
  const auto zeros = [](std::uint64_t x) { return (x - ones) & ~x & tops; };
  for (; end - at >= 8; at += 8) {
    std::uint64_t x;
    std::memcpy(&x, at, 8);
    if ((zeros(x ^ ('\n' * ones)) | zeros(x ^ ('\r' * ones))) != 0) break;
  }
  while (at != end && *at != '\n' && *at != '\r') ++at;
  return at;
}

/// The position after the line end at `at`: LF, CR LF or CR.
inline const char* behind_line_end(const char* at, const char* end) {
  const bool is_return = *at == '\r';
  ++at;
  return is_return && at != end && *at == '\n' ? at + 1 : at;
}

}  // namespace strata::io
