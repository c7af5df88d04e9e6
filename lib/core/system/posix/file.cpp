#include "core/system/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

namespace strata::system {
namespace {

template <class Call>
auto retried(const Call& call) {
  auto done = call();
  while (done < 0 && errno == EINTR) done = call();
  return done;
}

}  // namespace

std::FILE* open_stream(const std::filesystem::path& path, FileMode mode) {
  return std::fopen(path.c_str(), mode == FileMode::update ? "r+b" : mode == FileMode::create ? "wb" : "wbx");
}

int open_to_read(const std::filesystem::path& path) { return ::open(path.c_str(), O_RDONLY | O_CLOEXEC); }

int open_to_write(const std::filesystem::path& path, bool append) {
  return ::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | (append ? O_APPEND : O_TRUNC), 0666);
}

void close(int descriptor) { ::close(descriptor); }

std::ptrdiff_t read(int descriptor, char* to, std::size_t size) {
  return retried([&] { return ::read(descriptor, to, size); });
}

std::ptrdiff_t read_at(int descriptor, std::uint64_t offset, char* to, std::size_t size) {
  return retried([&] { return ::pread(descriptor, to, size, static_cast<::off_t>(offset)); });
}

std::ptrdiff_t write(int descriptor, const char* bytes, std::size_t size) {
  return retried([&] { return ::write(descriptor, bytes, size); });
}

bool go_to(int descriptor, std::uint64_t offset) {
  return ::lseek(descriptor, static_cast<::off_t>(offset), SEEK_SET) >= 0;
}

std::uint64_t size_of(int descriptor) {
  struct stat facts = {};
  return ::fstat(descriptor, &facts) == 0 && S_ISREG(facts.st_mode) ? static_cast<std::uint64_t>(facts.st_size) : 0;
}

}  // namespace strata::system
