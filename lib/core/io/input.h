#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "strata/errors.h"

namespace strata::io {

/// An error in the bytes of a file, with its offset. It becomes an IoError when it is reported; lines are counted only
/// then.
struct Malformed {
  enum class Unit { none, line, byte };

  std::string reason;
  Unit unit = Unit::none;
  std::size_t offset = 0;
};

/// Bytes that one task reads: few enough for a core's cache.
inline constexpr std::size_t usual_piece = std::size_t{1} << 19;

/// A whole file in memory, and its name for messages.
struct Input {
  std::string name;
  std::string_view data;
  std::size_t piece = usual_piece;  ///< results do not depend on it

  /// 1 + the number of line ends (LF, CR LF or CR) before the offset.
  [[nodiscard]] std::uint64_t line_of(std::size_t offset) const;
  [[nodiscard]] IoError error(const Malformed& malformed) const;
};

/// A word for an error: in quotes, 32 bytes at most.
[[nodiscard]] std::string quoted(std::string_view word);

[[noreturn]] inline void fail(std::string reason) { throw Malformed{std::move(reason)}; }
[[noreturn]] inline void fail_at_line(std::size_t offset, std::string reason) {
  throw Malformed{std::move(reason), Malformed::Unit::line, offset};
}
[[noreturn]] inline void fail_at_byte(std::size_t offset, std::string reason) {
  throw Malformed{std::move(reason), Malformed::Unit::byte, offset};
}

}  // namespace strata::io
