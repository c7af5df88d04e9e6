#include "strata/io/input.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <system_error>

namespace strata::io {
namespace {

struct CloseFile {
  void operator()(std::FILE* f) const { std::fclose(f); }
};

[[noreturn]] void fail_to_read(const std::filesystem::path& path, int error) {
  throw IoError(path.string(), {}, "cannot read: " + std::generic_category().message(error));
}

}  // namespace

std::uint64_t Input::line_of(std::size_t offset) const {
  std::uint64_t line = 1;
  for (std::size_t i = 0; i < std::min(offset, data.size()); ++i)
    line += data[i] == '\n' || (data[i] == '\r' && (i + 1 == data.size() || data[i + 1] != '\n'));
  return line;
}

void Input::fail_at_line(std::size_t offset, const std::string& reason) const {
  throw IoError(name, {.line = line_of(offset), .byte = {}}, reason);
}

void Input::fail_at_byte(std::size_t offset, const std::string& reason) const {
  throw IoError(name, {.line = {}, .byte = offset}, reason);
}

void Input::fail(const std::string& reason) const { throw IoError(name, {}, reason); }

FileBytes::FileBytes(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) throw IoError(path.string(), {}, "is a directory, expected a file");
  const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "rb"));
  if (!file) fail_to_read(path, errno);
  std::setvbuf(file.get(), nullptr, _IONBF, 0);
  const auto told = std::filesystem::is_regular_file(path, ignored) ? std::filesystem::file_size(path, ignored) : 0;
  // One byte more than told shows the end at the first read; files that grow or cannot tell (pipes) double.
  std::size_t capacity = (ignored ? 0 : static_cast<std::size_t>(told)) + 1;
  bytes_ = std::make_unique_for_overwrite<char[]>(capacity);
  while (const std::size_t got = std::fread(bytes_.get() + size_, 1, capacity - size_, file.get())) {
    size_ += got;
    if (size_ < capacity) continue;
    capacity = std::max<std::size_t>(2 * capacity, 1 << 16);
    auto larger = std::make_unique_for_overwrite<char[]>(capacity);
    std::memcpy(larger.get(), bytes_.get(), size_);
    bytes_ = std::move(larger);
  }
  if (std::ferror(file.get())) fail_to_read(path, errno);
}

}  // namespace strata::io
