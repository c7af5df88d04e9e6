#include "core/system/streams.h"

#include <fcntl.h>
#include <io.h>

#include <random>
#include <string>
#include <system_error>

#include "core/system/windows/api.h"

namespace strata::system {
namespace {

HANDLE handle_of(int descriptor) { return reinterpret_cast<HANDLE>(::_get_osfhandle(descriptor)); }

}  // namespace

// Pipes can be looked into; consoles and files give something, or wait in read().
bool wait_to_read(int descriptor, int milliseconds) {
  const HANDLE handle = handle_of(descriptor);
  if (::GetFileType(handle) != FILE_TYPE_PIPE) return true;
  constexpr int step = 5;
  for (int waited = 0; waited < milliseconds; waited += step) {
    DWORD there = 0;
    if (::PeekNamedPipe(handle, nullptr, 0, nullptr, &there, nullptr) == 0 || there > 0) return true;
    ::Sleep(step);
  }
  return false;
}

bool is_terminal(int descriptor) {
  DWORD mode = 0;
  return ::GetConsoleMode(handle_of(descriptor), &mode) != 0;
}

void use_binary_streams() {
  for (const int stream : {standard_input, standard_output}) ::_setmode(stream, _O_BINARY);
  ::SetConsoleOutputCP(CP_UTF8);
  DWORD mode = 0;  // colours
  const HANDLE console = ::GetStdHandle(STD_ERROR_HANDLE);
  if (::GetConsoleMode(console, &mode) != 0) ::SetConsoleMode(console, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
}

// Folders for temporary files are the user's own there.
std::filesystem::path make_scratch_folder() {
  namespace fs = std::filesystem;
  constexpr int most_attempts = 1000;
  std::random_device random;
  for (int i = 0; i < most_attempts; ++i) {
    const fs::path folder = fs::temp_directory_path() / ("strata-" + std::to_string(random()));
    if (fs::create_directory(folder)) return folder;
  }
  throw fs::filesystem_error("no folder for temporary files", fs::temp_directory_path(),
                             std::make_error_code(std::errc::file_exists));
}

int duplicate(int descriptor) { return ::_dup(descriptor); }

}  // namespace strata::system
