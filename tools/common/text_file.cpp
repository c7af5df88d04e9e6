#include "common/text_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "common/byte_source.h"
#include "core/io/file.h"
#include "core/system/file.h"
#include "core/system/program.h"
#include "strata/errors.h"

namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail_writing(const std::string& path) { throw strata::IoError(path, {}, std::strerror(errno)); }

void write_and_close(std::FILE* file, const std::string& path, std::string_view text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size() && std::fflush(file) == 0;
  const int error = errno;
  const bool closed = std::fclose(file) == 0;
  if (written && closed) return;
  if (!written) errno = error;
  fail_writing(path);
}

// A path that is no regular file (a device, a pipe) is written in place, all others beside and then renamed.
void write_file(const std::string& path, std::string_view text) {
  const fs::file_status status = fs::status(path);
  const bool in_place = fs::exists(status) && !fs::is_regular_file(status);
  const std::string target = in_place ? path : fmt::format("{}.{}.part", path, strata::system::process_number());
  std::FILE* file = strata::system::open_stream(target, strata::system::FileMode::create);
  if (file == nullptr) fail_writing(path);
  try {
    write_and_close(file, path, text);
    if (in_place) return;
    std::error_code error;
    fs::rename(target, path, error);
    if (error) throw strata::IoError(path, {}, error.message());
  } catch (const strata::IoError&) {
    std::error_code ignored;
    if (!in_place) fs::remove(target, ignored);
    throw;
  }
}

}  // namespace

std::string read_file(const std::string& path) {
  return std::string(strata::io::FileBytes(strata::io::File(path)).view());
}

std::string read_text(const std::string& where, const strata::CancelToken* cancel) {
  constexpr std::size_t block = 1 << 16;
  ByteSource source(where, cancel);
  std::string text;
  while (true) {
    const std::size_t before = text.size();
    text.resize(before + block);
    const std::size_t got = source.read(text.data() + before, block);
    text.resize(before + got);
    if (got == 0) return text;
  }
}

void write_text(const std::string& where, std::string_view text) {
  if (where != "-") return write_file(where, text);
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
    fail_writing("standard output");
  }
}
