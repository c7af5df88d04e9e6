#include "core/system/file.h"

#include <fcntl.h>
#include <io.h>
#include <share.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>

#include "core/system/windows/api.h"

namespace strata::system {
namespace {

/// The C library's calls take lengths of 31 bits.
unsigned at_most(std::size_t size) { return static_cast<unsigned>(std::min<std::size_t>(size, std::size_t{1} << 30)); }

int open(const std::filesystem::path& path, int flags) {
  int descriptor = -1;
  const int failed =
      ::_wsopen_s(&descriptor, path.c_str(), flags | _O_BINARY | _O_NOINHERIT, _SH_DENYNO, _S_IREAD | _S_IWRITE);
  if (failed != 0) errno = failed;
  return failed != 0 ? -1 : descriptor;
}

HANDLE handle_of(int descriptor) { return reinterpret_cast<HANDLE>(::_get_osfhandle(descriptor)); }

}  // namespace

std::FILE* open_stream(const std::filesystem::path& path, FileMode mode) {
  const int flags = mode == FileMode::update   ? _O_RDWR
                    : mode == FileMode::create ? _O_WRONLY | _O_CREAT | _O_TRUNC
                                               : _O_WRONLY | _O_CREAT | _O_EXCL;
  const int descriptor = open(path, flags);
  if (descriptor < 0) return nullptr;
  std::FILE* stream = ::_fdopen(descriptor, mode == FileMode::update ? "r+b" : "wb");
  if (stream == nullptr) ::_close(descriptor);
  return stream;
}

int open_to_read(const std::filesystem::path& path) { return open(path, _O_RDONLY | _O_SEQUENTIAL); }

int open_to_write(const std::filesystem::path& path, bool append) {
  return open(path, _O_WRONLY | _O_CREAT | (append ? _O_APPEND : _O_TRUNC));
}

void close(int descriptor) { ::_close(descriptor); }

std::ptrdiff_t read(int descriptor, char* to, std::size_t size) { return ::_read(descriptor, to, at_most(size)); }

std::ptrdiff_t read_at(int descriptor, std::uint64_t offset, char* to, std::size_t size) {
  OVERLAPPED place = {};
  place.Offset = static_cast<DWORD>(offset);
  place.OffsetHigh = static_cast<DWORD>(offset >> 32);
  DWORD done = 0;
  if (::ReadFile(handle_of(descriptor), to, at_most(size), &done, &place) != 0) return done;
  if (::GetLastError() == ERROR_HANDLE_EOF) return 0;
  errno = EIO;
  return -1;
}

std::ptrdiff_t write(int descriptor, const char* bytes, std::size_t size) {
  return ::_write(descriptor, bytes, at_most(size));
}

bool go_to(int descriptor, std::uint64_t offset) {
  return ::_lseeki64(descriptor, static_cast<long long>(offset), SEEK_SET) >= 0;
}

std::uint64_t size_of(int descriptor) {
  LARGE_INTEGER size = {};
  const HANDLE handle = handle_of(descriptor);
  if (::GetFileType(handle) != FILE_TYPE_DISK || ::GetFileSizeEx(handle, &size) == 0) return 0;
  return static_cast<std::uint64_t>(size.QuadPart);
}

}  // namespace strata::system
