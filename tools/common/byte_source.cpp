#include "common/byte_source.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "strata/errors.h"

ByteSource::ByteSource(const std::string& path, const strata::CancelToken* cancel)
    : name_(path == "-" ? "standard input" : path), cancel_(cancel) {
  descriptor_ = path == "-" ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor_ < 0) fail(errno);
  struct stat facts = {};
  if (::fstat(descriptor_, &facts) != 0) return;
  if (S_ISREG(facts.st_mode)) size_ = static_cast<std::uint64_t>(facts.st_size);
}

ByteSource::~ByteSource() {
  if (descriptor_ > STDIN_FILENO) ::close(descriptor_);
}

std::size_t ByteSource::read(char* to, std::size_t size) {
  if (!back_.empty()) {
    const std::size_t taken = back_.copy(to, size);
    back_.erase(0, taken);
    return taken;
  }
  while (true) {
    wait();
    const ::ssize_t got = ::read(descriptor_, to, size);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail(errno);
    done_ += static_cast<std::uint64_t>(got);
    return static_cast<std::size_t>(got);
  }
}

void ByteSource::put_back(std::string bytes) { back_.insert(0, bytes); }

double ByteSource::fraction() const {
  return size_ == 0 ? 0 : std::min(1.0, static_cast<double>(done_) / static_cast<double>(size_));
}

/// Until there is something to read, or the end.
void ByteSource::wait() const {
  constexpr int patience = 100;  // milliseconds between looks at the token
  pollfd ready = {descriptor_, POLLIN, 0};
  int seen = 0;
  do {
    if (cancel_ != nullptr && cancel_->is_cancelled()) throw strata::Cancelled("cancelled while reading " + name_);
    seen = ::poll(&ready, 1, patience);
  } while (seen == 0 || (seen < 0 && errno == EINTR));
}

void ByteSource::fail(int error) const {
  throw strata::IoError(name_, {}, "cannot read: " + std::generic_category().message(error));
}
