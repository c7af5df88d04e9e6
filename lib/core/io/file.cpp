#include "core/io/file.h"

#include <fcntl.h>
#include <tbb/parallel_for.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "core/containers/huge_pages.h"
#include "strata/errors.h"

namespace strata::io {
namespace {

/// Reads the first bytes in parallel. False when the file is shorter than expected.
bool read_in_parts(const File& file, char* bytes, std::size_t size) {
  constexpr std::size_t part = std::size_t{1} << 21;
  std::atomic<bool> whole = true;
  tbb::parallel_for(std::size_t{0}, (size + part - 1) / part, [&](std::size_t i) {
    const std::size_t first = i * part, wanted = std::min(part, size - first);
    if (file.read_at(first, bytes + first, wanted) < wanted) whole = false;
  });
  return whole;
}

}  // namespace

File::File(const std::filesystem::path& path) : name_(path.string()) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) throw IoError(name_, {}, "is a directory, expected a file");
  descriptor_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor_ < 0) fail(errno);
  if (!std::filesystem::is_regular_file(path, ignored)) return;
  const auto told = std::filesystem::file_size(path, ignored);
  size_ = ignored ? 0 : static_cast<std::size_t>(told);
}

File::~File() { ::close(descriptor_); }

template <class Call>
std::size_t File::retried(const Call& call) const {
  while (true) {
    const ::ssize_t got = call();
    if (got >= 0) return static_cast<std::size_t>(got);
    if (errno != EINTR) fail(errno);
  }
}

std::size_t File::read_at(std::size_t offset, char* to, std::size_t size) const {
  std::size_t done = 0;
  while (done < size) {
    const std::size_t got =
        retried([&] { return ::pread(descriptor_, to + done, size - done, static_cast<::off_t>(offset + done)); });
    if (got == 0) break;
    done += got;
  }
  return done;
}

std::size_t File::read(char* to, std::size_t size) const {
  return retried([&] { return ::read(descriptor_, to, size); });
}

void File::go_to(std::size_t offset) const {
  if (::lseek(descriptor_, static_cast<::off_t>(offset), SEEK_SET) < 0) fail(errno);
}

void File::fail(int error) const { throw IoError(name_, {}, "cannot read: " + std::generic_category().message(error)); }

FileBytes::FileBytes(const File& file) {
  // One byte more than the reported size, so that the next read finds the end. The buffer doubles for files that grow
  // or have no size.
  std::size_t capacity = file.size() + 1;
  bytes_ = std::make_unique_for_overwrite<char[]>(capacity);
  prefer_huge_pages(bytes_.get(), capacity);
  if (file.size() > 0 && read_in_parts(file, bytes_.get(), file.size())) file.go_to(size_ = file.size());
  while (const std::size_t got = file.read(bytes_.get() + size_, capacity - size_)) {
    size_ += got;
    if (size_ < capacity) continue;
    capacity = std::max<std::size_t>(2 * capacity, 1 << 16);
    auto larger = std::make_unique_for_overwrite<char[]>(capacity);
    std::memcpy(larger.get(), bytes_.get(), size_);
    bytes_ = std::move(larger);
  }
}

}  // namespace strata::io
