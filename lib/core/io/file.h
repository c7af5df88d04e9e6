#pragma once
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "core/io/pieces.h"

namespace strata::io {

/// A file that is open for reading. Its bytes are copied and not mapped, so a file that is changed or truncated
/// meanwhile is at worst malformed. Every failure is an IoError.
class File {
 public:
  /// Throws: no such file, a directory, no permission.
  explicit File(const std::filesystem::path& path);
  ~File();
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  [[nodiscard]] const std::string& name() const { return name_; }
  /// Bytes of a regular file; 0 where the size is unknown (pipes).
  [[nodiscard]] std::size_t size() const { return size_; }
  /// Copies bytes, up to the end of the file; returns how many. Thread-safe. Requires a regular file.
  std::size_t read_at(std::size_t offset, char* to, std::size_t size) const;
  /// Copies the next bytes, at most `size`; 0 at the end.
  std::size_t read(char* to, std::size_t size) const;
  /// Sets the position of the next read().
  void go_to(std::size_t offset) const;

 private:
  [[noreturn]] void fail(int error) const;

  std::string name_;
  int descriptor_;
  std::size_t size_ = 0;
};

/// All bytes of a file. Parts of large files are read in parallel.
class FileBytes {
 public:
  explicit FileBytes(const File& file);
  [[nodiscard]] std::string_view view() const { return {bytes_.get(), size_}; }

 private:
  std::unique_ptr<char[]> bytes_;
  std::size_t size_ = 0;
};

}  // namespace strata::io
