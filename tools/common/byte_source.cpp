#include "common/byte_source.h"

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "core/system/file.h"
#include "core/system/streams.h"
#include "strata/errors.h"

using strata::system::standard_input;

ByteSource::ByteSource(const std::string& path, const strata::CancelToken* cancel)
    : name_(path == "-" ? "standard input" : path), cancel_(cancel) {
  descriptor_ = path == "-" ? standard_input : strata::system::open_to_read(path);
  if (descriptor_ < 0) fail(errno);
  size_ = strata::system::size_of(descriptor_);
}

ByteSource::~ByteSource() {
  if (descriptor_ > standard_input) strata::system::close(descriptor_);
}

std::size_t ByteSource::read(char* to, std::size_t size) {
  if (!back_.empty()) {
    const std::size_t taken = back_.copy(to, size);
    back_.erase(0, taken);
    return taken;
  }
  wait();
  const std::ptrdiff_t got = strata::system::read(descriptor_, to, size);
  if (got < 0) fail(errno);
  done_ += static_cast<std::uint64_t>(got);
  return static_cast<std::size_t>(got);
}

void ByteSource::put_back(const std::string& bytes) { back_.insert(0, bytes); }

double ByteSource::fraction() const {
  return size_ == 0 ? 0 : std::min(1.0, static_cast<double>(done_) / static_cast<double>(size_));
}

/// Until there is something to read, or the end.
void ByteSource::wait() const {
  constexpr int patience = 100;  // milliseconds between looks at the token
  do {
    if (cancel_ != nullptr && cancel_->is_cancelled()) throw strata::Cancelled("cancelled while reading " + name_);
  } while (!strata::system::wait_to_read(descriptor_, patience));
}

void ByteSource::fail(int error) const {
  throw strata::IoError(name_, {}, "cannot read: " + std::generic_category().message(error));
}
