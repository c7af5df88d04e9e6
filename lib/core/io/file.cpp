#include "core/io/file.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "core/containers/huge_pages.h"
#include "core/system/file.h"
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
  descriptor_ = system::open_to_read(path);
  if (descriptor_ < 0) fail(errno);
  size_ = static_cast<std::size_t>(system::size_of(descriptor_));
}

File::~File() { system::close(descriptor_); }

std::size_t File::read_at(std::size_t offset, char* to, std::size_t size) const {
  std::size_t done = 0;
  while (done < size) {
    const std::ptrdiff_t got = system::read_at(descriptor_, offset + done, to + done, size - done);
    if (got < 0) fail(errno);
    if (got == 0) break;
    done += static_cast<std::size_t>(got);
  }
  return done;
}

std::size_t File::read(char* to, std::size_t size) const {
  const std::ptrdiff_t got = system::read(descriptor_, to, size);
  if (got < 0) fail(errno);
  return static_cast<std::size_t>(got);
}

void File::go_to(std::size_t offset) const {
  if (!system::go_to(descriptor_, offset)) fail(errno);
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
