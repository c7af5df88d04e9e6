#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "strata/io/io_error.h"

namespace strata::io {

/// A whole file in memory, and its name for messages.
struct Input {
  std::string name;
  std::string_view data;

  /// 1 + the number of line ends (LF, CR LF or CR) before the offset.
  [[nodiscard]] std::uint64_t line_of(std::size_t offset) const;
  [[noreturn]] void fail_at_line(std::size_t offset, const std::string& reason) const;
  [[noreturn]] void fail_at_byte(std::size_t offset, const std::string& reason) const;
  [[noreturn]] void fail(const std::string& reason) const;
};

/// The bytes of a file, read at once.
class FileBytes {
 public:
  /// Throws IoError: no such file, a directory, no permission, a read error.
  explicit FileBytes(const std::filesystem::path& path);
  [[nodiscard]] std::string_view view() const { return {bytes_.get(), size_}; }

 private:
  std::unique_ptr<char[]> bytes_;
  std::size_t size_ = 0;
};

}  // namespace strata::io
