#include "captured_stream.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

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

std::string CapturedStream::part(long long offset, long long size) const {
  std::string text(static_cast<std::size_t>(size), '\0');
  const ::ssize_t got = pread(descriptor_, text.data(), text.size(), offset);
  text.resize(static_cast<std::size_t>(std::max<::ssize_t>(got, 0)));
  return text;
}

std::string CapturedStream::take() const {
  constexpr long long most = 4096;  // of the beginning, and of the end
  struct stat facts = {};
  if (fstat(descriptor_, &facts) != 0 || facts.st_size == 0) return {};
  const long long size = facts.st_size;
  std::string text = size <= 2 * most
                         ? part(0, size)
                         : fmt::format("{}\n[{} bytes]\n{}", part(0, most), size - 2 * most, part(size - most, most));
  clear();
  return text;
}

void CapturedStream::clear() const {
  if (ftruncate(descriptor_, 0) != 0) throw std::system_error(errno, std::generic_category(), "ftruncate");
}
