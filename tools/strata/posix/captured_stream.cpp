#include "captured_stream.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>

#include "captured_text.h"

CapturedStream::CapturedStream() {
  std::string name = (std::filesystem::temp_directory_path() / "strata-XXXXXX").string();  // mkstemp fills the end in
  descriptor_ = mkstemp(name.data());
  if (descriptor_ < 0) throw std::system_error(errno, std::generic_category(), name);
  unlink(name.c_str());
  fcntl(descriptor_, F_SETFD, FD_CLOEXEC);
  fcntl(descriptor_, F_SETFL, O_APPEND);
}

CapturedStream::~CapturedStream() { close(descriptor_); }

void CapturedStream::replace(int stream) const { dup2(descriptor_, stream); }

std::string CapturedStream::take() const {
  struct stat facts = {};
  if (fstat(descriptor_, &facts) != 0 || facts.st_size == 0) return {};
  std::string text = captured_text(static_cast<std::size_t>(facts.st_size), [&](std::size_t offset, std::size_t size) {
    std::string bytes(size, '\0');
    const ::ssize_t got = pread(descriptor_, bytes.data(), size, static_cast<::off_t>(offset));
    bytes.resize(static_cast<std::size_t>(std::max<::ssize_t>(got, 0)));
    return bytes;
  });
  clear();
  return text;
}

void CapturedStream::clear() const {
  if (ftruncate(descriptor_, 0) != 0) throw std::system_error(errno, std::generic_category(), "ftruncate");
}
